"""What decides sentences about works, energies, the start of the motion, and what was checked of the whole."""

from __future__ import annotations

from typing import Any

from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import PROVED
from rbpsym.errors import Undecided
from rbpsym.field import NOTHING, ORIGIN, Scalar, at_start, depends_on, is_zero, names_in, substitute
from rbpsym.mechanics import energy
from rbpsym.mechanics.events import ways_of
from rbpsym.mechanics.motion import power
from rbpsym.proof.grounds import Said, is_proved
from rbpsym.statement.scope import CLOCK

MOST_ERROR = 1e-6


def _halves(said: Said, name: str) -> list[Scalar]:
    """The rates of the works of a force on the motion, those that are zero by form left out."""
    works = (item for item in said.study.works if item.force == name)
    parts = (half.parts for item in works for half in (item.translational, item.rotational) if half.parts)
    rates = said.system.scope.rates
    return [said.study.on_motion(sum((v * rates[q] for q, v in part.items()), NOTHING)) for part in parts]


def works_cancel(said: Said) -> bool:
    """The sum vanishes whatever the force is, though on this motion none of the works is zero all the time."""
    return is_proved(said) and not any(is_zero(rate) for rate in _halves(said, said.forces[0].name))


def works_cancel_as_points_move_together(said: Said) -> bool:
    """And the points where the force acts have one velocity (that of the ground for a single body)."""
    speeds = [] if len(said.forces) > 1 else [ORIGIN]
    for force in said.forces:
        state = said.system.bodies[force.on]
        speeds.append(state.velocity + (force.point - state.center).turned() * state.omega)
    return works_cancel(said) and all((speed - speeds[0]).vanishes() for speed in speeds)


def takes_from_centre(said: Said) -> bool:
    """And the translational one is never positive on the way from the start."""
    return works_cancel_as_points_move_together(said) and sign(-_centre_work(said), _ahead(said)).is_nonnegative


def gives_to_centre(said: Said) -> bool:
    """It is never negative."""
    return works_cancel_as_points_move_together(said) and sign(_centre_work(said), _ahead(said)).is_nonnegative


def _centre_work(said: Said) -> Any:
    """The translational work of the force of a step. Raises Undecided where it has no closed form."""
    value = next(w for w in said.study.works if w.force == said.forces[0].name).translational.value
    if value is None:
        raise Undecided("no closed form was found for the work")
    return value


def _ahead(said: Said) -> Any:
    """The coordinate of the work lies ahead of the start, where it surely never comes behind it."""
    study = said.study
    given = study.assumptions
    for way in ways_of(study.system, study.dynamics, _centre_work(said), study.squares, given):
        low, high = given.range_of(way.name)
        ahead = given.with_range(way.name, *((way.start, high) if way.sense > 0 else (low, way.start)))
        given = ahead if starts_at_rest(said) or sign(way.square, ahead).kind == "positive" else given
    return given


def works_do_not_cancel(said: Said) -> bool:
    """The works of the force together are not zero."""
    return is_proved(said) and not is_zero(sum(_halves(said, said.forces[0].name), NOTHING))


def some_works_cancel(said: Said) -> bool:
    """There is a force whose works cancel in the sum."""
    return is_proved(said) and any(step.rule == "workless" and is_proved(Said(step=step)) for step in said.steps)


def common_work_is_not_zero(said: Said) -> bool:
    """The translational works of the forces that do none in the sum are not zero together on this motion."""
    rates, ideal = said.system.scope.rates, said.study.dynamics.workless
    parts = (part for w in said.study.works if ideal.get(w.force) for part in w.translational.parts.items())
    return is_proved(said) and not is_zero(said.study.on_motion(sum((v * rates[q] for q, v in parts), NOTHING)))


def rotational_work_is_opposite(said: Said) -> bool:
    """And no other force does rotational work."""
    ideal = said.study.dynamics.workless
    return common_work_is_not_zero(said) and all(ideal.get(w.force) for w in said.study.works if w.rotational.parts)


def does_not_turn_at_start(said: Said) -> bool:
    """ω of the body is zero at the start."""
    return is_proved(said) and is_zero(at_start(said.system.bodies[said.slot("body")].omega, said.system.scope))


def energy_is_conserved(said: Said) -> bool:
    """Each interaction has a potential energy, each unknown force does no work, and the sum is a constant."""
    known = said.study.potential is not None and said.study.first_integral is not None
    ideal = said.study.dynamics.workless
    return known and is_proved(said) and all(ideal.get(f.name) for f in said.system.forces if f.unknowns)


def work_is_handed_on(said: Said) -> bool:
    """Each of the forces does work on each of its bodies, both halves together."""
    names = {node.name for _, step in said.step.data["terms"] for node in step.slots["forces"]}
    rates = (power(said.system, work) for work in said.study.works if work.force in names)
    return is_proved(said) and not any(is_zero(said.study.on_motion(rate)) for rate in rates)


def conserved_energy_is_handed_on(said: Said) -> bool:
    """And the energy is conserved."""
    return energy_is_conserved(said) and work_is_handed_on(said)


def turns_and_moves(said: Said) -> bool:
    """There is a kinetic energy of rotation, and one of translation."""
    states = said.system.bodies.values()
    turns = any(not is_zero(state.omega * state.moment) for state in states)
    return is_proved(said) and turns and not all(state.velocity.vanishes() for state in states)


def energy_has_no_drive(said: Said) -> bool:
    """Nothing is driven: what is constant is then not only Jacobi's integral."""
    return is_proved(said) and not said.system.has_clock


def no_force_acts(said: Said) -> bool:
    """There is none at all."""
    return is_proved(said) and not said.system.forces


def is_not_carried(said: Said) -> bool:
    """Nothing is moved in a given way, so that what balances is at rest."""
    return not said.system.has_clock


def work_is_of_position(said: Said) -> bool:
    """A force without a potential energy, and one degree of freedom."""
    found = energy.potentials(said.system).values()
    return is_proved(said) and None in found and len(said.system.independent) == 1


def acceleration_is_alone(said: Said) -> bool:
    """The acceleration of the coordinate depends on no other coordinate, nor on the speed of another one."""
    own = said.slot("coordinate")
    value = said.study.dynamics.accelerations[f"{own}_ddot"]
    others = (n for name in said.system.independent if name != own for n in (name, f"{name}_dot"))
    return is_proved(said) and not any(depends_on(value, name) for name in others)


def acceleration_is_alone_and_does_not_stay(said: Said) -> bool:
    """And it does not start from rest where its accelerations vanish."""
    return acceleration_is_alone(said) and does_not_stay(said)


def acceleration_is_of_position(said: Said) -> bool:
    """The acceleration of the coordinate depends on nothing but this coordinate, not even on its own speed."""
    own = said.slot("coordinate")
    return acceleration_is_alone(said) and not depends_on(said.study.dynamics.accelerations[f"{own}_ddot"], f"{own}_dot")


def acceleration_is_of_position_and_does_not_stay(said: Said) -> bool:
    """And it does not start from rest where its accelerations vanish."""
    return acceleration_is_of_position(said) and does_not_stay(said)


def is_constant_action(said: Said) -> bool:
    """The vectors and couples of the force do not change."""
    values = [part for f in said.step.data["forces"] for part in (f.vector.x, f.vector.y, f.couple)]
    return is_proved(said) and not any(said.moving & names_in(value) for value in values)


def does_not_stay(said: Said) -> bool:
    """It does not start from rest where its accelerations vanish."""
    return is_proved(said) and not stays_at_rest(said)


def only_friction_works(said: Said) -> bool:
    """All other forces together do no work."""
    others = [n for n in dict.fromkeys(f.name for f in said.system.forces) if not _is_kinetic(said, n)]
    return is_proved(said) and is_zero(sum((rate for n in others for rate in _halves(said, n)), NOTHING))


def _is_kinetic(said: Said, name: str) -> bool:
    values = said.system.element(name).values
    return values.get("coefficient") is not None and values.get("friction") == name


def energy_is_lost(said: Said) -> bool:
    """The difference of the kinetic energies is not negative."""
    value = said.context.value(said.rows[0].items[-1])
    return is_proved(said) and sign(value, said.study.assumptions).kind in ("positive", "nonnegative", "zero")


# --- whole pages


def all_works_are_done(said: Said) -> bool:
    """Each work that is not zero has a step that tells its value, and each of them is proved."""
    done = {step.id for step in said.steps if is_proved(Said(step=step))}
    halves = ((w, letter, half) for w in said.study.works for letter, half in (("T", w.translational), ("theta", w.rotational)))
    return all(f"done.{letter}.{w.force}.{w.on}" in done for w, letter, half in halves if half.parts)


def starts_at_rest(said: Said) -> bool:
    """Nothing moves at the start."""
    states, scope = said.system.bodies.values(), said.system.scope
    speeds = (part for s in states for part in (s.velocity.x, s.velocity.y, s.omega))
    return all(is_zero(at_start(speed, scope)) for speed in speeds)


def stays_at_rest(said: Said) -> bool:
    """It starts at rest where all accelerations vanish, at each time."""
    found = said.study.solved.accelerations
    start = {name: value for name, value in said.system.scope.start.items() if name != CLOCK}
    return bool(found) and starts_at_rest(said) and all(is_zero(substitute(a, start)) for a in found.values())


def leaves_rest(said: Said) -> bool:
    """It starts from rest, and does not stay there."""
    return starts_at_rest(said) and not stays_at_rest(said)


def can_move(said: Said) -> bool:
    """There is a degree of freedom, or something is driven."""
    return bool(said.system.independent) or said.system.has_clock


def is_still(said: Said) -> bool:
    """Nothing is free, and nothing is driven."""
    return not can_move(said)


def is_driven(said: Said) -> bool:
    """The whole motion is given."""
    return said.system.has_clock and not said.system.independent


def _has_vertical(said: Said) -> bool:
    return any(force.law == "gravity" for force in said.system.forces)


def all_move(said: Said) -> bool:
    """No body is held."""
    bodies = said.system.bodies.values()
    return can_move(said) and not any(is_zero(body.omega) and body.velocity.vanishes() for body in bodies)


def all_move_in_vertical_plane(said: Said) -> bool:
    """No body is held, and gravity acts."""
    return all_move(said) and _has_vertical(said)


def moves_in_vertical_plane(said: Said) -> bool:
    """Something can move, and gravity acts."""
    return can_move(said) and _has_vertical(said)


def rests_in_vertical_plane(said: Said) -> bool:
    """It can't move, and gravity acts."""
    return is_still(said) and _has_vertical(said)


def all_steps_are_proved(said: Said) -> bool:
    """None is refuted or undecided."""
    return bool(said.steps) and all(is_proved(Said(step=step)) for step in said.steps)


def methods_agree(said: Said) -> bool:
    """At least two methods have found the accelerations, and all are proved to have found the same."""
    methods = said.summary["methods"]
    return len(methods) > 1 and said.summary["methods_agree"] and set(methods.values()) == {str(PROVED)}


def is_confirmed(said: Said) -> bool:
    """There is a second road, and it was decided that it leads to the same."""
    return methods_agree(said) or lagrange_agrees(said) or bool(said.summary["simulation"] and simulation_agrees(said))


def methods_differ(said: Said) -> bool:
    """One is refuted."""
    return "REFUTED" in said.summary["methods"].values()


def lagrange_agrees(said: Said) -> bool:
    """Proved."""
    return bool(said.summary["lagrange"] == str(PROVED))


def simulation_agrees(said: Said) -> bool:
    """The relative error is that of the arithmetic."""
    return bool(said.summary["simulation"]["max_relative_error"] <= MOST_ERROR)


def most_are_checked_twice(said: Said) -> bool:
    """More than half of the steps passed more than one check."""
    return sum(len(step.certificate.checks) > 1 for step in said.steps) * 2 > len(said.steps)
