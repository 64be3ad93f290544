"""A body fixed to another, or to a place."""

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import ZERO
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import COMPONENTS, COUPLE, COUPLE_NAME, Bodies, Element, Scope, joins_two


def _no_particle(element: Element, scope: Scope, bodies: Bodies) -> None:
    for point in element["points"]:
        if point.body and bodies[point.body].shape.kind == "particle":
            raise element.error(f"fixes the angle of “{point.body}”, a particle, which has none", "use a pin.")


def _angle(element: Element, scope: Scope, bodies: Bodies) -> Element:
    """0 unless both angles are in the poses (the ground has one)."""
    known = all(point.body is None or bodies[point.body].angle is not None for point in element["points"])
    return element if known or element["angle"] is not None else element.with_values(angle=ZERO)


def _told(element: Element, problem: Problem) -> str:
    return "" if all(point.body for point in element["points"]) else "_ground"


KIND = element(
    __name__,
    "a body is fixed to another, or to a place; force and couple are on the second (or on the body)",
    unknowns=COMPONENTS | COUPLE,
    rules=(joins_two, _no_particle, _angle),
    holds="joint",
    drawn="weld",
    told=_told,
    points="points: the two points that coincide; one may be a fixed place",
    angle="angle, optional: angle of the second body minus that of the first; absent: as in the poses if they have both, "
    "else 0",
    **COUPLE_NAME,
)
