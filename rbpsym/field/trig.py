"""Sines and cosines as atoms with canonical angles.

An angle is a polynomial without sines (θ, θ₁ - θ₂, s/R, π - 2φ). The constant multiple of π
is reduced to a quarter turn at most, cos(-a) = cos a, and multiples of π/6 and π/4 get values.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache

from rbpsym.errors import Undecided
from rbpsym.field import atoms
from rbpsym.field.poly import ONE, Poly, clean
from rbpsym.field.scalar import NOTHING, UNITY, Scalar, generator_of, lift

PI_TERM = ((atoms.PI, 1),)


def cosine(angle: Scalar) -> Scalar:
    """cos(angle)."""
    return _wave(angle)[0]


def sine(angle: Scalar) -> Scalar:
    """sin(angle)."""
    return _wave(angle)[1]


@lru_cache(maxsize=8192)
def _wave(angle: Scalar) -> Wave:
    return _quarter(*_split(angle))


def _split(angle: Scalar) -> tuple[Poly, Fraction]:
    """The angle without π, and its multiple of π."""
    if angle.den is not ONE:
        raise Undecided("an angle with a sum in the denominator is outside the decidable class")
    terms = dict(angle.num.terms)
    turns = Fraction(terms.pop(PI_TERM, 0))
    return clean(terms), turns


def _quarter(rest: Poly, turns: Fraction) -> Wave:
    quarters, remainder = divmod(turns * 2, 1)
    c, s = _basic(rest, remainder / 2)
    for _ in range(int(quarters) % 4):
        c, s = -s, c
    return c, s


def _basic(rest: Poly, turns: Fraction) -> Wave:
    """(cos, sin) of rest + turns·π with 0 ≤ turns < 1/2."""
    if not rest.terms:
        return _special(turns)
    undone = _inverse(rest) if not turns or turns in SPECIAL else None
    if undone is not None:
        return _turned_by(_special(turns), undone)
    sign = -1 if rest.terms[min(rest.terms)] < 0 else 1
    if sign < 0:
        rest, turns = -rest, -turns
    if turns < 0:
        c, s = _atoms(rest, turns + Fraction(1, 2))
        c, s = s, -c
    else:
        c, s = _atoms(rest, turns)
    return (c, -s) if sign < 0 else (c, s)


MOST_MULTIPLES = 4


Wave = tuple[Scalar, Scalar]  # cos and sin of an angle


def _turned_by(first: Wave, second: Wave) -> Wave:
    """(cos, sin) of a sum of angles."""
    (x, y), (c, s) = first, second
    return x * c - y * s, y * c + x * s


def _inverse(rest: Poly) -> Wave | None:
    """(cos, sin) of a sum of small multiples of acos x, asin x or atan x."""
    wave = UNITY, NOTHING
    for m, c in rest.terms.items():
        if len(m) != 1 or m[0][1] != 1 or type(c) is not int or atoms.atom(m[0][0]).kind not in UNDONE:
            return None
        if not 0 < abs(c) <= MOST_MULTIPLES:
            return None
        found = atoms.atom(m[0][0])
        x, y = UNDONE[found.kind](found.arg)
        for _ in range(abs(c)):
            wave = _turned_by(wave, (x, y if c > 0 else -y))
    return wave


def _side(value: Scalar) -> Scalar:
    """√value for the missing side of a right triangle."""
    from rbpsym.field.calculus import root

    return root(value)


UNDONE: dict[str, Callable[[Scalar], Wave]] = {
    "acos": lambda x: (x, _side(1 - x * x)),
    "asin": lambda x: (_side(1 - x * x), x),
    "atan": lambda x: (1 / _side(1 + x * x), x / _side(1 + x * x)),
}


def _atoms(rest: Poly, turns: Fraction) -> Wave:
    angle = rest + Poly({PI_TERM: turns}) if turns else rest
    return generator_of("cos", angle), generator_of("sin", angle)


def _special(turns: Fraction) -> Wave:
    if turns == 0:
        return UNITY, NOTHING
    values = SPECIAL.get(turns)
    return (_root_sum(values[0]), _root_sum(values[1])) if values else _atoms(Poly({}), turns)


def _root_sum(parts: tuple[tuple[Fraction, tuple[int, ...]], ...]) -> Scalar:
    """Σ coefficient × √n √n' ..."""
    total = NOTHING
    for coefficient, radicands in parts:
        term = lift(coefficient)
        for n in radicands:
            term = term * generator_of("root", lift(n))
        total = total + term
    return total


_H, _Q = Fraction(1, 2), Fraction(1, 4)
_COS = {
    Fraction(1, 12): ((_Q, (2, 3)), (_Q, (2,))),
    Fraction(1, 6): ((_H, (3,)),),
    Fraction(1, 4): ((_H, (2,)),),
    Fraction(1, 3): ((_H, ()),),
    Fraction(5, 12): ((_Q, (2, 3)), (-_Q, (2,))),
}
SPECIAL = {turns: (value, _COS[_H - turns]) for turns, value in _COS.items()}
