"""Misconceptions about work, energy and momentum: what is left out, counted twice, or taken for something else."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, ORIGIN, Scalar, Vector, is_zero, short, symbol
from rbpsym.mechanics.motion import ForceWork, Work, along_motion
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import BodyRef
from rbpsym.quantities import NUMBER
from rbpsym.statement.model import Element
from rbpsym.teaching.misconceptions import model as change
from rbpsym.teaching.misconceptions.model import ENERGY, WELL, WORKS, Misconception, Site, Sites, of_bodies, spinning

KINETIC = ENERGY | {"kinetic"}
SUMS = frozenset({"momentum", "kinetic"})
DAMPERS = ("damper", "rotary-damper", "resistance", "resisting-couple")


# --- energies


def with_energy(study: Study, energy: Scalar, **parts: object) -> Study:
    """Another first integral; the true dynamics stays."""
    kept = {"system": study.system, "dynamics": study.dynamics, "kinetic": study.kinetic}
    return change.with_parts(study, **(kept | parts), first_integral=energy)


def _with_kinetic(study: Study, *kinetic: Scalar) -> Iterator[Site]:
    """Another kinetic energy, translational and rotational, and the speed that follows from it."""
    if study.potential is not None and kinetic != study.kinetic:
        energy = sum(kinetic, NOTHING) + study.potential
        yield Site({}, partial(with_energy, study, energy, kinetic=kinetic))


def _times(translational: int, rotational: int) -> Sites:
    """The two parts of the kinetic energy so many times; there must be both, if they are not taken alike."""

    def sites(study: Study) -> Iterator[Site]:
        first, second = study.kinetic
        if translational == rotational or (first and second):
            yield from _with_kinetic(study, first * translational, second * rotational)

    return sites


def _directed_energy(study: Study) -> Iterator[Site]:
    """Energies of rotations in opposite senses taken to subtract."""
    states = [state for _, state in spinning(study)]
    turning = [(state, change.sign_of(study, short(state.omega / states[0].omega))) for state in states]
    if {way for _, way in turning} == {1, -1}:
        total = sum((s.moment * s.omega * s.omega * way for s, way in turning), NOTHING) / 2
        yield from _with_kinetic(study, study.kinetic[0], total)


def _no_half_in_spring(study: Study) -> Iterator[Site]:
    """k s² for ½ k s²."""
    for element in study.problem.interactions:
        if element.kind == "spring" and study.first_integral is not None:
            stiff = element.with_values(stiffness=t.mul(t.TWO, element["stiffness"]))
            potential = change.with_element(study, element, stiff).potential
            if potential is not None:
                energy = sum(study.kinetic, NOTHING) + potential
                yield Site({"force": t.Vec(element.name)}, partial(with_energy, study, energy))


def _losses(element: Element) -> bool:
    return element.kind in DAMPERS or element.values.get("coefficient") is not None


def _energy_kept(study: Study) -> Iterator[Site]:
    """Energy kept though a bearing, a damper or friction takes some."""
    taking = [_taking(study, element) for element in study.problem.elements if _losses(element)]
    if taking:
        yield Site({"forces": taking, "count": len(taking)}, partial(change.with_elements, study, _lossless))


def _taking(study: Study, element: Element) -> t.Node:
    """The force, or the couple, by which an element takes energy."""
    name = element.name if element.kind in DAMPERS else element["friction"]
    return t.Vec(name) if any(force.vector for force in study.system.named(name)) else t.Sym(name)


def _damping_left_out(study: Study) -> Iterator[Site]:
    """It moves as if a damper, or what resists from outside in a bearing, were not there."""
    for element in study.problem.of_kind(*DAMPERS):
        yield Site({"force": _taking(study, element)}, partial(change.with_element, study, element, None))


def _lossless(element: Element) -> Element | None:
    if element.kind in DAMPERS:
        return None
    return element.with_values(coefficient=None) if element.values.get("coefficient") is not None else element


def _start_forgotten(study: Study) -> Iterator[Site]:
    """The kinetic energy that it has at the start is left out, where it would move without it too."""
    driven = not all(map(is_zero, (study.dynamics.accelerations or {}).values()))
    if driven and any(change.is_nonzero(c.speed) for c in study.problem.coordinates):
        yield Site({}, partial(_started_at_rest, study))


def _started_at_rest(study: Study) -> Study:
    """The same motion from rest."""
    still = tuple(replace(c, speed=t.ZERO) if change.is_nonzero(c.speed) else c for c in study.problem.coordinates)
    return Study(replace(study.problem, coordinates=still))


def _uniform_acceleration(study: Study) -> Iterator[Site]:
    """v² = v₀² + 2 a s with an acceleration that changes on the way."""
    start = study.system.scope.start
    for name in study.squares:
        push = (study.dynamics.accelerations or {}).get(f"{name}_ddot")
        here = None if push is None else along_motion(push, study.squares)
        if here is not None and name in start:
            first = start.get(f"{name}_dot", NOTHING)
            square = first * first + here * (symbol(name) - start[name]) * 2
            squares = {**study.squares, name: square}
            kept = {"system": study.system, "dynamics": study.dynamics}
            yield Site({"coordinate": t.Sym(name)}, partial(change.with_parts, study, **kept, squares=squares))


def _small_angle(study: Study) -> Iterator[Site]:
    """The formula of small oscillations used for large ones."""
    system, accelerations = study.system, study.dynamics.accelerations or {}
    if len(system.independent) != 1 or system.problem.coordinates[0].quantity.dimension != NUMBER:
        return
    [name] = system.independent
    swings = (p for p in study.equilibria if p.stable and len(p.frequencies_squared) == 1 and name in p.at)
    pulls = (-place.frequencies_squared[0] * (symbol(name) - place.at[name]) for place in swings)
    pull = next((p for p in pulls if not is_zero(p - accelerations.get(f"{name}_ddot", p))), None)
    if pull is not None:
        dynamics = replace(study.dynamics, accelerations={f"{name}_ddot": pull})
        parts = {"system": system, "dynamics": dynamics, "first_integral": None}
        yield Site({"coordinate": t.Sym(name)}, partial(change.with_parts, study, **parts))


# --- bodies whose speeds are taken for others in momenta and energies


Changes = Iterable[tuple[str, Mapping[str, Any]]]


def _one_body_forgotten(study: Study) -> Changes:
    """One body of several that move is not counted in the sum over the system."""
    moving = [name for name, s in study.system.bodies.items() if s.velocity != ORIGIN or s.omega]
    return ((name, {"velocity": ORIGIN, "omega": NOTHING}) for name in moving if len(moving) > 1)


def _alike_turning(study: Study) -> Changes:
    """L taken for ω: of two bodies that turn alike the one is given the momentum of the other."""
    for name, state in study.system.bodies.items():
        same = (s for n, s in study.system.bodies.items() if n != name and s.omega and is_zero(s.omega - state.omega))
        for other in islice(same, 1):
            yield name, {part: getattr(other, part) for part in ("inertia", "center", "velocity")}


def _sine_for_cosine(study: Study) -> Changes:
    """The component of the momentum along the lever arm for the one across it."""
    origin, bodies = study.origins["O"], study.system.bodies.items()
    return ((n, {"velocity": s.velocity.turned()}) for n, s in bodies if not is_zero((s.center - origin).dot(s.velocity)))


def _speed_of_end(study: Study) -> Iterator[Site]:
    """The speed of the far end taken for that of the centre of mass."""
    for name, arm in change.arms(study).items():
        state = study.system.bodies[name]
        velocity = state.velocity + arm.turned() * state.omega
        yield Site({"body": BodyRef(name)}, partial(_with_velocity, study, name, velocity))


def _with_velocity(study: Study, name: str, velocity: Vector) -> Study:
    """Another velocity in momenta and energies, and in the speed that follows from the energy."""
    wrong = change.with_kinematics(study, change.with_body(study, name, velocity=velocity))
    del wrong.__dict__["squares"]
    if study.potential is not None and study.first_integral is not None:
        wrong.__dict__["first_integral"] = sum(wrong.kinetic, NOTHING) + study.potential
    return wrong


# --- the two works of a force


Halves = Mapping[str, Scalar | None]


def _with_works(study: Study, turn: Callable[[ForceWork], ForceWork]) -> Study:
    return change.with_kinematics(study, study.system, works=tuple(map(turn, study.works)))


def _works(wrong: Callable[[Study, ForceWork], Halves]) -> Sites:
    """At each force on a body whose works have other values by `wrong`: by half of the work, none for no such place."""

    def sites(study: Study) -> Iterator[Site]:
        for item in study.works:
            if values := wrong(study, item):
                turned = partial(_replaced, item, _with_halves(item, values))
                yield Site({"force": t.Vec(item.force), "body": BodyRef(item.on)}, partial(_with_works, study, turned))

    return sites


def _with_halves(item: ForceWork, values: Halves) -> ForceWork:
    """The works of a force with other values of one half or both."""
    parts: dict[str, Any] = {half: Work(getattr(item, half).parts, value) for half, value in values.items()}
    return replace(item, **parts)


def _replaced(old: ForceWork, new: ForceWork, item: ForceWork) -> ForceWork:
    return new if item == old else item


def _always_cancel(study: Study, item: ForceWork) -> Halves:
    """W_θ = -W_T for a force whose works do not cancel, as if it were one of contact."""
    first, second = item.translational.value, item.rotational.value
    return {"rotational": -first} if first and second and not study.dynamics.workless.get(item.force) else {}


def _never_cancel(study: Study, item: ForceWork) -> Halves:
    """Both works of a force of contact with the same sign: they would add up instead of cancelling."""
    work = item.rotational
    turns = study.dynamics.workless.get(item.force) and work.parts
    return {"rotational": -work.value} if turns and work.value is not None else {}


def _opposite(study: Study, item: ForceWork) -> Halves:
    """Both works of a force with the wrong sign."""
    first, second = item.translational.value, item.rotational.value
    return {} if first is None or second is None else {"translational": -first, "rotational": -second}


NO_WORK = Work({}, NOTHING)


def _contact_forces_workless(study: Study) -> Iterator[Site]:
    """“A force of contact does no work”: each of its two works is taken for zero."""
    for name in dict.fromkeys(f.name for f in study.system.forces if f.unknowns):
        variant = "one" if len({force.on for force in study.system.named(name)}) == 1 else "several"
        yield Site({"force": t.Vec(name), "variant": variant}, partial(_with_works, study, partial(_workless, name)))


def _workless(name: str, item: ForceWork) -> ForceWork:
    return replace(item, translational=NO_WORK, rotational=NO_WORK) if item.force == name else item


def _all_in(half: str) -> Sites:
    """All the work of a force counted as one of its two works."""

    def sites(study: Study) -> Iterator[Site]:
        if any(w.translational.parts and w.rotational.parts for w in study.works):
            yield Site({}, partial(_with_works, study, partial(_joined, half)))

    return sites


def _joined(half: str, item: ForceWork) -> ForceWork:
    first, second = item.translational.value, item.rotational.value
    return item if first is None or second is None else _with_halves(item, {half: first + second})


def _torque_about_axis(study: Study) -> Iterator[Site]:
    """The torque about the fixed axis, instead of the centre of mass, in the rotational work."""
    for name, arm in change.arms(study).items():
        forces = tuple(replace(f, couple=f.couple + arm.cross(f.vector)) if f.on == name else f for f in study.system.forces)
        system = replace(study.system, forces=forces)
        yield Site({"body": BodyRef(name)}, partial(change.with_kinematics, study, system))


STILL = {"velocity": ORIGIN}  # only I_cm ω: the motion of the centre of mass is left out
MISCONCEPTIONS = (
    Misconception("rotational-energy-left-out", _times(1, 0), KINETIC, WELL),
    Misconception("damping-left-out", _damping_left_out, frozenset({"acceleration", "reaction", "frequency"})),
    Misconception("energy-kept", _energy_kept, ENERGY),
    Misconception("start-speed-forgotten", _start_forgotten, ENERGY, WELL),
    Misconception("speed-of-end-for-center", _speed_of_end, SUMS | {"speed"}),
    Misconception("orbital-part-dropped", of_bodies(lambda s: ((n, STILL) for n, b in spinning(s) if b.velocity)), SUMS, WELL),
    Misconception("small-angle-for-large", _small_angle, frozenset({"acceleration", "speed"})),
    Misconception("torque-about-axis-in-work", _torque_about_axis, WORKS, WELL),
    Misconception("contact-forces-do-no-work", _contact_forces_workless, WORKS),
    Misconception("work-at-application-point", _all_in("translational"), WORKS),  # ∫F·dr along the path of that point
    Misconception("all-work-is-rotational", _all_in("rotational"), WORKS),
    Misconception("works-always-cancel", _works(_always_cancel), WORKS, WELL),
    Misconception("works-add-up", _works(_never_cancel), WORKS, WELL),
    Misconception("translational-energy-left-out", _times(0, 1), KINETIC, WELL),
    Misconception("half-forgotten-in-kinetic-energy", _times(2, 2), KINETIC, WELL),
    Misconception("half-forgotten-in-rotational-energy", _times(1, 2), KINETIC, WELL),
    Misconception("rotational-energies-subtract", _directed_energy, KINETIC, WELL),
    Misconception("half-forgotten-in-spring-energy", _no_half_in_spring, ENERGY),
    Misconception("uniform-acceleration-formula", _uniform_acceleration, frozenset({"speed"})),
    Misconception("one-body-not-in-the-sum", of_bodies(_one_body_forgotten), SUMS, WELL),
    Misconception("momentum-is-angular-velocity", of_bodies(_alike_turning), frozenset({"momentum"})),
    Misconception("sine-for-cosine-in-momentum", of_bodies(_sine_for_cosine), frozenset({"momentum"})),
    Misconception("work-sign", _works(_opposite), WORKS),
)
