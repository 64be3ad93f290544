"""Many quantities at many moments: each sine, root and power that they share is computed once a moment.

What has no number (a root of less than nothing, a division by zero) is not a number.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from rbpsym.algebra import atoms
from rbpsym.algebra.poly import ONE, Poly
from rbpsym.algebra.scalar import Scalar
from rbpsym.mechanics.numbers import FUNCTIONS

Terms = tuple[tuple[float, tuple[tuple[int, int], ...]], ...]  # coefficient, (atom, power) ...
Ratio = tuple[Terms, Terms | None]


@dataclass(frozen=True)
class Evaluator:
    """Named quantities in their order; a later one may use the names of those before it."""

    values: Mapping[str, Scalar]
    ratios: dict[str, Ratio] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        self.ratios.update((name, prepared(value)) for name, value in self.values.items())

    @property
    def size(self) -> int:
        """How many products have to be added up."""
        return sum(len(top) + len(below or ()) for top, below in self.ratios.values())

    def __call__(self, numbers: Mapping[str, float]) -> dict[str, float]:
        """All of them at these numbers (KeyError for a missing name)."""
        known, seen = dict(numbers), {}
        found = {}
        for name, pair in self.ratios.items():
            found[name] = known[name] = ratio(pair, known, seen)
        return found


def prepared(value: Scalar) -> Ratio:
    """A quotient of sums of products."""
    return terms(value.num), None if value.den is ONE else terms(value.den)


def terms(poly: Poly) -> Terms:
    """A sum of products with floating-point coefficients."""
    return tuple((float(c), tuple(m)) for m, c in poly.terms.items())


def ratio(pair: Ratio, numbers: Mapping[str, float], seen: dict[int, float]) -> float:
    """The value of a quotient."""
    try:
        top = total(pair[0], numbers, seen)
        return top if pair[1] is None else top / total(pair[1], numbers, seen)
    except (ValueError, ZeroDivisionError, OverflowError):
        return math.nan


def total(sums: Terms, numbers: Mapping[str, float], seen: dict[int, float]) -> float:
    """The value of a sum."""
    whole = 0.0
    for coefficient, factors in sums:
        for index, power in factors:
            value = seen.get(index)
            if value is None:
                value = seen[index] = atom(index, numbers, seen)
            coefficient *= value if power == 1 else value**power
        whole += coefficient
    return whole


def atom(index: int, numbers: Mapping[str, float], seen: dict[int, float]) -> float:
    """The value of a name, or of a function of others."""
    if index == atoms.PI:
        return math.pi
    found = atoms.atom(index)
    if found.kind == "symbol":
        return numbers[found.arg]
    inner = found.arg
    if isinstance(inner, Scalar):
        pair = PREPARED.get(inner) or PREPARED.setdefault(inner, prepared(inner))
        top = total(pair[0], numbers, seen)
        return FUNCTIONS[found.kind](top if pair[1] is None else top / total(pair[1], numbers, seen))
    return FUNCTIONS[found.kind](total(terms(inner), numbers, seen))


PREPARED: dict[Scalar, Ratio] = {}  # the arguments of functions that have been met
