"""The weights of bodies."""

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import ONE, TWO, ZERO, Neg, Pow, add, neg
from rbpsym.statement.model import Problem
from rbpsym.statement.premises import sign_of
from rbpsym.statement.rules import Bodies, Element, Scope

DOWN = (ZERO, Neg(ONE))


def _unit_direction(element: Element, scope: Scope, bodies: Bodies) -> None:
    """A direction has the length 1 (for numbers that are not all known, it may have it)."""
    excess = add(*(Pow(part, TWO) for part in element["direction"]), neg(ONE))
    if element["direction"] != DOWN and sign_of(excess, scope.given) in ("positive", "negative", "nonzero"):
        raise element.error("has a direction that is no unit vector", 'write direction = ["0", "-1"]')


def _told(element: Element, problem: Problem) -> str:
    return "" if element["direction"] == DOWN else "_along"


KIND = element(
    __name__,
    "uniform gravity: the weight of each body, at its centre of mass",
    rules=(_unit_direction,),
    told=_told,
    g="acceleration = g: its acceleration",
    direction="pair of number = 0 | -1: unit vector along which things fall",
    bodies="bodies = all: the bodies that it acts on",
)
