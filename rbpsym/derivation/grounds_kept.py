"""What decides whether a sentence about what is kept is true: forces and impulses that drop out, one by one."""

from __future__ import annotations

from rbpsym.algebra import NOTHING, depends_on, is_zero
from rbpsym.derivation.grounds import Said, is_proved
from rbpsym.notation import tree as t


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
