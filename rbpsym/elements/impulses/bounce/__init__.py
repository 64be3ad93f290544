"""A body that meets a line or a circle, or a string that goes taut, for an instant."""

from dataclasses import replace

from rbpsym.elements.kinds import element
from rbpsym.expr.tree import ZERO
from rbpsym.statement.curves import ON_CURVE, RIM, ROUND_ON_CURVE, TOUCHED, slides, string_path
from rbpsym.statement.model import Problem
from rbpsym.statement.rules import RESTITUTION, Bodies, Element, Scope, restitution


def _meets(element: Element, scope: Scope, bodies: Bodies) -> Element:
    """A point or a round body that touches a line or a circle, or a string: read as such a constraint is."""
    ways = [key for key in ("point", "body", "path") if element[key] is not None]
    if len(ways) != 1:
        raise element.error("must say what meets: a point, a round body or a path, one of them", 'write body = "ball".')
    others = {"point", "body", "path", *((*TOUCHED, *RIM) if ways == ["path"] else ("length",))}
    found = replace(element, values={key: value for key, value in element.values.items() if key not in others - {*ways}})
    if ways == ["path"]:
        if element["length"] is None:
            raise element.error("does not say how long the string is", 'add length = "L".')
        if element["coefficient"] is not None or element["slip"] != "auto":
            raise element.error("is that of a string, which has no friction", "leave coefficient and slip out.")
        string_path(found, scope, bodies)
        return found
    if element["tangential"] != ZERO and element["slip"] != "none":
        raise element.error("slips, and has a tangential restitution", 'write slip = "none", or leave “tangential” out.')
    for rule in (ROUND_ON_CURVE if ways == ["body"] else ON_CURVE) + (slides,) * (element["slip"] != "none"):
        found = rule(found, scope, bodies) or found
    return found


def _told(element: Element, problem: Problem) -> str:
    return "_taut" if "path" in element.values else ""


KIND = element(
    __name__,
    "a body meets a line or a circle, or a string between two points goes taut, for an instant; with friction, if there is some",
    unknowns={"{name}": "impulse"},
    rules=(_meets, restitution),
    told=_told,
    point="point, optional: the point that touches",
    body="body, optional: or the round body that does",
    **(TOUCHED | RIM),
    path="path, optional: or the two points that a string joins",
    length="length, positive, optional: length of the string",
    **RESTITUTION,
    coefficient="number, nonnegative, optional: coefficient of friction: that of its impulse over the normal one; absent: "
    "smooth, or as much as is needed",
    slip="one of auto | forward | backward | none = auto: the sense in which it slips as long as they touch, seen with the "
    "normal upwards: forward is to the right; auto: as just before; none: it does not slip as they part",
    tangential="number = 0: where it does not slip: speed of slip just after over that just before, which is opposite",
    friction="name = f_{name}: name of the impulse of friction",
)
