"""Sums of positive terms and of squares: why a polynomial does not vanish, for the kernel to multiply out."""

from __future__ import annotations

from collections.abc import Collection, Set
from itertools import product

from rbpsym.field import UNITY, Coefficient, Monomial, Poly, Scalar, generator
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
    poly: Poly, positive: Set[int], least: Set[int] = frozenset(), *, strict: bool = True, deep: int = 3
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
    forms: dict[Poly, None] = {}
    for kinds in product(("sin", "cos"), repeat=min(len(sines), 3)):
        value = Scalar(poly)
        for kind in dict.fromkeys(kinds):
            chosen = {s if kind == "sin" else partner(s) or s for s, k in zip(sines, kinds, strict=False) if k == kind}
            value = wound(value, kind, only=chosen)
        forms[value.num] = None
    tries = [(form, sign) for form in forms for sign in (1, -1)]
    for form, sign in tries:
        if (found := _sum(form.scaled(sign), sign, positive, positive | least, strict, deep)) is not None:
            return found
    ways = [(_completed, form, index) for form in forms for index in sorted(form.atoms()) if deep]
    ways += [(_swung, wound(Scalar(poly)).num, sine) for sine in sines if deep]
    for way, form, index in ways:
        for sign in (1, -1):
            made = way(form.scaled(sign), index, positive)
            left = made and positive_sum(wound(Scalar(made[0])).num, positive, least, strict=strict, deep=deep - 1)
            if made and left and left.sign > 0:
                return left.over(Scalar(made[1]), sign, *made[2:])
    return None


def _completed(poly: Poly, index: int, positive: Set[int]) -> tuple[Poly, ...] | None:
    """What is quadratic in a letter x: 4A (A x² + B x + C) = 4A C - B² + (2A x + B)²: what is left, by what it is over, what
    is squared."""
    parts = poly.by_power(index)
    if not {1, 2} <= parts.keys() <= {0, 1, 2} or not is_plain(parts[2], positive):
        return None
    a, b, c = parts[2], parts[1], parts.get(0, Poly({}))
    return (a * c).scaled(4) - b * b, a.scaled(4), a.scaled(2) * generator(index) + b


def _swung(poly: Poly, index: int, positive: Set[int]) -> tuple[Poly, ...] | None:
    """What is linear in the sine s and the cosine c of an angle, as the squared distance of points on circles is:
    2A (A + B c + D s) = A² - B² - D² + (A + B c + D s)² + (B s - D c)²; the same parts of it."""
    sine, cosine = index, partner(index) or index
    parts: dict[tuple[int, int], dict[Monomial, Coefficient]] = {}
    for monomial, coefficient in poly.terms.items():
        powers, rest = dict(monomial), tuple(item for item in monomial if item[0] not in (sine, cosine))
        parts.setdefault((powers.get(sine, 0), powers.get(cosine, 0)), {})[rest] = coefficient
    a, b, d = (Poly(parts.pop(powers, {})) for powers in ((0, 0), (0, 1), (1, 0)))
    if parts or not a or not is_plain(a, positive):
        return None
    return a * a - b * b - d * d, a.scaled(2), poly, b * generator(sine) - d * generator(cosine)


def is_plain(poly: Poly, positive: Set[int]) -> bool:
    """Whether all its terms are positive."""
    return all(c > 0 and _is_above(m, positive) for m, c in poly.terms.items())


def is_wave(index: int) -> bool:
    """Whether a letter stands for a sine or cosine."""
    return partner(index) is not None or partner(index, "cos") is not None


def _sum(poly: Poly, sign: int, positive: Set[int], fair: Set[int], strict: bool, deep: int) -> PositiveSum | None:
    """The sum by its terms: even powers stay, what swings is at least minus its size, what is left may be squares."""
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
    found = tuple((Scalar(Poly({rest: c})), Scalar(Poly({((i, 1),): 1})), turn) for (rest, i, turn), c in waves.items())
    if any(e % 2 and i not in fair for (rest, _, _) in waves for i, e in rest):
        return None
    above = {m: c for m, c in even.items() if c and _is_above(m, positive)}
    flat = {m: c for m, c in even.items() if c and not _is_above(m, positive)}
    is_even = all(c >= 0 for c in even.values()) and all(e % 2 == 0 or i in fair for m in flat for i, e in m)
    if is_even and (above or not strict):
        return PositiveSum(sign, Scalar(Poly(above)), tuple(_halved(m, c, fair) for m, c in flat.items()), found)
    plain = positive_sum(Poly({**above, **flat}), positive, fair, strict=strict, deep=deep - 1) if waves and deep else None
    return PositiveSum(sign, plain.above, plain.squares, (*plain.waves, *found)) if plain and plain.sign > 0 else None


def _is_above(monomial: Monomial, positive: Collection[int]) -> bool:
    return all(i in positive for i, _ in monomial)


def _halved(monomial: Monomial, coefficient: Coefficient, positive: Collection[int]) -> tuple[Scalar, Scalar]:
    """The positive part of a term, and what is squared in it."""
    known = tuple((i, e) for i, e in monomial if i in positive)
    root = tuple((i, e // 2) for i, e in monomial if i not in positive)
    return Scalar(Poly({known: coefficient})), Scalar(Poly({root: 1}))
