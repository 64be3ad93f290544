"""What decides whether a sentence is true of a system: one function for each kind of assertion.

True means proved: what is refuted, and what is not decided, is False. Zero is decided exactly; signs come from the
declared ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from rbpsym.algebra.calculus import depends_on, derivative, names_in
from rbpsym.algebra.evaluate import at_start, scalar
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.algebra.vector import ORIGIN, Vector
from rbpsym.derivation.step import Step
from rbpsym.equality.signs import sign
from rbpsym.equality.verdict import PROVED
from rbpsym.mechanics import energy
from rbpsym.mechanics.assemble import vector_rate
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force
from rbpsym.notation import tree as t
from rbpsym.statement.curves import toucher

if TYPE_CHECKING:
    from rbpsym.derivation.context import Context


MOST_ERROR = 1e-6


@dataclass(frozen=True)
class Said:
    """What a sentence is about: a system, the step that it tells or those that it sums up, what their letters mean."""

    study: Study | None = None
    step: Step | None = None
    steps: Sequence[Step] = ()
    context: Context | None = None
    summary: dict[str, Any] = field(default_factory=dict)

    @property
    def system(self):
        """The assembled system."""
        return self.study.system

    @property
    def moving(self) -> set[str]:
        """Names of all that changes with the time."""
        known = self.system.coordinates + tuple(c.name for c in self.study.problem.coordinates)
        return {"t", *(f"{name}{rate}" for name in known for rate in ("", "_dot", "_ddot"))}

    @property
    def rows(self) -> Sequence[t.Chain]:
        """The relations of the step."""
        return self.step.statement.rows if isinstance(self.step.statement, t.System) else (self.step.statement,)

    def slot(self, name: str) -> str:
        """The name of the body or the letter in a slot."""
        return self.step.slots[name].name

    @property
    def forces(self) -> list[Force]:
        """The forces that the step is about: those of the name in its slot."""
        name = self.step.id.split(".")[1]
        return [force for force in self.system.forces if force.name == name]


# --- steps by themselves


def is_proved(said: Said) -> bool:
    """Its formula is proved."""
    return said.step.certificate is not None and said.step.certificate.verdict.kind is PROVED


def ends_in_zero(said: Said) -> bool:
    """What is proved is that something vanishes."""
    return is_proved(said) and all(row.items[-1] == t.ZERO for row in said.rows)


def ends_otherwise(said: Said) -> bool:
    """What is proved to be equal to something is not zero all the time."""
    value = said.context.value(said.rows[-1].items[-1])
    return is_proved(said) and not is_zero(said.study.on_motion(value))


def is_identity(said: Said) -> bool:
    """It holds as it stands, before anything is put in."""
    return all(is_zero(scalar(row.items[0]) - scalar(row.items[-1])) for row in said.rows)


def is_never_positive(said: Said) -> bool:
    """The formula itself ends in ≤ 0."""
    return is_proved(said) and all(row.ops[-1] == "<=" for row in said.rows)


def is_without_unknowns(said: Said) -> bool:
    """The letters that its sentence says go away are not in it: those in a slot, or all unknown forces."""
    gone = {node.name for node in said.step.slots.get("torques", ())} or set(said.system.unknowns)
    return is_proved(said) and not gone & t.names(said.step.statement)


def is_steady(said: Said) -> bool:
    """No side on the right changes with the time."""
    return all(not said.moving & t.names(row.items[-1]) for row in said.rows)


def _free_of(said: Said, kinds: tuple[str, ...]) -> bool:
    changing = {name for name in said.moving if name == "t" or name.endswith(kinds)}
    return is_proved(said) and not any(changing & t.names(row.items[-1]) for row in said.rows)


def is_of_position_and_speed(said: Said) -> bool:
    """Neither accelerations nor the time stand on the right."""
    return _free_of(said, ("_ddot",))


def is_of_position(said: Said) -> bool:
    """Nor speeds."""
    return _free_of(said, ("_ddot", "_dot"))


# --- kinematics


def ties_to_others(said: Said) -> bool:
    """A coordinate that is not free depends on one that is."""
    value = said.system.dependent[said.slot("coordinate")]
    return is_proved(said) and any(not is_zero(derivative(value, name)) for name in said.system.independent)


def is_point_of_body(said: Said) -> bool:
    """What touches is a point of a body, and not of the ground."""
    return is_proved(said) and toucher(said.step.data["element"]) is not None


def is_turned_back(said: Said) -> bool:
    """ω is minus the rate of the coordinate."""
    omega = said.system.bodies[said.slot("body")].omega
    return any(is_zero(omega + symbol(f"{node.name}_dot")) for node in said.step.slots["coordinates"])


def does_not_turn(said: Said) -> bool:
    """ω of the body vanishes."""
    return is_zero(said.system.bodies[said.slot("body")].omega)


def nothing_turns(said: Said) -> bool:
    """No body turns."""
    return all(is_zero(state.omega) for state in said.system.bodies.values())


def turns_about_point(said: Said) -> bool:
    """The velocity of the centre of mass (of each one, if no body is named) is ω × its arm from the fixed point."""
    origin, states = said.study.origins[said.slot("point")], said.system.bodies
    told = [states[said.slot("body")]] if "body" in said.step.slots else states.values()
    rest = [state.velocity - (state.center - origin).turned() * state.omega for state in told]
    return is_proved(said) and all(_vanishes(speed) for speed in rest)


def _vanishes(vector: Vector) -> bool:
    return is_zero(vector.x) and is_zero(vector.y)


def is_orbital(said: Said) -> bool:
    """There is no spin part."""
    return is_proved(said) and is_zero(said.step.data["spin"])


def is_spin(said: Said) -> bool:
    """There is no orbital part."""
    return is_proved(said) and is_zero(said.step.data["orbital"])


# --- balances


def point_moves(said: Said) -> bool:
    """The point about which torques are taken is not at rest."""
    return is_proved(said) and not _vanishes(vector_rate(said.step.data["origin"], said.system.scope))


def all_lines_meet(said: Said) -> bool:
    """No unknown force that acts from outside has a torque about the point."""
    forces = [f for f in said.step.data["forces"] if f.unknowns]
    torques = ((f.point - said.step.data["origin"]).cross(f.vector) + f.couple for f in forces)
    return is_proved(said) and all(is_zero(torque) for torque in torques)


def silent_forces_drop_out(said: Said) -> bool:
    """None of their components stands in the net torque, nor in what friction takes from it."""
    names = {node.name for node in said.step.slots["silent"].slots["forces"]}
    gone = {name for f in said.step.data["forces"] if f.name in names for name in f.unknowns}
    return is_proved(said) and not gone & t.names(said.step.statement)


def starts_to_turn(said: Said) -> bool:
    """The spin has a rate of change."""
    return is_proved(said) and said.rows[0].items[0] != t.ZERO


def no_force_acts_along(said: Said) -> bool:
    """None of the outer forces has a component along the direction (they do not just cancel)."""
    along, bodies = said.step.data["along"], said.step.data["bodies"]
    outer = [f for f in said.system.forces if f.on in bodies and f.by not in bodies]
    return is_proved(said) and all(is_zero(along.dot(f.vector)) for f in outer)


# --- works and energy


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
    return works_cancel(said) and all(_vanishes(speed - speeds[0]) for speed in speeds)


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


def no_force_acts(said: Said) -> bool:
    """There is none at all."""
    return is_proved(said) and not said.system.forces


def work_is_of_position(said: Said) -> bool:
    """A force without a potential energy, and one degree of freedom."""
    found = energy.potentials(said.system).values()
    return is_proved(said) and None in found and len(said.system.independent) == 1


def acceleration_is_alone(said: Said) -> bool:
    """The acceleration of the coordinate depends on no other coordinate, nor on its speed."""
    own = said.slot("coordinate")
    value = said.study.dynamics.accelerations[f"{own}_ddot"]
    others = (n for name in said.system.independent if name != own for n in (name, f"{name}_dot"))
    return is_proved(said) and not any(depends_on(value, name) for name in others)


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


def starts_at_rest(said: Said) -> bool:
    """Nothing moves at the start."""
    states, scope = said.system.bodies.values(), said.system.scope
    speeds = (part for s in states for part in (s.velocity.x, s.velocity.y, s.omega))
    return all(is_zero(at_start(speed, scope)) for speed in speeds)


def stays_at_rest(said: Said) -> bool:
    """It starts at rest where all accelerations vanish."""
    found, scope = said.study.dynamics.accelerations, said.system.scope
    return bool(found) and starts_at_rest(said) and all(is_zero(at_start(a, scope)) for a in found.values())


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


def moves_in_vertical_plane(said: Said) -> bool:
    """It can move, and gravity acts."""
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
    return said.summary["lagrange"] == str(PROVED)


def simulation_agrees(said: Said) -> bool:
    """The relative error is that of the arithmetic."""
    return said.summary["simulation"]["max_relative_error"] <= MOST_ERROR


def most_are_checked_twice(said: Said) -> bool:
    """More than half of the steps passed more than one check."""
    return sum(len(step.certificate.checks) > 1 for step in said.steps) * 2 > len(said.steps)
