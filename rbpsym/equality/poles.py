"""Integrals through poles: a factor below the line that changes its sign between the ends vanishes there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from rbpsym.algebra import Scalar, depends_on, generator, substitute
from rbpsym.equality import enclosure
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.domain import Condition
from rbpsym.equality.factoring import split
from rbpsym.equality.points import Point, points
from rbpsym.equality.verdict import Witness
from rbpsym.errors import LimitError

PLACES = 36  # into so many parts the interval is cut
MOST_POINTS = 3  # of the quantities that the ends and the factor hold


def pole(conditions: Iterable[Condition], assumptions: Assumptions) -> Witness | None:
    """A point at which the integrand of some integral has a pole within its interval (its sides: signs before and behind)."""
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
                return Witness(tuple(point.numbers.items()), (), point.value(seen[-sign]), point.value(value))
            seen.setdefault(sign, value)
    return None


def _sign(point: Point, value: Scalar) -> int:
    try:
        return enclosure.sign_of(point.value(value)) or 0
    except enclosure.Outside:
        return 0
