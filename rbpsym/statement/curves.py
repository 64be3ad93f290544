"""What a constraint on a curve must say: one curve, a body that can touch it, and a way to touch it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from rbpsym.expr.tree import ZERO
from rbpsym.statement.model import Body, Element
from rbpsym.statement.paths import round_size, runs
from rbpsym.statement.premises import sign_of, surely_above
from rbpsym.statement.scope import Scope
from rbpsym.statement.shapes import PARTLY_ROUND

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


def one_curve(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
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


def circle_size(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
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


def two_bodies(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """What touches must be able to move against the curve."""
    first, second = toucher(element), curve_body(element)
    if first == second:
        what = "joins a fixed point to a fixed curve" if first is None else f"lets “{first}” touch itself"
        raise element.error(what, "name the point of one body, and a curve that is fixed or belongs to another.")


def rim_size(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
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


def apart(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
    """Two solid bodies are never one inside the other: they touch from outside unless another radius is meant."""
    circle = element.values.get("circle")
    if circle is None or circle.body is None or element["side"] != "auto":
        return element
    one, other = bodies[element["body"]], bodies[circle.body]
    solid = one.shape.kind in _SOLID and other.shape.kind in _SOLID and element["radius"] == round_size(other)
    return element.with_values(side="outside") if solid and circle.point in ("center", "cm") else element


def room(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """Inside a circle there is room for smaller bodies only."""
    if element.values.get("circle") is None or element["side"] != "inside":
        return
    if surely_above(element["rim"], element["radius"], scope.given, or_equal=True):
        raise element.error(
            "has no room: the body is not smaller than the circle", 'use side = "outside", or another radius.'
        )


def slides(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """A sense of slip goes with friction."""
    if element["slip"] != "auto" and element["coefficient"] is None:
        raise element.error("says which way it slips, but has no friction", 'add coefficient = "mu"')


def has_angle(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """A slider keeps the angle of a body: a particle has none."""
    name = element["point"].body
    if name is None or bodies[name].shape.kind == "particle":
        raise element.error(
            "must lead a point of a body that has an angle", 'a particle needs type = "contact" or "guide".'
        )


def string_path(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """Two neighbours on the path are different things; something can move; a length is between points."""
    path = element["path"]
    for first, second in zip(path, path[1:], strict=False):
        if first.body == second.body and (first.body is not None or first.center == second.center):
            raise element.error(
                f"runs from “{first.center.label}” to itself", "name the next body or point on its way."
            )
    if all(turn.body is None for turn in path):
        raise element.error("joins only fixed places", "let it end at a point of a body.")
    if element["length"] is not None and (len(path) != 2 or any(turn.sense for turn in path)):
        raise element.error("has a length, but is no straight piece between two points", "remove the length.")
    for turn in runs(path)[0][:1] + runs(path)[-1][-1:]:
        if not turn.grips:
            raise element.error(
                f"ends on “{turn.center.label}”, over which it slides", "let it end at a point or on a drum."
            )


def light_rod(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
    """A link is a straight string that may push as well."""
    ends = element["points"]
    if len(ends) != 2 or any(turn.sense for turn in ends):
        raise element.error("must join two points", 'write points = ["O", "bob.center"].')
    values = {"path": ends, "length": element["length"], "rigid": True}
    string_path(replace(element, values=values), scope, bodies)
    return replace(element, kind="string", values=values)


def unit_direction(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """The driven point belongs to a body."""
    if element["point"].body is None:
        raise element.error(f"drives “{element['point'].label}”, a fixed place", "name a point of a body.")


def can_turn(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """The driven body has an angle, and is not driven against itself."""
    if element["of"] == element["body"]:
        raise element.error(f"turns “{element['body']}” against itself", "name another body under “of”, or none.")
    if bodies[element["body"]].shape.kind == "particle":
        raise element.error(f"turns “{element['body']}”, a particle, which has no angle", "name a body that can turn.")


def bounces(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
    """A point or a round body that touches a line or a circle, or a string: read as such a constraint is."""
    ways = [key for key in ("point", "body", "path") if element[key] is not None]
    if len(ways) != 1:
        raise element.error("must say what meets: a point, a round body or a path, one of them", 'write body = "ball".')
    others = {"point", "body", "path", *(("line", "side", "of", "circle", "radius", "rim") if ways == ["path"] else ("length",))}
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
    for rule in CURVE_RULES["rolling" if ways == ["body"] else "sticking"] + (slides,) * (element["slip"] != "none"):
        found = rule(found, scope, bodies) or found
    return found


_ON_CURVE: tuple[Any, ...] = (one_curve, circle_size, two_bodies)
Rule = Callable[[Element, Scope, Mapping[str, Body]], Element | None]
CURVE_RULES: Mapping[str, tuple[Rule, ...]] = {
    "contact": (*_ON_CURVE, slides),
    "guide": _ON_CURVE,
    "slider": (has_angle, one_curve, two_bodies, slides),
    "touch": (*_ON_CURVE, rim_size, apart, room, slides),
    "rolling": (*_ON_CURVE, rim_size, apart, room),
    "gear": (*_ON_CURVE, rim_size, apart, room),
    "sticking": _ON_CURVE,
    "string": (string_path,),
    "link": (light_rod,),
    "prescribed": (unit_direction,),
    "prescribed-angle": (can_turn,),
    "bounce": (bounces,),
}
