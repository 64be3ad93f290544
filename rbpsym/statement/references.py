"""References to bodies and points: “rod.end”, “disk.cm”, “O”, or a place in space."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.quantities import LENGTH
from rbpsym.statement.model import Body, PointRef
from rbpsym.statement.scope import Scope, read_pair
from rbpsym.statement.source import Item, did_you_mean, kind_of

CM = "cm"
GROUND = "ground"


def read_point(item: Item, scope: Scope, bodies: Mapping[str, Body], what: str) -> PointRef:
    """A point of a body, a fixed point by name, or a place as a pair."""
    if isinstance(item.value, (list, tuple)):
        place = read_pair(item, scope, what, LENGTH)
        return PointRef(f"({', '.join(str(part) for part in item.value)})", at=place)
    if not isinstance(item.value, str):
        raise item.error(f"{what} must be a point, not {kind_of(item.value)}", 'write it as "rod.end" or "O"')
    if item.value in scope.points:
        return PointRef(item.value, at=scope.points[item.value])
    return _point_of_body(item, scope, bodies, what)


def _point_of_body(item: Item, scope: Scope, bodies: Mapping[str, Body], what: str) -> PointRef:
    label = item.value
    body, dot, point = label.partition(".")
    if not dot:
        raise _no_point(item, scope, bodies, what)
    if body not in bodies:
        raise item.error_inside(
            f"{what}: there is no body “{body}”", did_you_mean(body, bodies, "bodies"), 1, len(body)
        )
    known = points_of(bodies[body])
    if point not in known:
        raise item.error_inside(
            f"{what}: “{body}” has no point “{point}”",
            did_you_mean(point, known, "its points"),
            len(body) + 2,
            len(point),
        )
    return PointRef(label, body, point)


def _no_point(item: Item, scope: Scope, bodies: Mapping[str, Body], what: str) -> Exception:
    name = item.value
    if name in bodies:
        choices = ", ".join(f"{name}.{point}" for point in points_of(bodies[name]))
        return item.error(f"{what}: “{name}” is a body, not a point", f"its points: {choices}.")
    known = [*scope.points, *(f"{body.name}.{point}" for body in bodies.values() for point in points_of(body))]
    return item.error(f"{what}: there is no point “{name}”", did_you_mean(name, known, "points"))


def points_of(body: Body) -> list[str]:
    """Names of the points of a body, its centre of mass among them."""
    return [*body.points, CM]


def read_body(item: Item, bodies: Mapping[str, Body], what: str, others: tuple[str, ...] = ()) -> str:
    """The name of a body (or one of `others`)."""
    known = [*bodies, *others]
    if item.value not in known:
        found = f"“{item.value}”" if isinstance(item.value, str) else kind_of(item.value)
        raise item.error(f"{what}: {found} is not a body", did_you_mean(str(item.value), known, "bodies"))
    return item.value
