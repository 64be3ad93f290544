"""Numbers between which the only zero of a monotone function lies, by bisection with rigorous enclosures."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from rbpsym.decide import enclosure
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.points import Point
from rbpsym.field import Scalar

STEPS, WIDEST = 60, 64  # halvings of what is bracketed, and doublings of a range without an end


def bracket(equation: Scalar, name: str, given: Assumptions, numbers: Mapping[str, float]) -> tuple[Fraction, Fraction] | None:
    """Two numbers at which the function has opposite signs, close to each other; None if they are not found."""
    exact = {other: Fraction(value) for other, value in numbers.items() if other != name}

    def sign(place: Fraction) -> int | None:
        try:
            return enclosure.sign_of(Point({**exact, name: place}).value(equation))
        except enclosure.Outside:
            return None

    limits = of_symbol(name, given)
    low, high = (None if end is None else _number(end, exact) for end in (limits.lower, limits.upper))
    for size in (2**k for k in range(-WIDEST, WIDEST)):  # a range without an end is looked through from its other end
        first = -size if low is None and high is None else high - size if low is None else low
        last = (first + 2 * size if low is None else low + size) if high is None else high
        step = (last - first) / 2**40
        below, above = sign(first + step), sign(last - step)
        if below is not None and above is not None and below == -above:
            break
    else:
        return None
    low, high = first + step, last - step
    for _ in range(STEPS):
        middle = (low + high) / 2
        found = sign(middle)
        if found is None:
            break
        low, high = (middle, high) if found in (below, 0) else (low, middle)
    return low, high


def _number(value: Scalar, exact: Mapping[str, Fraction]) -> Fraction:
    low, high = enclosure.ends(Point(exact).value(value))
    return (low + high) / 2
