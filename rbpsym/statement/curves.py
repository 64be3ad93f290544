"""What constraints on curves share: their keys, and what they must say: one curve, a body that can touch it, and a way to."""

from __future__ import annotations

from rbpsym.elements.shapes import PARTLY_ROUND
from rbpsym.statement.model import Element, Problem
from rbpsym.statement.paths import round_size, runs
from rbpsym.statement.premises import sign_of, surely_above
from rbpsym.statement.rules import Bodies, Rule
from rbpsym.statement.scope import Scope

NORMAL = {"{name}": "force"}
ROUGH = {**NORMAL, "{friction}": "force"}
OF = {"of": "body, optional: the body to which the line belongs, x and y being its own; absent: it is fixed"}
LINE = {"line": "line, optional: the line that is touched, as an equation in x and y: “y = 0”"}
SIDE = {
    "side": "one of auto | positive | negative | outside | inside = auto: side to which the force pushes: of a line, positive is "
    "where the left side of the equation is the greater one; of a circle, outside or inside; auto: where the body is"
}
CURVE = {
    **OF,
    "circle": "point, optional: instead of a line: the centre of the circle that is touched",
    "radius": "length, nonnegative, optional: radius of that circle; absent: that of the round body whose centre it is; 0 for a "
    "corner that a round body touches",
}
BENT = {
    "curve": "curve, optional: instead of a line: a smooth fixed curve, “y = x**2/(2*p)”, or two functions of a coordinate, "
    '["R*cos(q)", "b*sin(q)"]; its positive side is above it (to the left, as the coordinate grows)'
}
FRICTION = {"friction": "name = f_{name}: name of the force of friction"}
SLIDING = {
    "coefficient": "number, nonnegative, optional: coefficient of kinetic friction; absent: smooth",
    "slip": "one of auto | forward | backward = auto: the sense in which it slips, seen with the normal upwards: forward is to "
    "the right; auto: as at the start",
    **FRICTION,
}
LIMIT = {"limit": "number, nonnegative, optional: coefficient of static friction; absent: as much as is needed"}
POINT = {"point": "point: the point that touches"}
ROUND = {"body": "body: the round body that touches"}
RIM = {"rim": "length, positive, optional: radius at which it touches; absent: its own"}

TOUCHED = LINE | SIDE | CURVE

_ALONG = ("auto", "positive", "negative")
_SIDES = {"curve": _ALONG, "line": _ALONG, "circle": ("auto", "outside", "inside")}
_SOLID = ("disk", "cylinder", "ball", "sphere")


def toucher(element: Element) -> str | None:
    """The body that touches (None: a fixed point touches)."""
    found: str | None = element["body"] if "body" in element.values else element["point"].body
    return found


def curve_body(element: Element) -> str | None:
    """The body to which the curve belongs; None if it is fixed."""
    circle = element.values.get("circle")
    found: str | None = circle.body if circle is not None else element["of"]
    return found


def is_slot(element: Element) -> bool:
    """Whether a point is led in it: a slot has no side to which it pushes."""
    return "side" not in element.values


def one_curve(element: Element, scope: Scope, bodies: Bodies) -> Element:
    """A line, a circle or a curve, only one, and the words that go with it."""
    found = [what for what in _SIDES if element.values.get(what) is not None]
    if len(found) != 1:
        fault = f"has both a {found[1]} and a {found[0]}" if found else "touches nothing"
        raise element.error(fault, 'write line = "y = 0", or circle = "O" and radius = "R".')
    [what] = found
    if element.values.get("side", "auto") not in _SIDES[what]:
        raise element.error(
            f"has the side “{element['side']}”, which a {what} hasn't",
            f"write one of: {', '.join(_SIDES[what])}.",
        )
    if what == "circle" and element["of"] is not None:
        raise element.error("has both “of” and a circle", 'write circle = "cylinder.center"; that names the body.')
    if what == "curve" and element["of"] is not None:
        raise element.error("has a curve that moves with a body", "only a fixed curve can be followed: leave “of” out.")
    if what == "curve" and element.values.get("side") == "auto":
        return element.with_values(side="positive")
    return element


def circle_size(element: Element, scope: Scope, bodies: Bodies) -> Element:
    """The radius of the circle: stated, or that of the round body whose centre it is."""
    circle = element.values.get("circle")
    if circle is None:
        if element.values.get("radius") is not None:
            raise element.error("has a radius, but touches a line", "remove it (the radius of the body is “rim”).")
        return element
    own = round_size(bodies[circle.body]) if circle.body and circle.point in ("center", "cm") else None
    if element["radius"] is None and own is None:
        raise element.error(f"does not say how large the circle about “{circle.label}” is", 'add radius = "R"')
    if (
        element["radius"] is not None
        and "rim" not in element.values
        and sign_of(element["radius"], scope.given) == "zero"
    ):
        cure = "to hold it at that place, write a pivot; for a corner that touches a round body, name the corner as "
        raise element.error("touches a circle of radius 0", cure + 'its point and circle = "wheel.center".')
    return element if element["radius"] is not None else element.with_values(radius=own)


def two_bodies(element: Element, scope: Scope, bodies: Bodies) -> None:
    """What touches must be able to move against the curve."""
    first, second = toucher(element), curve_body(element)
    if first == second:
        what = "joins a fixed point to a fixed curve" if first is None else f"lets “{first}” touch itself"
        raise element.error(what, "name the point of one body, and a curve that is fixed or belongs to another.")


def rim_size(element: Element, scope: Scope, bodies: Bodies) -> Element:
    """The radius at which a round body touches; a half disk or half ring does so with its round side."""
    body = bodies[element["body"]]
    own = round_size(body) or (body.shape.sizes["radius"] if body.shape.kind in PARTLY_ROUND else None)
    if element["rim"] is None and own is None:
        cure = "give it the shape disk, ring, ball, shell or annulus" + (
            "." if body.shape.kind == "particle" else ', or say at which radius it touches: rim = "R"'
        )
        raise element.error(f"needs a round body, but “{body.name}” ({body.shape.kind}) has no radius", cure)
    if "center" not in body.points:
        raise element.error(
            f"needs a body with a center, but “{body.name}” has none", "add points = { center = [...] }."
        )
    if body.shape.kind == "particle":
        raise element.error(f"can't turn “{body.name}”, a particle", "give it the shape disk, ring or ball.")
    return element if element["rim"] is not None else element.with_values(rim=own)


def apart(element: Element, scope: Scope, bodies: Bodies) -> Element:
    """Two solid bodies are never one inside the other: they touch from outside unless another radius is meant."""
    circle = element.values.get("circle")
    if circle is None or circle.body is None or element["side"] != "auto":
        return element
    one, other = bodies[element["body"]], bodies[circle.body]
    solid = one.shape.kind in _SOLID and other.shape.kind in _SOLID and element["radius"] == round_size(other)
    return element.with_values(side="outside") if solid and circle.point in ("center", "cm") else element


def room(element: Element, scope: Scope, bodies: Bodies) -> None:
    """Inside a circle there is room for smaller bodies only."""
    if element.values.get("circle") is None or element["side"] != "inside":
        return
    if surely_above(element["rim"], element["radius"], scope.given, or_equal=True):
        raise element.error(
            "has no room: the body is not smaller than the circle", 'use side = "outside", or another radius.'
        )


def slides(element: Element, scope: Scope, bodies: Bodies) -> None:
    """A sense of slip goes with friction."""
    if element["slip"] != "auto" and element["coefficient"] is None:
        raise element.error("says which way it slips, but has no friction", 'add coefficient = "mu"')


def string_path(element: Element, scope: Scope, bodies: Bodies) -> None:
    """Two neighbours on the path are different things; something can move; a length is between points."""
    path = element["path"]
    for first, second in zip(path, path[1:], strict=False):
        if first.body == second.body and (first.body is not None or first.center == second.center):
            raise element.error(
                f"runs from “{first.center.label}” to itself", "name the next body or point on its way."
            )
    if all(turn.body is None for turn in path):
        raise element.error("joins only fixed places", "let it end at a point of a body.")
    if tied := next((turn.center.label for turn in path[1:-1] if turn.body is None and turn.grips), ""):
        hint = f'for a smooth peg there write {{ around = "{tied}" }}; what is tied there is two strings.'
        raise element.error(f"runs on from the fixed point “{tied}”, to which it is tied", hint)
    if element["length"] is not None and (len(path) != 2 or any(turn.sense for turn in path)):
        raise element.error("has a length, but is no straight piece between two points", "remove the length.")
    for turn in runs(path)[0][:1] + runs(path)[-1][-1:]:
        if not turn.grips:
            raise element.error(
                f"ends on “{turn.center.label}”, over which it slides", "let it end at a point or on a drum."
            )


def as_touching(element: Element, problem: Problem) -> str:
    """How it is told that something touches: what has another contact beside it, friction, a fixed edge on which a body lies."""
    beside = any(other.values.get("beside") == element.name for other in problem.constraints)
    edge = "point" in element.values and element["point"].body is None and element["of"]
    rough = element.values.get("coefficient") is not None
    return ("_rough" if rough else "_beside" if beside else "") + "_on_point" * bool(edge)


ON_CURVE: tuple[Rule, ...] = (one_curve, circle_size, two_bodies)
ROUND_ON_CURVE = (*ON_CURVE, rim_size, apart, room)
