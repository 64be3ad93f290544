"""What decides whether a sentence about what is kept is true: forces and impulses that drop out, one by one."""

from __future__ import annotations

from rbpsym.algebra.normal import is_zero
from rbpsym.derivation.grounds import Said, is_proved


def impulses_drop_out(said: Said) -> bool:
    """None of the impulses that are named has a torque about the place of the jump, or a component along its direction."""
    jump, moment = said.step.data["jump"], said.step.data["blow"].moment
    parts = (force.torque(jump.where) if jump.is_turning else jump.where.dot(force.vector) for force in jump.silent)
    return is_proved(said) and all(is_zero(moment.new(part)) for part in parts)
