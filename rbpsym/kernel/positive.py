"""Sums of positive terms and of squares: why a polynomial does not vanish, for the kernel to multiply out."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Set
from fractions import Fraction
from itertools import product

from rbpsym.field import UNITY, Coefficient, Monomial, Poly, Scalar, generator, inverse, times
from rbpsym.frozen import Frozen
from rbpsym.kernel.certificates import partner, wound

MOST_TERMS = 60


class PositiveSum(Frozen):
    """sign × value = Σ above + Σ factor × square² + Σ factor × (1 ± wave).

    above: terms that are positive; squares: (factor that is not negative, what is squared); waves: (factor that is
    not negative, a sine or cosine, its sign).
    """

    sign: int
    above: Scalar
    squares: tuple[tuple[Scalar, Scalar], ...]
    waves: tuple[tuple[Scalar, Scalar, int], ...]

    def over(self, below: Scalar, sign: int, *roots: Poly) -> PositiveSum:
        """The same and further squares, over something positive."""
        squares, waves = (tuple((part[0] / below, *part[1:]) for part in parts) for parts in (self.squares, self.waves))
        more = ((UNITY / below, Scalar(root)) for root in roots)
        return PositiveSum(sign, self.above / below, (*squares, *more), waves)


def positive_sum(
    poly: Poly, positive: Set[int], least: Set[int] = frozenset(), *, strict: bool = True, deep: int = 2
) -> PositiveSum | None:
    """A polynomial, or what is opposite to it, as a sum of what is positive (nothing, if it is not `strict`) and of what is not
    negative; `deep`: how often squares of sums, and those of sines and cosines of one angle together, are taken off.

    `positive`: atoms above 0; `least`: atoms that are at least 0. Sines and cosines are letters, sin² + cos² = 1 is used.
    None: no such sum was found.
    """
    if len(poly) > MOST_TERMS:
        return None
    angles = sorted(index for index in poly.atoms() if partner(index) is not None or partner(index, "cos") is not None)
    sines = sorted({index if partner(index) is not None else partner(index, "cos") or index for index in angles})
    for kinds in product(("sin", "cos"), repeat=min(len(sines), 3)):
        value = Scalar(poly)
        for kind in dict.fromkeys(kinds):
            chosen = {s if kind == "sin" else partner(s) or s for s, k in zip(sines, kinds, strict=False) if k == kind}
            value = wound(value, kind, only=chosen)
        for sign in (1, -1):
            found = _sum(value.num.scaled(sign), sign, positive, positive | least, strict)
            if found is not None:
                return found
    plain = wound(Scalar(poly)).num if deep else Poly({})
    ways = [*((_completed, index) for index in sorted(plain.atoms())), *((_swung, sine) for sine in sines if deep)]
    for way, index in ways:
        for sign in (1, -1):
            made = way(plain.scaled(sign), index, positive)
            found = made and positive_sum(wound(Scalar(made[0])).num, positive, least, strict=strict, deep=deep - 1)
            if made and found and found.sign > 0:
                return found.over(Scalar(made[1]), sign, *made[2:])
    return None


def _completed(poly: Poly, index: int, positive: Set[int]) -> tuple[Poly, ...] | None:
    """What is quadratic in a letter x: 4A (A x² + B x + C) = 4A C - B² + (2A x + B)²: what is left, by what it is over, what
    is squared."""
    parts = poly.by_power(index)
    if not {1, 2} <= parts.keys() <= {0, 1, 2} or not _is_plain(parts[2], positive):
        return None
    a, b, c = parts[2], parts[1], parts.get(0, Poly({}))
    return (a * c).scaled(4) - b * b, a.scaled(4), a.scaled(2) * generator(index) + b


def _swung(poly: Poly, sine: int, positive: Set[int]) -> tuple[Poly, ...] | None:
    """What is linear in the sine s and the cosine c of an angle, as the squared distance of points on circles is:
    2A (A + B c + D s) = A² - B² - D² + (A + B c + D s)² + (B s - D c)²; the same parts of it."""
    cosine = partner(sine) or sine
    parts: dict[tuple[int, int], dict[Monomial, Coefficient]] = {}
    for monomial, coefficient in poly.terms.items():
        powers, rest = dict(monomial), tuple(item for item in monomial if item[0] not in (sine, cosine))
        parts.setdefault((powers.get(sine, 0), powers.get(cosine, 0)), {})[rest] = coefficient
    a, b, d = (Poly(parts.pop(powers, {})) for powers in ((0, 0), (0, 1), (1, 0)))
    if parts or not a or not _is_plain(a, positive):
        return None
    return a * a - b * b - d * d, a.scaled(2), poly, b * generator(sine) - d * generator(cosine)


def _is_plain(poly: Poly, positive: Set[int]) -> bool:
    return all(c > 0 and _is_above(m, positive) for m, c in poly.terms.items())


def is_wave(index: int) -> bool:
    """Whether a letter stands for a sine or cosine."""
    return partner(index) is not None or partner(index, "cos") is not None


def _sum(poly: Poly, sign: int, positive: Set[int], fair: Set[int], strict: bool) -> PositiveSum | None:
    """The sum by its terms: even powers stay, what swings is at least minus its size, what is left are squares."""
    even: dict[Monomial, Coefficient] = {}
    waves: dict[tuple[Monomial, int, int], Coefficient] = {}
    for monomial, coefficient in poly.terms.items():
        odd = [(i, e) for i, e in monomial if e % 2 and i not in fair]
        if not odd or not is_wave(odd[0][0]):
            even[monomial] = even.get(monomial, 0) + coefficient
        elif len(odd) == 1 and odd[0][1] == 1:
            rest = tuple(item for item in monomial if item != odd[0])
            turn = 1 if coefficient > 0 else -1
            size = coefficient * turn
            waves[rest, odd[0][0], turn] = waves.get((rest, odd[0][0], turn), 0) + size
            even[rest] = even.get(rest, 0) - size
        else:
            return None
    squares = list(_squares(even, positive, fair))
    above = {m: c for m, c in even.items() if c and _is_above(m, positive)}
    flat = {m: c for m, c in even.items() if c and not _is_above(m, positive)}
    if (strict and not above) or any(c < 0 for c in even.values()) or any(e % 2 and i not in fair for m in flat for i, e in m):
        return None
    for m, c in flat.items():
        squares.append(_halved(m, c, fair))
    found = [(Scalar(Poly({rest: c})), Scalar(Poly({((i, 1),): 1})), turn) for (rest, i, turn), c in waves.items()]
    if any(e % 2 and i not in fair for (rest, _, _) in waves for i, e in rest):
        return None
    return PositiveSum(sign, Scalar(Poly(above)), tuple(squares), tuple(found))


def _is_above(monomial: Monomial, positive: Collection[int]) -> bool:
    return all(i in positive for i, _ in monomial)


def _halved(monomial: Monomial, coefficient: Coefficient, positive: Collection[int]) -> tuple[Scalar, Scalar]:
    """The positive part of a term, and what is squared in it."""
    known = tuple((i, e) for i, e in monomial if i in positive)
    root = tuple((i, e // 2) for i, e in monomial if i not in positive)
    return Scalar(Poly({known: coefficient})), Scalar(Poly({root: 1}))


def _lift(even: dict[Monomial, Coefficient], monomial: Monomial, wanted: Fraction, kept: Monomial) -> None:
    """As much of a monomial as is wanted, out of the one that is a sin² less: 1 = sin² + cos²."""
    missing = wanted - even.get(monomial, 0)
    for index, exponent in monomial if missing > 0 else ():
        other, lower = partner(index) or partner(index, "cos"), times(monomial, ((index, -2),))
        if other is not None and exponent >= 2 and lower != kept and even.get(lower, 0) >= missing:
            rest = times(lower, ((other, 2),))
            for place, change in ((lower, -missing), (monomial, missing), (rest, missing)):
                even[place] = even.get(place, 0) + change
            return


def _squares(even: dict[Monomial, Coefficient], above: Collection[int], fair: Collection[int]) -> Iterator[tuple[Scalar, Scalar]]:
    """Squares that take up what is negative: A u² + B v² - k u v = A (u - k v/2A)² + (B - k²/4A) v², of which v² is rather
    positive than not negative."""
    for monomial in [m for m, c in even.items() if c < 0 or any(e % 2 and i not in fair for i, e in m)]:
        twice = times(monomial, monomial)
        of = [m for m, c in even.items() if c > 0 and all(e % 2 == 0 for _, e in m)]
        for first in sorted(of, key=lambda m: not _is_above(times(twice, inverse(m)), above)):
            second = times(twice, inverse(first))
            a, k = even.get(first, 0), even.get(monomial, 0)
            if second == first or a <= 0 or not k or any(e % 2 for _, e in second):
                continue
            _lift(even, second, Fraction(k) * k / (4 * Fraction(a)), first)
            b = even.get(second, 0)
            if b <= 0 or 4 * a * b < k * k:
                continue
            u, v = (Poly({tuple((i, e // 2) for i, e in m): 1}) for m in (first, second))
            factor = Fraction(k) / (2 * Fraction(a))
            even[first], even[monomial], even[second] = 0, 0, b - Fraction(k) * k / (4 * Fraction(a))
            yield UNITY * a, Scalar(u + v.scaled(factor))
            break

