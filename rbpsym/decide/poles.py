"""Integrals through poles: a factor below the line that changes its sign between the ends vanishes there; and the
degree of what is homogeneous.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from rbpsym.decide import enclosure
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.dimensions import Dimensions, dimension_of
from rbpsym.decide.domain import Condition
from rbpsym.decide.factoring import split
from rbpsym.decide.points import Point, points
from rbpsym.decide.verdict import Witness
from rbpsym.errors import DimensionError, LimitError
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, depends_on, generator, substitute

PLACES = 36  # into so many parts the interval is cut
MOST_POINTS = 3  # of the quantities that the ends and the factor hold


def pole(conditions: Iterable[Condition], assumptions: Assumptions) -> Witness | None:
    """A point at which an integrand has a pole within its interval (its sides: what it is divided by, before and behind)."""
    for condition in conditions:
        if condition.between is not None and condition.op == "!=":
            for factor in _factors(condition.value, condition.between[0]):
                if (found := _crossed(factor, condition.between, assumptions)) is not None:
                    return found
    return None


def _factors(value: Scalar, name: str) -> Iterator[Scalar]:
    """What the value is a product of, as far as the variable stands in it."""
    _, monomial = value.num.content()
    for index, _ in monomial:
        if depends_on(Scalar(generator(index)), name):
            yield Scalar(generator(index))
    rest = value.num.scaled(1, tuple((index, -exponent) for index, exponent in monomial))
    try:
        yield from (Scalar(factor) for factor, _ in split(rest, deep=True)[1] if depends_on(Scalar(factor), name))
    except LimitError:
        yield Scalar(rest)


def _crossed(factor: Scalar, between: tuple[str, Scalar, Scalar], assumptions: Assumptions) -> Witness | None:
    name, lower, upper = between
    steps = [lower + (upper - lower) * Fraction(k, PLACES) for k in range(PLACES + 1)]
    values = [substitute(factor, {name: place}) for place in steps]
    for point in points(values, assumptions.without(name), MOST_POINTS):
        seen: dict[int, Scalar] = {}
        for value in values:
            sign = _sign(point, value)
            if sign and -sign in seen:
                sides, of = (point.value(seen[-sign]), point.value(value)), "what is below the line, on both sides of a pole"
                return Witness(tuple(point.numbers.items()), (), *sides, of)
            seen.setdefault(sign, value)
    return None


def _sign(point: Point, value: Scalar) -> int:
    try:
        return enclosure.sign_of(point.value(value)) or 0
    except enclosure.Outside:
        return 0


CHECKED = (t.Chain, t.Add, t.Fn, t.Pow)


def faults(node: t.Node, dimensions: Dimensions) -> int:
    """The number of sums, relations, functions and powers in which something does not fit (0: it is homogeneous).

    A formula with a name of unknown dimension is judged by its other parts.
    """
    return sum(_is_faulty(part, dimensions) for part in t.walk(node) if isinstance(part, CHECKED))


def _is_faulty(node: t.Node, dimensions: Dimensions) -> bool:
    if not all(name == "pi" or name in dimensions for name in t.names(node)):
        return False
    try:
        dimension_of(node, dimensions)
    except DimensionError:
        return True
    return False
