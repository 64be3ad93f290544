"""A linear spring."""

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import ZERO
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import POINTS, Element, between_points


def _told(element: Element, problem: Problem) -> str:
    return "_short" if element["natural_length"] == ZERO else ""


KIND = element(
    __name__,
    "a linear spring between two points: force stiffness × (distance − natural length)",
    rules=(between_points,),
    drawn="link",
    told=_told,
    **POINTS,
    stiffness="stiffness, positive: force per elongation",
    natural_length="length, nonnegative = 0: length at which it is slack",
)
