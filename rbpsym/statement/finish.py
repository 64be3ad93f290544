"""What a kind leaves to its surroundings, and what two of its fields must not be together."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.expr.tree import ONE, TWO, ZERO, Neg, Pow, add, names, neg
from rbpsym.statement.curves import CURVE_RULES, Rule
from rbpsym.statement.model import Body, Element, Pair, PointRef
from rbpsym.statement.premises import sign_of
from rbpsym.statement.scope import Scope


def finish(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
    """The element with what follows from the poses; refused if its fields contradict each other."""
    for rule in _RULES.get(element.kind, ()):
        element = rule(element, scope, bodies) or element  # most rules only refuse
    return element


def bodies_joined(element: Element, key: str) -> tuple[str | None, str | None]:
    """The bodies of two points; None for a fixed place."""
    first, second = element[key]
    return first.body, second.body


def _on_a_body(key: str) -> Rule:
    """The point under `key` must belong to a body."""

    def rule(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
        point: PointRef = element[key]
        if point.body is None:
            raise element.error(f"acts on “{point.label}”, a fixed place", "name a point of a body: rod.end.")

    return rule


def _between_points(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    first, second = bodies_joined(element, "between")
    if first == second:
        what = "joins two fixed places" if first is None else f"joins two points of one body, “{first}”"
        raise element.error(what, "at least one end must be able to move against the other.")


def _between_bodies(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    first, second = element["between"]
    if first == second:
        raise element.error(f"joins “{first}” to itself", "name two different bodies, or “ground” and a body.")
    for name in (first, second):
        if name in bodies and bodies[name].shape.kind == "particle":
            raise element.error(f"acts on “{name}”, a particle, which has no angle", "name a body that can turn.")


def _turns(key: str) -> Rule:
    """The body under `key` (if any) must be able to turn."""

    def rule(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
        name = element[key]
        if name is not None and bodies[name].shape.kind == "particle":
            raise element.error(f"acts on “{name}”, a particle, which has no angle", "name a body that can turn.")

    return rule


def _own_letter(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """The letter for the speed in a size means nothing else."""
    letter = {"resistance": "v", "resisting-couple": "omega"}[element.kind]
    if letter in names(element["size"]) and letter in (*scope.parameters, *scope.coordinates, *scope.forces):
        what = f"has a size with “{letter}”, which is the speed there, and the name of a quantity of the problem"
        raise element.error(what, "give the quantity another name.")


def _other_body(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    if element["on"] == element["reaction_on"]:
        raise element.error(f"acts on “{element['on']}” and reacts on it as well", "name another body.")


def _pivot_place(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
    """Where the pose puts the point; None if only the mechanics can tell."""
    if element["at"] is not None:
        return element
    point: PointRef = element["point"]
    body = bodies[point.body or ""]
    if body.placed is None:
        raise element.error(f"does not say where “{point.label}” is held", 'add at = ["0", "0"]')
    if body.placed[0] != point.point:
        return element
    _check_fixed(element, point, body.placed[1], scope)
    return element.with_values(at=body.placed[1])


def _check_fixed(element: Element, point: PointRef, place: Pair, scope: Scope) -> None:
    moving = sorted((names(place[0]) | names(place[1])) & set(scope.coordinates))
    if moving:
        raise element.error(
            f"holds “{point.label}”, but the pose lets it move with “{moving[0]}”",
            'say where it is held: at = ["0", "0"]',
        )


def _joins_two(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    first, second = bodies_joined(element, "points")
    if first is not None and first == second:
        raise element.error(f"joins the body “{first}” to itself", "name points of two different bodies.")
    if first is None and second is None:
        raise element.error("joins two fixed places", "name a point of a body.")


def _along_another(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    if element["point"].body == element["of"]:
        raise element.error(f"drives a point of “{element['of']}” along that body itself", "name a point of another body.")


def _no_fixed_place(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    for point in element["points"]:
        if point.body is None:
            raise element.error(f"joins a body to “{point.label}”, a fixed place", 'use type = "pivot" for this.')


def _no_particle(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    for point in element["points"]:
        if point.body and bodies[point.body].shape.kind == "particle":
            raise element.error(f"fixes the angle of “{point.body}”, a particle, which has none", "use a pin.")


def _weld_angle(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> Element:
    """0 unless both angles are in the poses (the ground has one)."""
    known = all(point.body is None or bodies[point.body].angle is not None for point in element["points"])
    return element if known or element["angle"] is not None else element.with_values(angle=ZERO)


DOWN = (ZERO, Neg(ONE))


def _unit_direction(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    """A direction has the length 1 (for numbers that are not all known, it may have it)."""
    squares = (Pow(part, TWO) for part in element["direction"])
    if element["direction"] != DOWN and sign_of(add(*squares, neg(ONE)), scope.given) in (
        "positive",
        "negative",
        "nonzero",
    ):
        raise element.error("has a direction that is no unit vector", 'write direction = ["0", "-1"]')


def _body_frame(element: Element, scope: Scope, bodies: Mapping[str, Body]) -> None:
    name = element["on"].body
    if element["frame"] == "body" and bodies[name].shape.kind == "particle":
        raise element.error(f"is fixed in “{name}”, a particle, which has no angle", 'use frame = "space".')


_RULES: Mapping[str, tuple[Rule, ...]] = {
    "gravity": (_unit_direction,),
    "spring": (_between_points,),
    "damper": (_between_points,),
    "pull": (_between_points,),
    "torsion-spring": (_between_bodies,),
    "rotary-damper": (_between_bodies,),
    "force": (_on_a_body("on"), _body_frame),
    "couple": (_turns("on"), _turns("reaction_on"), _other_body),
    "resistance": (_on_a_body("on"), _own_letter),
    "resisting-couple": (_between_bodies, _own_letter),
    "pivot": (_on_a_body("point"), _pivot_place),
    "pin": (_no_fixed_place, _joins_two),
    "prescribed": (_on_a_body("point"), _along_another),
    "weld": (_joins_two, _no_particle, _weld_angle),
    **CURVE_RULES,
}
