"""The path of a string: points, and circles with the sense in which it runs round them.

path = ["block.center", "cw pulley", "bob.center"]              # a rough pulley turns with the string
path = ["O", { around = "spool", radius = "r", sense = "ccw" }] # wound on a drum of another radius
path = ["a.center", { around = "O", radius = "R", sense = "cw" }, "b.center"]   # a smooth fixed circle
path = ["a.center", { around = "O" }, "b.center"]               # a smooth peg: a point
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rbpsym.elements.shapes import PARTLY_ROUND
from rbpsym.expr.tree import ZERO, Node
from rbpsym.quantities import LENGTH
from rbpsym.statement.model import Body, Element, PointRef, Turn
from rbpsym.statement.references import read_point
from rbpsym.statement.scope import Scope, read_expression
from rbpsym.statement.source import SourceItem, did_you_mean, kind_of

SENSES = {"cw": -1, "ccw": 1}
_SIZES = ("radius", "outer")
_KEYS = ("around", "sense", "radius", "smooth")
_EXAMPLE = 'write path = ["block.center", "cw pulley", "bob.center"]'


def read_path(item: SourceItem, scope: Scope, bodies: Mapping[str, Body], what: str) -> tuple[Turn, ...]:
    """The places on the path, in order."""
    value = item.value
    if not isinstance(value, (list, tuple)) or len(value) < 2:
        found = f"only {len(value)}" if isinstance(value, (list, tuple)) else kind_of(value)
        raise item.error(f"{what} must be a list of two places or more, not {found}", _EXAMPLE)
    return tuple(_turn(part, scope, bodies, what) for part in item.items())


def _turn(item: SourceItem, scope: Scope, bodies: Mapping[str, Body], what: str) -> Turn:
    value = item.value
    if isinstance(value, Mapping):
        return _stated(item, scope, bodies, what)
    word, space, name = value.partition(" ") if isinstance(value, str) else ("", "", "")
    if space and word in SENSES:
        return _round(item, name.strip(), SENSES[word], None, scope, bodies, what)
    if isinstance(value, str) and value in bodies and round_size(bodies[value]) is not None:
        raise item.error(
            f"{what}: in which sense does the string run round “{value}”?",
            f"write “cw {value}” (clockwise, going along the path) or “ccw {value}”.",
        )
    return Turn(read_point(item, scope, bodies, what), ZERO)


def _stated(item: SourceItem, scope: Scope, bodies: Mapping[str, Body], what: str) -> Turn:
    """{ around = "spool", radius = "r", sense = "ccw", smooth = true }."""
    data = item.value
    unknown = [key for key in data if key not in _KEYS]
    if set(data) == {"around"} and not _is_body(data["around"], bodies):
        return Turn(read_point(_inner(item, "around"), scope, bodies, what), ZERO, grips=False)
    if unknown or "around" not in data or data.get("sense") not in SENSES:
        fault = f"unknown key “{unknown[0]}”" if unknown else "“around” and “sense” (cw or ccw) are needed"
        raise item.error(f"{what}: {fault}", '{ around = "spool", radius = "r", sense = "ccw" }')
    if not isinstance(data.get("smooth", False), bool):
        raise item.error(f"{what}: “smooth” must be true or false", "write smooth = true")
    radius = None
    if "radius" in data:
        radius = read_expression(_inner(item, "radius"), scope, f"“radius” in {what}", LENGTH, sign="positive")
    turn = _round(_inner(item, "around"), data["around"], SENSES[data["sense"]], radius, scope, bodies, what)
    return Turn(turn.center, turn.radius, turn.sense, turn.grips and not data.get("smooth", False))


def _is_body(name: Any, bodies: Mapping[str, Body]) -> bool:
    return isinstance(name, str) and name in bodies


def _inner(item: SourceItem, key: str) -> SourceItem:
    return SourceItem(item.source, (*item.path, key), item.value[key])


def _round(
    item: SourceItem, name: Any, sense: int, radius: Node | None, scope: Scope, bodies: Mapping[str, Body], what: str
) -> Turn:
    """A round body by name, or a circle about a point with its radius (which does not grip)."""
    if _is_body(name, bodies):
        size = radius or round_size(bodies[name])
        if size is None:
            raise item.error(
                f"{what}: “{name}” is no round body", f'give the radius: {{ around = "{name}", radius = "r", ... }}'
            )
        return Turn(PointRef(f"{name}.center", name, "center"), size, sense)
    if radius is None:
        raise item.error(f"{what}: there is no round body “{name}”", did_you_mean(str(name), bodies, "bodies"))
    return Turn(read_point(SourceItem(item.source, item.path, name), scope, bodies, what), radius, sense, grips=False)


def round_size(body: Body) -> Node | None:
    """The outer radius of a round body; None for a body that is not round."""
    if "center" not in body.points or body.shape.kind in PARTLY_ROUND:
        return None
    return next((body.shape.sizes[key] for key in _SIZES if key in body.shape.sizes), None)


def runs(path: tuple[Turn, ...]) -> tuple[tuple[Turn, ...], ...]:
    """The parts of a string with one tension each: from one place that grips to the next."""
    cuts = [0, *(k for k, turn in enumerate(path[1:-1], 1) if turn.grips), len(path) - 1]
    return tuple(path[a : b + 1] for a, b in zip(cuts, cuts[1:], strict=False))


def tensions(element: Element) -> tuple[str, ...]:
    """Names of the unknown tensions of a string: T, or T_1, T_2 ... along the path."""
    count = len(runs(element["path"]))
    return (element.name,) if count == 1 else tuple(f"{element.name}_{k}" for k in range(1, count + 1))
