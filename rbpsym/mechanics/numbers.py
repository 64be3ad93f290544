"""Floating-point values of scalars, and a sample state of a problem to look at.

Used for drawing, for the simulation and to choose between two equally valid conventions
(which side of a line a body is on); never for a verdict.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from typing import Any

from rbpsym.errors import NoNumber, RbpsymError, there
from rbpsym.expr.tree import Fn, Node, Sym, walk
from rbpsym.field import ONE, Poly, Scalar, atoms
from rbpsym.field.elliptic import FUNCTIONS
from rbpsym.field.evaluate import scalar
from rbpsym.quantities import ACCELERATION, ENERGY, NUMBER, Dimension, Quantity
from rbpsym.statement.model import Coordinate, Problem
from rbpsym.statement.units import unit_named, unit_of

Numbers = Mapping[str, float]


class Values:
    """Values of scalars where the names have these numbers, each sine and root computed once."""

    __slots__ = ("functions", "known", "names")

    def __init__(self, names: Numbers, functions: Mapping[str, Callable[[Any], Any]] = FUNCTIONS) -> None:
        self.names, self.known, self.functions = names, {atoms.PI: math.pi}, functions

    def of(self, value: Scalar) -> float:
        """The value (KeyError for a name without a number)."""
        top = self._poly(value.num)
        return top if value.den is ONE else top / self._poly(value.den)

    def row(self, values: Iterable[Scalar]) -> list[float]:
        """Several values."""
        return [self.of(value) for value in values]

    def _poly(self, poly: Poly) -> float:
        total, known = 0.0, self.known
        for m, c in poly.terms.items():
            product = float(c)
            for index, exponent in m:
                base = known[index] if index in known else self._atom(index)
                product *= base if exponent == 1 else base**exponent
            total += product
        return total

    def _atom(self, index: int) -> float:
        found = atoms.atom(index)
        if found.kind == "symbol":
            value = self.names[found.arg]
        else:
            inner = self.of(found.arg) if isinstance(found.arg, Scalar) else self._poly(found.arg)
            value = self.functions[found.kind](inner)
        self.known[index] = value
        return value


def number(value: Scalar, numbers: Numbers) -> float:
    """The value at these numbers. Raises NoNumber where it has none, or a name is missing."""
    try:
        return Values(numbers).of(value)
    except KeyError as error:
        raise NoNumber(f"no number is known for {error}") from None
    except (ArithmeticError, ValueError) as error:  # a pole, or outside of what a function of `math` takes
        raise NoNumber(f"there is no number here: {error}") from None


def sample(problem: Problem, example: Mapping[str, str] | None = None) -> dict[str, float]:
    """Generic numbers for all parameters and coordinates, in the middle of their ranges.

    `example` holds the author's own numbers for some of them ("0.25 m", "60 deg").
    """
    return _filled(problem, {q.name: _parameter(place, q) for place, q in enumerate(problem.parameters)}, example)


def samples(problem: Problem, count: int = 48) -> Iterator[dict[str, float]]:
    """Sample numbers, those with starts near the other ends of their ranges, and others in which the parameters have other sizes,
    the further the later, and the starts other places (the same on every machine)."""
    first = sample(problem)
    yield first
    for k in range(1 if _starts(problem, first, 0) else 2, count):
        size = 1 if k == 1 else 2 + k
        scaled = {q.name: first[q.name] * size ** (2 * _scattered(k, n) - 1) for n, q in enumerate(problem.parameters)}
        yield _filled(problem, scaled, None, k)


def _scattered(k: int, place: int) -> float:
    """Evenly between 0 and 1, by an irrational step for each place."""
    return k * math.sqrt(place + 2.5) % 1


def _filled(problem: Problem, numbers: dict[str, float], example: Mapping[str, str] | None, k: int = 0) -> dict[str, float]:
    _make_room(problem, numbers)
    _keep_bounds(problem, numbers)
    numbers |= _starts(problem, numbers, k)
    numbers |= {name: value for name, text in (example or {}).items() if (value := _read(text)) is not None}
    for coordinate in problem.coordinates:
        numbers[coordinate.name] = _middle(coordinate, numbers)
        numbers[f"{coordinate.name}_dot"] = _speed(coordinate, numbers)
    numbers["t"] = 0.0
    return numbers


def _make_room(problem: Problem, numbers: dict[str, float]) -> None:
    """What rolls inside a circle is smaller than it."""
    for element in problem.constraints:
        if element.values.get("side") == "inside" and element.values.get("rim") is not None:
            radius, rim = (bound(element[key], numbers) for key in ("radius", "rim"))
            name = getattr(element["radius"], "name", None)
            if name in numbers and radius is not None and rim is not None and radius < 2 * rim:
                numbers[name] = 2.3 * rim


def _keep_bounds(problem: Problem, numbers: dict[str, float]) -> None:
    """A parameter with declared bounds lies between them; twice, as a bound may hold a later one. An upper one that is a
    parameter itself, and would be below the lower one, is raised."""
    for quantity in (*problem.parameters, *problem.parameters):
        low, high = (bound(node, numbers) for node in (quantity.lower, quantity.upper))
        value = numbers[quantity.name]
        if low is not None and high is not None and low >= high and getattr(quantity.upper, "name", None) in numbers:
            numbers[quantity.upper.name] = high = low + abs(low)
        if (low is None or value > low) and (high is None or value < high):
            continue
        low = (top := there(high)) - abs(top) if low is None else low
        high = low + (abs(low) or 1.0) if high is None else high
        numbers[quantity.name] = low + 0.6 * (high - low)


def _read(text: str) -> float | None:
    """The number of "25 cm" in SI units (radians for degrees); None if there is none or its unit is not known."""
    first, _, unit = str(text).strip().partition(" ")
    try:
        value = float(first)
    except ValueError:
        return None
    found = unit_named(unit) if unit else (None, 1.0)
    return None if found is None else value * found[1]


def _parameter(place: int, quantity: Quantity) -> float:
    if quantity.dimension == ACCELERATION:
        return 9.81
    if quantity.sign == "real":
        return 0.4 + 0.1 * (place % 3)
    generic = 1.0 + 0.31 * ((place * 7) % 5) / 2
    return 0.4 * generic if quantity.dimension == NUMBER else generic  # an acute angle


def _starts(problem: Problem, numbers: dict[str, float], k: int) -> dict[str, float]:
    """A start that is a constant of its own gets a value inside the coordinate's range."""
    found = {}
    for place, coordinate in enumerate(problem.coordinates, len(problem.parameters)):
        name = getattr(coordinate.start, "name", None)
        if name in problem.implicit:
            share = _scattered(k, place) if k > 1 else (0.8, 0.2)[k]
            found[name] = _within(coordinate, numbers, share) * _side(coordinate, problem.example.get(name, ""))
    return found


def _side(coordinate: Coordinate, example: str) -> int:
    """Without a range, the author's own number says on which side of zero it is."""
    given = _read(example) if coordinate.lower is None and coordinate.upper is None else None
    return -1 if given is not None and given < 0 else 1


def _within(coordinate: Coordinate, numbers: Numbers, share: float) -> float:
    low, high = (bound(node, numbers) for node in (coordinate.lower, coordinate.upper))
    if low is None and high is None:
        return 0.6 * share / 0.8
    low = there(high) - 2.0 if low is None else low
    high = low + 2.0 if high is None else high
    return low + share * (high - low)


def bound(node: Node | None, numbers: Numbers) -> float | None:
    """The number of a formula of the statement, such as an end of a range; None where there is none."""
    try:
        return None if node is None else number(scalar(node), numbers)
    except (RbpsymError, ZeroDivisionError):
        return None


def _middle(coordinate: Coordinate, numbers: Numbers) -> float:
    if coordinate.lower is None and coordinate.upper is None and coordinate.start is not None:
        start = bound(coordinate.start, numbers)
        return start if start is not None else 0.45
    return _within(coordinate, numbers, 0.55)


def _speed(coordinate: Coordinate, numbers: Numbers) -> float:
    return bound(coordinate.speed, numbers) or 0.0


def floating(value: Scalar, numbers: Numbers, none: float = math.nan) -> float:
    """The value at these numbers; `none` where it is not real."""
    try:
        found = number(value, numbers)
    except NoNumber:
        return none
    return 0.0 if abs(found) < 1e-12 else found


def angles(problem: Problem) -> frozenset[str]:
    """Names that stand under a sine, cosine or tangent of the statement, are given in degrees, or are starts of angles."""
    nodes = [node for body in problem.bodies for node in (*(body.placed[1] if body.placed else ()), body.angle) if node]
    nodes += [node for element in problem.elements for node in element.nodes]
    nodes += [node for point in problem.points.values() for node in point]
    turned = [part.arg for node in nodes for part in walk(node) if isinstance(part, Fn) and part.name in TURNS]
    found = {leaf.name for arg in turned for leaf in walk(arg) if isinstance(leaf, Sym)}
    found |= {c.start.name for c in problem.coordinates if isinstance(c.start, Sym) and c.quantity.dimension == NUMBER}
    return frozenset(found | {name for name, text in problem.example.items() if str(text).endswith(("deg", "°"))})


TURNS = frozenset({"sin", "cos", "tan"})


def unit_of_given(name: str, dimension: Dimension, turned: Set[str]) -> str:
    """The unit of a constant that is given: degrees for an angle; that of an energy is that of a torque."""
    if dimension == NUMBER:
        return "deg" if name in turned else ""
    return unit_of(dimension, "torque" if dimension == ENERGY else "")
