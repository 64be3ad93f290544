"""What decides whether a sentence is true of a system: one function for each kind of assertion.

True means proved: what is refuted, and what is not decided, is False. Zero is decided exactly; signs come from the
declared ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rbpsym.decide.verdict import PROVED
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, depends_on, derivative, is_zero, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.assemble import vector_rate
from rbpsym.mechanics.events import vanishes_before, ways_of
from rbpsym.mechanics.system import Force, System
from rbpsym.proof.step import Step
from rbpsym.statement.curves import toucher


class Said(Frozen):
    """What a sentence is about: a system, the step that it tells or those that it sums up, what their letters mean; what is
    None is none of its matters."""

    study: Any = None
    step: Any = None
    steps: Sequence[Step] = ()
    context: Any = None
    summary: dict[str, Any] = field(default_factory=dict)

    @property
    def system(self) -> System:
        """The assembled system."""
        found: System = self.study.system
        return found

    @property
    def moving(self) -> set[str]:
        """Names of all that changes with the time."""
        known = self.system.coordinates + tuple(c.name for c in self.study.problem.coordinates)
        return {"t", *(f"{name}{rate}" for name in known for rate in ("", "_dot", "_ddot"))}

    @property
    def rows(self) -> Sequence[t.Chain]:
        """The relations of the step."""
        return t.rows(self.step.statement)

    def slot(self, name: str) -> str:
        """The name of the body or the letter in a slot."""
        return str(self.step.slots[name].name)

    @property
    def forces(self) -> list[Force]:
        """The forces that the step is about: those of the name in its slot."""
        return self.system.named(self.step.id.split(".")[1])


# --- steps by themselves


def is_proved(said: Said) -> bool:
    """Its formula is proved."""
    return bool(said.step.certificate.verdict.kind is PROVED)


def ends_in_zero(said: Said) -> bool:
    """What is proved is that something vanishes."""
    return is_proved(said) and all(row.items[-1] == t.ZERO for row in said.rows)


def ends_otherwise(said: Said) -> bool:
    """What is proved to be equal to something is not zero all the time, whatever the parameters."""
    value = said.study.on_motion(said.context.value(said.rows[-1].items[-1]))
    mild = [{q.name: NOTHING} for q in said.study.problem.parameters if q.sign not in ("positive", "negative")]
    return is_proved(said) and not any(is_zero(substitute(value, at)) for at in ({}, *mild))


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


def acts_at_same_points(said: Said) -> bool:
    """And each unknown force between two bodies acts on both at one point; those of a string only along one line."""
    bodies = {b for premise in said.step.data["terms"] for b in premise[1].id.split(".")[1:]}
    inner = [f for f in said.system.forces if f.unknowns and f.on in bodies and f.by in bodies]
    ends = [(a, b) for a in inner for b in inner if a.name == b.name and a.on == b.by and b.on == a.by]
    return is_without_unknowns(said) and all((a.point - b.point).vanishes() for a, b in ends if a.vector)


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


def no_friction_is_enough(said: Said) -> bool:
    """The normal force comes to zero where static friction is still asked for, and no contact ends before."""
    study = said.study
    if not is_proved(said) or not study.reactions_along_motion or study.losses or study.ended.complete is not True:
        return False
    friction, normal = said.slot("friction"), said.slot("force")
    found = ways_of(study.system, study.dynamics, study.reactions_along_motion[normal], study.squares, study.assumptions)
    return any(vanishes_before(way, study.reactions_along_motion, normal, friction, study.assumptions) for way in found)


def nothing_slips(said: Said) -> bool:
    """Nothing is held by static friction, or surely within its limit, or without need of it."""
    return is_proved(said) and all(need.holds or is_zero(need.ratio) for need in said.study.friction_needs)


# --- kinematics


def ties_to_others(said: Said) -> bool:
    """A coordinate that is not free depends on one that is."""
    value = said.system.dependent[said.slot("coordinate")]
    return is_proved(said) and any(not is_zero(derivative(value, name)) for name in said.system.independent)


def places_no_mass(said: Said) -> bool:
    """What a coordinate places has no mass, and it depends on one that is free."""
    name, placed = said.slot("coordinate"), []
    for body in said.system.problem.bodies:
        pose = (*(body.placed[1] if body.placed else ()), *([body.angle] if body.angle else ()))
        placed += [said.system.bodies[body.name]] if any(name in t.names(node) for node in pose) else []
    return ties_to_others(said) and bool(placed) and all(is_zero(one.mass) and is_zero(one.moment) for one in placed)


def touching_body_moves(said: Said) -> bool:
    """What touches is a point of a body that can move."""
    name = toucher(said.step.data["element"])
    if name is None or not is_proved(said):
        return False
    body = said.system.bodies[name]
    return not (is_zero(body.omega) and body.velocity.vanishes())


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
    return is_proved(said) and all(speed.vanishes() for speed in rest)


def is_orbital(said: Said) -> bool:
    """There is no spin part."""
    return is_proved(said) and is_zero(said.step.data["spin"])


def is_spin(said: Said) -> bool:
    """There is no orbital part."""
    return is_proved(said) and is_zero(said.step.data["orbital"])


def is_one_place(said: Said) -> bool:
    """A position of rest fixes all coordinates: it is none of a family along which nothing is driven back."""
    return is_proved(said) and set(said.system.independent) <= said.step.data["at"].keys()


# --- balances


def point_moves(said: Said) -> bool:
    """The point about which torques are taken is not at rest."""
    return is_proved(said) and not vector_rate(said.step.data["origin"], said.system.scope).vanishes()


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


def impulses_drop_out(said: Said) -> bool:
    """None of the impulses that are named has a torque about the place of the jump, or a component along its direction."""
    jump, moment = said.step.data["jump"], said.step.data["blow"].moment
    parts = (force.torque(jump.where) if jump.is_turning else jump.where.dot(force.vector) for force in jump.silent)
    return is_proved(said) and all(is_zero(moment.new(part)) for part in parts)


def impulses_cancel(said: Said) -> bool:
    """Whatever acts between the bodies of the jump has neither a torque in the sum nor a component along its direction."""
    jump, blow = said.step.data["jump"], said.step.data["blow"]
    acting = [force for force in blow.forces if force.on in jump.bodies]
    total = sum((force.torque(jump.where) if jump.is_turning else jump.where.dot(force.vector) for force in acting), NOTHING)
    return is_proved(said) and len(jump.bodies) > 1 and is_zero(blow.moment.new(total))


def forces_have_no_torque(said: Said) -> bool:
    """None of the silent outer forces has a torque about the point, whatever the unknown ones are."""
    kept = said.step.data["kept"]
    return is_proved(said) and all(is_zero(force.torque(kept.where)) for force in kept.silent)


def torques_cancel(said: Said) -> bool:
    """The torques of the others vanish in the sum, with the forces that the motion asks for."""
    kept = said.step.data["kept"]
    total = sum((force.torque(kept.where) for force in kept.cancel), NOTHING)
    return is_proved(said) and is_zero(said.study.on_motion(total))


def is_free_of_coefficient(said: Said) -> bool:
    """The coefficient of friction stands in no value that the step gives."""
    coefficient = said.step.slots["free"].slots["coefficient"]
    values = (said.context.value(row.items[-1]) for row in said.rows)
    names = t.names(coefficient)
    return is_proved(said) and bool(names) and not any(depends_on(value, name) for value in values for name in names)
