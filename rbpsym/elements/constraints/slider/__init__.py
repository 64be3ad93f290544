"""A body that slides along a line and does not turn."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import LINE, NORMAL, OF, SIDE, SLIDING, as_touching, one_curve, slides, two_bodies
from rbpsym.statement.rules import COUPLE, COUPLE_NAME, Bodies, Element, Scope


def _has_angle(element: Element, scope: Scope, bodies: Bodies) -> None:
    name = element["point"].body
    if name is None or bodies[name].shape.kind == "particle":
        raise element.error("must lead a point of a body that has an angle", 'a particle needs type = "contact" or "guide".')


KIND = element(
    __name__,
    "a body slides along a line without turning; the force is normal to the line, a couple keeps the angle",
    unknowns=NORMAL | COUPLE,
    rules=(_has_angle, one_curve, two_bodies, slides),
    holds="contact",
    drawn="slider",
    told=as_touching,
    point="point: the point that is on the line",
    **(LINE | SIDE | OF | SLIDING | COUPLE_NAME),
)
