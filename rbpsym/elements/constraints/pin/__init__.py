"""Points of two bodies joined so that these can turn against each other."""

from rbpsym.elements.kinds import element
from rbpsym.statement.rules import COMPONENTS, Bodies, Element, Scope, joins_two


def _no_fixed_place(element: Element, scope: Scope, bodies: Bodies) -> None:
    for point in element["points"]:
        if point.body is None:
            raise element.error(f"joins a body to “{point.label}”, a fixed place", 'use type = "pivot" for this.')


KIND = element(
    __name__,
    "a point of one body is joined to a point of another, free to turn; the force is on the second",
    "bearing",
    unknowns=COMPONENTS,
    rules=(_no_fixed_place, joins_two),
    holds="joint",
    drawn="pin",
    points="points: the two points that coincide, of two bodies",
)
