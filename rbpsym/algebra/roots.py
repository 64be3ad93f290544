"""Square roots with everything taken out of them that is known to be a square of something positive."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import root
from rbpsym.algebra.poly import ONE, Monomial, Poly, inverse
from rbpsym.algebra.scalar import Scalar, generator_of


def simplified_root(value: Scalar, is_positive: Callable[[str], bool]) -> Scalar:
    """√value with rational squares and squares of positive symbols in front."""
    if value.den is not ONE or not value.num.terms:
        return root(value)
    rational, powers = value.num.content()
    squares = tuple((i, e - e % 2) for i, e in powers if e - e % 2 and is_positive(atoms.symbol_name(i) or ""))
    inner = value.num.scaled(Fraction(1) / rational, inverse(squares))
    outer = Scalar(Poly({_halved(squares): 1})) * root(Scalar(Poly({(): rational})))
    return outer if inner == ONE else outer * generator_of("root", Scalar(inner))


def _halved(powers: Monomial) -> Monomial:
    return tuple((i, e // 2) for i, e in powers)
