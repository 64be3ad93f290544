"""A couple against the turning of two bodies relative to each other."""

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import names
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import BODIES, Element, between_bodies, own_letter


def _told(element: Element, problem: Problem) -> str:
    return "" if "omega" in names(element["size"]) else "_dry"


KIND = element(
    __name__,
    "a couple against the turning of two bodies relative to each other: dry friction in a hinge, rolling resistance, "
    "drag; “sense” is needed where they start from rest and the size is no multiple of the rate",
    rules=(between_bodies, own_letter("omega")),
    drawn="turn",
    told=_told,
    **BODIES,
    size="torque in omega (angular speed), nonnegative, of forces: its magnitude, in which omega is the rate at which they "
    "turn: “M_f”, “k*omega**2”, “b*N” with unknown forces",
    sense="one of auto | ccw | cw = auto: how the second turns, seen from the first; auto: as at the start",
)
