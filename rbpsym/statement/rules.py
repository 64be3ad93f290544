"""What the kinds share of their data: keys, unknown forces, and rules for what two keys must not be together."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.expr.tree import ONE, names
from rbpsym.statement.model import Body, Element, PointRef
from rbpsym.statement.premises import sign_of, surely_above
from rbpsym.statement.scope import Scope

Bodies = Mapping[str, Body]
Rule = Callable[[Element, Scope, Bodies], Element | None]  # refuses, or gives the element with what follows from the poses

COMPONENTS = {"{name}_x": "force", "{name}_y": "force"}
COUPLE = {"{couple}": "torque"}
COUPLE_NAME = {"couple": "name = tau_{name}: name of the unknown couple"}
POINTS = {"between": "points: the two points that it joins"}
RESTITUTION = {"restitution": "number = 1: speed of parting over speed of approach"}
BODIES = {"between": "two bodies: the two bodies that it joins; one may be “ground”"}


def bodies_joined(element: Element, key: str) -> tuple[str | None, str | None]:
    """The bodies of two points; None for a fixed place."""
    first, second = element[key]
    return first.body, second.body


def on_a_body(key: str) -> Rule:
    """The point under `key` must belong to a body."""

    def rule(element: Element, scope: Scope, bodies: Bodies) -> None:
        point: PointRef = element[key]
        if point.body is None:
            raise element.error(f"acts on “{point.label}”, a fixed place", "name a point of a body: rod.end.")

    return rule


def between_points(element: Element, scope: Scope, bodies: Bodies) -> None:
    """The ends of what joins two points can move against each other."""
    first, second = bodies_joined(element, "between")
    if first == second:
        what = "joins two fixed places" if first is None else f"joins two points of one body, “{first}”"
        raise element.error(what, "at least one end must be able to move against the other.")


def between_bodies(element: Element, scope: Scope, bodies: Bodies) -> None:
    """Two bodies that can turn, or one and the ground."""
    first, second = element["between"]
    if first == second:
        raise element.error(f"joins “{first}” to itself", "name two different bodies, or “ground” and a body.")
    for name in (first, second):
        if name in bodies and bodies[name].shape.kind == "particle":
            raise element.error(f"acts on “{name}”, a particle, which has no angle", "name a body that can turn.")


def turns(key: str) -> Rule:
    """The body under `key` (if any) must be able to turn."""

    def rule(element: Element, scope: Scope, bodies: Bodies) -> None:
        name = element[key]
        if name is not None and bodies[name].shape.kind == "particle":
            raise element.error(f"acts on “{name}”, a particle, which has no angle", "name a body that can turn.")

    return rule


def joins_two(element: Element, scope: Scope, bodies: Bodies) -> None:
    """Points of two bodies, or of one and a fixed place."""
    first, second = bodies_joined(element, "points")
    if first is not None and first == second:
        raise element.error(f"joins the body “{first}” to itself", "name points of two different bodies.")
    if first is None and second is None:
        raise element.error("joins two fixed places", "name a point of a body.")


def own_letter(letter: str) -> Rule:
    """The letter for the speed in a size means nothing else."""

    def rule(element: Element, scope: Scope, bodies: Bodies) -> None:
        if letter in names(element["size"]) and letter in (*scope.parameters, *scope.coordinates, *scope.forces):
            what = f"has a size with “{letter}”, which is the speed there, and the name of a quantity of the problem"
            raise element.error(what, "give the quantity another name.")

    return rule


def restitution(element: Element, scope: Scope, bodies: Bodies) -> None:
    """Between 0 and 1, as far as that is known."""
    for key in ("restitution", "tangential"):
        value = element.values.get(key, ONE)
        if sign_of(value, scope.given) == "negative" or surely_above(value, ONE, scope.given):
            fault = "has a restitution that is not between 0 and 1"
            raise element.error(fault, "0: they part with one speed, 1: no energy is lost.")
