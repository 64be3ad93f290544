"""Many quantities at many moments: each sine, root and power that they share is computed once a moment.

What has no number (a root of less than nothing, a division by zero, a name without one) is not a number.
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping
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

    values: Mapping[Hashable, Scalar]
    ratios: dict[Hashable, Ratio] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        self.ratios.update((name, prepared(value)) for name, value in self.values.items())

    @property
    def size(self) -> int:
        """How many products have to be added up."""
        return sum(len(top) + len(below or ()) for top, below in self.ratios.values())

    def __call__(self, numbers: Mapping[str, float]) -> dict[Hashable, float]:
        """All of them at these numbers."""
        known, seen = dict(numbers), {atoms.PI: math.pi}
        found = {}
        for name, pair in self.ratios.items():
            found[name] = known[name] = ratio(pair, known, seen)
        return found


def prepared(value: Scalar | Poly) -> Ratio:
    """A quotient of sums of products."""
    if isinstance(value, Poly):
        return terms(value), None
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
    found = atoms.atom(index)
    if found.kind == "symbol":
        return numbers.get(found.arg, math.nan)
    function = FUNCTIONS.get(found.kind)
    if function is None:
        return math.nan
    pair = PREPARED.get(found.arg) or PREPARED.setdefault(found.arg, prepared(found.arg))
    top = total(pair[0], numbers, seen)
    return function(top if pair[1] is None else top / total(pair[1], numbers, seen))


PREPARED: dict[Scalar | Poly, Ratio] = {}  # the arguments of functions that have been met
