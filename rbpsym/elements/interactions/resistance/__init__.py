"""A force against the motion of a point."""

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import ZERO, names
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import Element, on_a_body, own_letter


def _told(element: Element, problem: Problem) -> str:
    return "_in" if element["medium"] != (ZERO, ZERO) else "" if "v" in names(element["size"]) else "_dry"


KIND = element(
    __name__,
    "a force against the motion of a point: drag of the air, dry friction; where the point starts from rest and the "
    "size is no multiple of its speed, “toward” says which way it goes",
    rules=(on_a_body("on"), own_letter("v")),
    drawn="arrow",
    told=_told,
    on="point: the point of a body at which it acts",
    size="force in v (speed), nonnegative, of forces: its magnitude, in which v is the speed of the point: “c*v”, "
    "“k*v**2”, “mu*N” with unknown forces",
    medium="pair of speed = 0 | 0: velocity of what it moves through",
    toward="pair of number, optional: a vector to the side to which it moves; absent: as at the start",
)
