"""Square roots with everything taken out of them that is known to be a square of something positive."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import root
from rbpsym.algebra.poly import ONE, Monomial, Poly, generator, inverse
from rbpsym.algebra.scalar import NOTHING, UNITY, Scalar, generator_of


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


def without_even_roots(value: Scalar) -> Scalar:
    """The value with even powers of square roots carried out, exactly."""
    if all(_squared_root(poly) is None for poly in (value.num, value.den)):
        return value
    return _evened(value.num) / _evened(value.den) if value.den is not ONE else _evened(value.num)


def _squared_root(poly: Poly) -> int | None:
    """A square root of which an even power occurs."""
    return next((i for i in poly.atoms() if atoms.atom(i).kind == "root" and _is_squared(poly, i)), None)


def _evened(poly: Poly) -> Scalar:
    index = _squared_root(poly)
    if index is None:
        return Scalar(poly)
    radicand, total = atoms.atom(index).arg, NOTHING
    for power, part in poly.by_power(index).items():
        odd = Scalar(generator(index)) if power % 2 else UNITY
        total = total + Scalar(part) * odd * radicand ** (power // 2)
    return without_even_roots(total)


def _is_squared(poly: Poly, index: int) -> bool:
    return any(power not in (0, 1) for power in poly.by_power(index))
