"""Square roots as letters: what is known of them, and none of them below."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from math import isqrt
from typing import TYPE_CHECKING

from rbpsym.errors import Undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, Poly, Scalar, atoms, generator, names_in, substitute, symbol
from rbpsym.kernel.certificates import Have, KnownEquation, Multiples
from rbpsym.kernel.claim import Proposition
from rbpsym.kernel.ranges import above, signed

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search


def rootless(search: Search, value: Scalar) -> tuple[Scalar, list[tuple[Scalar, KnownEquation]]]:
    """The value with even powers of roots replaced, no roots below, and no root that is a multiple of another; and by which
    multiples of what is known of roots it differs."""
    taken: list[tuple[Scalar, KnownEquation]] = []
    while True:
        value, more = _once(search, value)
        taken += more
        if not more:
            return value, taken


def _once(search: Search, value: Scalar) -> tuple[Scalar, list[tuple[Scalar, KnownEquation]]]:
    """The same for the roots that stand there now, not for those below them."""
    taken: list[tuple[Scalar, KnownEquation]] = []
    names = [name for name in sorted(names_in(value) & search.roots.keys()) if _is_certain(search, name)]
    for place, name in enumerate(names):
        node, arg = search.source.circular[name], search.roots[name]
        assert isinstance(node, t.Sqrt)
        number, factor = list(search.roots).index(name), NOTHING
        index, square = atoms.intern("symbol", name), symbol(name) ** 2 - arg
        while (low := min(value.num.by_power(index), default=0)) < 0:
            term = _head(value, index, low) / arg
            value, factor = value + term * square, factor - term
        while (top := max(value.num.by_power(index), default=0)) > 1:
            term = _head(value, index, top) * symbol(name) ** -2
            value, factor = value - term * square, factor + term
        if factor:
            taken.append((factor, _squared(search, f"r{number}", node, arg)))
        for other in names[:place]:
            ratio = _root_of(search, arg / search.roots[other])
            if ratio is not None and 1 in value.num.by_power(index):
                term = _head(value, index, 1) / symbol(name)
                value = value - term * (symbol(name) - ratio * symbol(other))
                right = t.mul(search.tree(ratio), search.source.circular[other])
                same = search.notes.setdefault(f"m{number}", Have(f"m{number}", "multiple root", Proposition(node, right)))
                taken.append((term, KnownEquation(same.name, same.claim)))
                break
    return value, taken


def more(
    search: Search, goal: Scalar, known: Sequence[KnownEquation], *, strict: bool = True
) -> tuple[Multiples, tuple[t.Node, ...]]:
    """Why left - right is positive, as `above`; a difference a - √b by (a² - b)/(a + √b)."""
    try:
        return above(search, goal, known, strict=strict)
    except Undecided:
        rest, by = search.follow(goal, known)
        if (found := _by_other(search, rest)) is None:
            raise
        whole, other, taken = found
        roots = tuple((search.tree(factor / other), item) for factor, item in taken)
        return replace(by, known=(*by.known, *roots)), (search.tree(whole / other), t.ZERO)


def _by_other(search: Search, value: Scalar) -> tuple[Scalar, Scalar, list[tuple[Scalar, KnownEquation]]] | None:
    """The product of a value and of the same with the other root, and that, both positive; and the squares of roots in it."""
    for name in sorted(names_in(value) & search.roots.keys()):
        other = substitute(value, {name: -symbol(name)})
        whole, taken = rootless(search, value * other)
        if search.is_positive(whole) and search.is_positive(other):
            return whole, other, taken
    return None


def _squared(search: Search, name: str, node: t.Sqrt, arg: Scalar) -> KnownEquation:
    """The square of a root is what stands below it, which is positive."""
    claim = Proposition(t.Pow(node, t.TWO), node.arg)
    if name not in search.notes:
        by, parts = Multiples(), tuple[t.Node, ...]()
        with suppress(Undecided):
            by, parts = more(search, arg, ())
        search.notes[name] = Have(name, "root", claim, node.arg, by, parts=parts)
    return KnownEquation(name, claim)


def _head(value: Scalar, index: int, power: int) -> Scalar:
    """The part of a value with some power of an atom."""
    return Scalar(value.num.by_power(index)[power]) * Scalar(generator(index)) ** power / Scalar(value.den)


def _is_certain(search: Search, name: str) -> bool:
    """Whether what stands below a root is positive for certain; then the root is."""
    arg = search.roots[name]
    is_known = all(_is_certain(search, inner) for inner in sorted(names_in(arg) & search.roots.keys()))
    found = signed(search, Scalar(arg.num) * Scalar(arg.den)) if is_known else None
    if not is_known or (found.sign < 0 if found else _by_other(search, arg) is None):
        return False
    search.positive |= symbol(name).atoms()
    return True


def _root_of(search: Search, ratio: Scalar) -> Scalar | None:
    """The root of a square of one positive term."""
    if len(ratio.num) != 1 or len(ratio.den) != 1 or not search.is_positive(ratio):
        return None
    found = UNITY
    for poly, sign in ((ratio.num, 1), (ratio.den, -1)):
        [(monomial, coefficient)] = poly.terms.items()
        number = Fraction(coefficient)
        top, below = isqrt(number.numerator), isqrt(number.denominator)
        if top * top != number.numerator or below * below != number.denominator or any(e % 2 for _, e in monomial):
            return None
        found = found * Scalar(Poly({tuple((i, e // 2) for i, e in monomial): Fraction(top, below)})) ** sign
    return found
