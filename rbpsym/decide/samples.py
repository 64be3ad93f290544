"""Rough values at a few points: where a formula takes both signs, no proof of one need be tried.

Floats and chance decide nothing here; they only spare work.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, TypeVar
from zlib import crc32

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.factoring import MINUS, NONZERO, PLUS, times
from rbpsym.field import ONE, Coefficient, Monomial, Poly, Scalar, atoms
from rbpsym.field.elliptic import FUNCTIONS
from rbpsym.frozen import Frozen, field

FEW, MANY = 6, 24  # points at which something within a question is looked at, and the whole question
CANDIDATES = 96
CLEAR = 1e-9  # a value that is less than this part of its terms has no clear sign
Values = tuple[float, ...]
T = TypeVar("T")


class Samples(Frozen):
    """Values of generators at points (told by numbers) that satisfy the assumptions as far as such are found."""

    assumptions: Assumptions
    points: tuple[int, ...]
    known: dict[int, Values] = field(default_factory=dict)
    names: dict[str, Values] = field(default_factory=dict)
    masks: dict[Poly, tuple[int, ...]] = field(default_factory=dict)

    def seen(self, *values: Scalar) -> int:
        """The clear signs, + and -, that the values seem to take at a few points."""
        mask = 0
        for value in values:
            above = self._signs(value.num)
            for a, b in zip(above, above if value.den is ONE else self._signs(value.den), strict=True):
                mask |= a if value.den is ONE else times(a, b)
            if mask == NONZERO:
                break
        return mask

    def has_both_signs(self, poly: Poly, count: int = FEW) -> bool:
        """Whether the polynomial seems to be positive at one point and negative at another."""
        mask = self.seen(Scalar(poly))
        for k in range(FEW, min(count, len(self.points))):
            if mask == NONZERO:
                break
            mask |= self._sign(poly, k)
        return mask == NONZERO

    def _signs(self, poly: Poly) -> tuple[int, ...]:
        """At each of a few points the sign as a mask, 0 where it is not clear."""
        if poly not in self.masks:
            self.masks[poly] = tuple(self._sign(poly, k) for k in range(min(FEW, len(self.points))))
        return self.masks[poly]

    def _sign(self, poly: Poly, k: int) -> int:
        try:
            terms = [self._term(m, c, k) for m, c in poly.terms.items()]
            total = math.fsum(terms)
        except (ArithmeticError, ValueError):  # of ∞ - ∞, too
            return 0
        if not abs(total) > CLEAR * math.fsum(map(abs, terms)):
            return 0
        return PLUS if total > 0 else MINUS

    def _term(self, m: Monomial, c: Coefficient, k: int) -> float:
        value = float(c)
        for index, exponent in m:
            value *= self.atom(index)[k] ** exponent
        return value

    def atom(self, index: int) -> Values:
        """A generator at all points (NaN where it has no value)."""
        if index not in self.known:
            found = atoms.atom(index)
            rule = VALUES.get(found.kind, lambda samples, arg, k: math.nan)
            self.known[index] = tuple(_tried(rule, self, found.arg, k) for k in range(len(self.points)))
        return self.known[index]

    def poly(self, poly: Poly, k: int) -> float:
        """A polynomial at a point."""
        return math.fsum(self._term(m, c, k) for m, c in poly.terms.items())

    def scalar(self, value: Scalar, k: int) -> float:
        """A value at a point."""
        return self.poly(value.num, k) / self.poly(value.den, k)

    def name(self, name: str) -> Values:
        """A name at all points."""
        if name not in self.names:
            self.names[name] = (math.nan,) * len(self.points)  # a range that holds the name itself
            self.names[name] = tuple(_tried(chosen, self, name, k) for k in range(len(self.points)))
        return self.names[name]

    def fits(self, name: str, k: int) -> bool:
        """Whether a name lies within its range at a point, not beyond an end that has passed the other."""
        lower, upper = (None if end is None else _tried(Samples.scalar, self, end, k) for end in self.assumptions.range_of(name))
        value = self.name(name)[k]
        return (lower is None or lower <= value) and (upper is None or value <= upper) and value == value


@lru_cache(maxsize=256)
def samples_of(assumptions: Assumptions) -> Samples:
    """Points for the assumptions: the first at which every range has room, else any."""
    wide = Samples(assumptions, tuple(range(CANDIDATES)))
    fitting = [k for k in wide.points if all(wide.fits(name, k) for name in assumptions.ranges)]
    fitting = [k for k in fitting if all(_tried(Samples.scalar, wide, value, k) >= 0 for value, _ in assumptions.known)]
    return Samples(assumptions, tuple(fitting[:MANY] or wide.points[:FEW]))


def _tried(rule: Callable[[Samples, T, int], float], samples: Samples, arg: T, k: int) -> float:
    try:
        return rule(samples, arg, k)
    except (ArithmeticError, ValueError):
        return math.nan


def chosen(samples: Samples, name: str, k: int) -> float:
    """A number in the range of a name, scattered by the name and the point."""
    part = (crc32(f"{name} {samples.points[k]}".encode()) % 997 + 1) / 999
    lower, upper = (None if end is None else samples.scalar(end, k) for end in samples.assumptions.range_of(name))
    if samples.assumptions.sign_of(name) in ("positive", "nonnegative"):
        lower = max(lower or 0.0, 0.0)
    if lower is not None and upper is not None:
        return lower + (upper - lower) * part
    far = math.tan(part * math.pi / 2)
    if lower is not None:
        return lower + far
    return math.tan((part - 0.5) * math.pi) if upper is None else upper - far


def _of(function: Callable[[float], float]) -> Callable[[Samples, Scalar, int], float]:
    return lambda samples, arg, k: function(samples.scalar(arg, k))


VALUES: dict[str, Callable[[Samples, Any, int], float]] = {
    "symbol": lambda samples, name, k: math.pi if name == "pi" else samples.name(name)[k],
    "cos": lambda samples, angle, k: math.cos(samples.poly(angle, k)),
    "sin": lambda samples, angle, k: math.sin(samples.poly(angle, k)),
    "half": lambda samples, angle, k: math.tan(samples.poly(angle, k) / 2),
    **{kind: _of(function) for kind, function in FUNCTIONS.items() if kind not in ("cos", "sin")},
}
