"""The numbers that a reader may change: where they begin, how far they go, their units."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from rbpsym.explorer.stage import start_name
from rbpsym.expr import tree as t
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.numbers import bound, sample
from rbpsym.mechanics.study import Study
from rbpsym.quantities import ENERGY, NUMBER, Dimension, Quantity
from rbpsym.statement import printed_units
from rbpsym.statement.model import Coordinate, Element, Problem
from rbpsym.statement.printed_units import unit_text

DEGREE = math.pi / 180


class Slider(Frozen):
    """An adjustable number in SI units (angles in radians); shown it is value / `unit_size` `unit`."""

    name: str
    symbol: t.Node
    meaning: str
    value: float
    least: float
    most: float
    unit: str = ""
    unit_size: float = 1.0


def unit_of(dimension: Dimension) -> str:
    """The SI unit of a dimension as it is shown; that of an energy is that of a torque too."""
    return unit_text(printed_units.unit_of(dimension, "torque" if dimension == ENERGY else ""))


def sliders(study: Study) -> tuple[Slider, ...]:
    """Parameters, constants of the start, and starts that the author left open; the example's numbers to begin with."""
    problem = study.problem
    numbers = sample(problem, problem.example)
    starts = {c.start.name: c for c in problem.coordinates if getattr(c.start, "name", None) in problem.implicit}
    turned = angles(problem)
    found = [
        _start(q.name, starts[q.name], numbers) if q.name in starts else _parameter(q, numbers, turned)
        for q in problem.parameters
    ]
    return tuple(found) + tuple(_open_starts(study, numbers))


def _parameter(quantity: Quantity, numbers: Mapping[str, float], turned: frozenset[str]) -> Slider:
    value, symbol = numbers[quantity.name], t.Sym(quantity.name)
    if quantity.dimension == NUMBER and quantity.name in turned:
        least, most = (-1.4, 1.4) if quantity.sign == "real" else (0.02, max(1.4, 1.1 * value))
        return Slider(quantity.name, symbol, quantity.meaning, value, least, most, "°", DEGREE)
    least, most = _around(value, quantity.sign)
    return Slider(quantity.name, symbol, quantity.meaning, value, least, most, unit_of(quantity.dimension))


def _around(value: float, sign: str) -> tuple[float, float]:
    """From a fifth to three times a positive number; both signs where both are allowed."""
    if sign in ("positive", "nonnegative") and value > 0:
        return (0.0 if sign == "nonnegative" else value / 5), 3 * value
    size = 3 * abs(value) or 1.0
    return (0.0 if sign == "nonnegative" else -size), size


def _start(name: str, coordinate: Coordinate, numbers: Mapping[str, float]) -> Slider:
    """A start inside the range of its coordinate."""
    quantity, value = coordinate.quantity, numbers[name]
    least, most = _room(coordinate, value, numbers)
    unit, size = ("°", DEGREE) if quantity.dimension == NUMBER else (unit_of(quantity.dimension), 1.0)
    return Slider(name, t.Sym(name), quantity.meaning, value, least, most, unit, size)


def _room(coordinate: Coordinate, value: float, numbers: Mapping[str, float]) -> tuple[float, float]:
    """The range of a coordinate without its ends; a guess where it has none."""
    wide = math.pi if coordinate.quantity.dimension == NUMBER else 3 * abs(value) or 1.0
    low, high = (bound(node, numbers) for node in (coordinate.lower, coordinate.upper))
    low = min(value, -wide) if low is None else low
    high = max(value, wide, low + 2 * wide if coordinate.lower else wide) if high is None else high
    edge = 0.01 * (high - low)
    return min(value, low + edge), max(value, high - edge)


def _open_starts(study: Study, numbers: Mapping[str, float]) -> Iterator[Slider]:
    """Coordinates of which the author does not say where they start."""
    for coordinate in study.problem.coordinates:
        if coordinate.name in study.system.independent and coordinate.start is None:
            own = {**numbers, start_name(coordinate.name): numbers[coordinate.name]}
            found = _start(start_name(coordinate.name), coordinate, own)
            at = t.At(t.Sym(coordinate.name), t.equation(t.Sym("t"), t.ZERO))
            yield replace(found, symbol=at)


def angles(problem: Problem) -> frozenset[str]:
    """Names that stand under a sine, cosine or tangent anywhere in the statement."""
    nodes = [node for body in problem.bodies for node in _body_nodes(body)]
    nodes += [node for e in problem.elements for node in _element_nodes(e)]
    turned = [part.arg for node in nodes for part in t.walk(node) if isinstance(part, t.Fn) and part.name in TURNS]
    found = {leaf.name for arg in turned for leaf in t.walk(arg) if isinstance(leaf, t.Sym)}
    return frozenset(found | {name for name, text in problem.example.items() if str(text).endswith(("deg", "°"))})


TURNS = frozenset({"sin", "cos", "tan"})


def _body_nodes(body) -> list[t.Node]:
    placed = list(body.placed[1]) if body.placed else []
    return [*placed, *([body.angle] if body.angle is not None else [])]


def _element_nodes(element: Element) -> Iterator[t.Node]:
    for value in element.values.values():
        line = (value.a, value.b, value.c) if hasattr(value, "a") and hasattr(value, "c") else ()
        parts = value if isinstance(value, tuple) else (value, *line)
        yield from (part for part in parts if isinstance(part, t.Node))
