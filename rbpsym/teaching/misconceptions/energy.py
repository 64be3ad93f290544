"""Misconceptions about work and energy: what is left out, what is kept, which work belongs to which energy."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from rbpsym.algebra import NOTHING, ORIGIN, Scalar, is_zero
from rbpsym.derivation.step import BodyRef
from rbpsym.mechanics.motion import ForceWork, Work
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.quantities import NUMBER
from rbpsym.statement.model import Element
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import ENERGY, WELL, WORKS, Misconception, Site
from rbpsym.teaching.targets import axes


def _no_rotational_energy(study: Study) -> Iterator[Site]:
    """½ M V² is all: the works of the whole give the speed of the centre of mass."""
    if study.potential is None or not study.kinetic[1]:
        return
    kept = {"system": study.system, "dynamics": study.dynamics, "kinetic": (study.kinetic[0], NOTHING)}
    energy = study.kinetic[0] + study.potential
    yield Site({}, lambda: change.with_parts(study, **kept, first_integral=energy))


def _losses(element: Element) -> bool:
    return element.kind in ("damper", "rotary-damper") or element.values.get("coefficient") is not None


def _energy_kept(study: Study) -> Iterator[Site]:
    """Energy kept though a bearing, a damper or friction takes some."""
    problem = study.problem
    if any(map(_losses, problem.elements)):
        yield Site({}, lambda: change.with_elements(study, _lossless))


def _lossless(element: Element) -> Element | None:
    if element.kind in ("damper", "rotary-damper"):
        return None
    return element.with_values(coefficient=None) if element.values.get("coefficient") is not None else element


def _start_forgotten(study: Study) -> Iterator[Site]:
    """The kinetic energy that it has at the start is left out."""
    moving = [c for c in study.problem.coordinates if change.is_nonzero(c.speed)]
    if not moving:
        return

    def wrong() -> Study:
        still = tuple(replace(c, speed=t.ZERO) if c in moving else c for c in study.problem.coordinates)
        return Study(replace(study.problem, coordinates=still))

    yield Site({}, wrong)


def _speed_of_end(study: Study) -> Iterator[Site]:
    """The speed of the far end taken for that of the centre of mass."""
    for name in axes(study):
        state, arm = study.system.bodies[name], change.arm_of(study, name)
        velocity = state.velocity + arm.turned() * state.omega
        yield Site({"body": BodyRef(name)}, partial(_with_velocity, study, name, velocity))


def _with_velocity(study: Study, name: str, velocity) -> Study:
    """Another velocity in momenta and energies, and in the speed that follows from the energy."""
    wrong = change.with_kinematics(study, change.with_body(study, name, velocity=velocity))
    del wrong.__dict__["squares"]
    if study.potential is not None and study.first_integral is not None:
        wrong.__dict__["first_integral"] = sum(wrong.kinetic, NOTHING) + study.potential
    return wrong


def _orbital_dropped(study: Study) -> Iterator[Site]:
    """Only I_cm ω: the motion of the centre of mass is left out of the momentum (or the energy)."""
    for name, state in change.spinning(study):
        if state.velocity:
            still = change.with_body(study, name, velocity=ORIGIN)
            yield Site({"body": BodyRef(name)}, partial(change.with_kinematics, study, still))


def _small_angle(study: Study) -> Iterator[Site]:
    """The formula of small oscillations used for large ones."""
    from rbpsym.algebra.scalar import symbol

    system = study.system
    if len(system.independent) != 1 or system.problem.coordinates[0].quantity.dimension != NUMBER:
        return
    [name] = system.independent
    for place in study.equilibria:
        if not place.stable or len(place.frequencies_squared) != 1 or name not in place.at:
            continue
        pull = -place.frequencies_squared[0] * (symbol(name) - place.at[name])
        if is_zero(pull - (study.dynamics.accelerations or {}).get(f"{name}_ddot", pull)):
            continue

        def wrong(pull=pull) -> Study:
            dynamics = replace(study.dynamics, accelerations={f"{name}_ddot": pull})
            return change.with_parts(study, system=system, dynamics=dynamics, first_integral=None)

        yield Site({"coordinate": t.Sym(name)}, wrong)
        return


# --- the two works of a force


def _with_works(study: Study, turn) -> Study:
    return change.with_kinematics(study, study.system, works=tuple(map(turn, study.works)))


NO_WORK = Work({}, NOTHING)


def _contact_forces_workless(study: Study) -> Iterator[Site]:
    """“A force of contact does no work”: each of its two works is taken for zero."""
    for name in dict.fromkeys(f.name for f in study.system.forces if f.unknowns):
        variant = "one" if len({force.on for force in study.system.named(name)}) == 1 else "several"
        yield Site({"force": t.Vec(name), "variant": variant}, partial(_with_works, study, partial(_workless, name)))


def _workless(name: str, item: ForceWork) -> ForceWork:
    return replace(item, translational=NO_WORK, rotational=NO_WORK) if item.force == name else item


def _at_application_point(study: Study) -> Iterator[Site]:
    """∫F·dr along the path of the point of application taken for the translational work."""
    if any(w.rotational.parts for w in study.works):
        yield Site({}, lambda: _with_works(study, partial(_all_in, "translational")))


def _all_in(half: str, item: ForceWork) -> ForceWork:
    """Both works of a force counted as one of them."""
    values = (item.translational.value, item.rotational.value)
    return item if None in values else replace(item, **{half: Work(getattr(item, half).parts, sum(values, NOTHING))})


def _whole_in_rotation(study: Study) -> Iterator[Site]:
    """All the work of a force counted as rotational work: “it turns, so all of it is rotation”."""
    if any(w.translational.parts and w.rotational.parts for w in study.works):
        yield Site({}, lambda: _with_works(study, partial(_all_in, "rotational")))


def _torque_about_axis(study: Study) -> Iterator[Site]:
    """The torque about the fixed axis, instead of the centre of mass, in the rotational work."""
    for name in axes(study):
        arm = change.arm_of(study, name)
        forces = tuple(
            replace(f, couple=f.couple + arm.cross(f.vector)) if f.on == name else f for f in study.system.forces
        )
        system = replace(study.system, forces=forces)
        yield Site({"body": BodyRef(name)}, partial(change.with_kinematics, study, system))


def _always_cancel(study: Study) -> Iterator[Site]:
    """W_θ = -W_T for a force whose works do not cancel, as if it were one of contact."""
    workless = study.dynamics.workless
    for item in study.works:
        halves = (item.translational.value, item.rotational.value)
        if workless.get(item.force) or None in halves or not all(halves):
            continue
        yield Site({"force": t.Vec(item.force)}, partial(_with_rotational, study, item, -item.translational.value))


def _with_rotational(study: Study, item: ForceWork, value: Scalar) -> Study:
    """Another rotational work of a force on a body."""
    wrong = replace(item, rotational=Work(item.rotational.parts, value))
    return _with_works(study, lambda w: wrong if w == item else w)


def _never_cancel(study: Study) -> Iterator[Site]:
    """Both works of a force of contact with the same sign: they would add up instead of cancelling."""
    for item in study.works:
        if study.dynamics.workless.get(item.force) and item.rotational.parts and item.rotational.value is not None:
            yield Site({"force": t.Vec(item.force)}, partial(_with_rotational, study, item, -item.rotational.value))


MISCONCEPTIONS = (
    Misconception("rotational-energy-left-out", _no_rotational_energy, ENERGY | {"kinetic"}, WELL),
    Misconception("energy-kept", _energy_kept, ENERGY | {"acceleration"}),
    Misconception("start-speed-forgotten", _start_forgotten, ENERGY, WELL),
    Misconception("speed-of-end-for-center", _speed_of_end, frozenset({"speed", "kinetic", "momentum"})),
    Misconception("orbital-part-dropped", _orbital_dropped, frozenset({"momentum", "kinetic"}), WELL),
    Misconception("small-angle-for-large", _small_angle, frozenset({"acceleration", "speed"})),
    Misconception("torque-about-axis-in-work", _torque_about_axis, WORKS, WELL),
    Misconception("contact-forces-do-no-work", _contact_forces_workless, WORKS),
    Misconception("work-at-application-point", _at_application_point, WORKS),
    Misconception("all-work-is-rotational", _whole_in_rotation, WORKS),
    Misconception("works-always-cancel", _always_cancel, WORKS, WELL),
    Misconception("works-add-up", _never_cancel, WORKS, WELL),
)
