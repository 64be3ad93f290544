"""Squares of symbols replaced, where only even powers have a known value."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import depends_on, inside
from rbpsym.algebra.poly import Poly, generator
from rbpsym.algebra.scalar import NOTHING, UNITY, Scalar


def with_squares(value: Scalar, squares: Mapping[str, Scalar]) -> Scalar:
    """The value with squares of speeds replaced, inside roots too; an odd power keeps one factor."""
    if not any(depends_on(value, f"{name}_dot") for name in squares):
        return value
    value = inside(value, lambda arg: with_squares(arg, squares))
    for name, square in squares.items():
        index = atoms.intern("symbol", f"{name}_dot")
        if index in value.atoms():
            value = _squared(value.num, index, square) / _squared(value.den, index, square)
    return value


def _squared(poly: Poly, index: int, square: Scalar) -> Scalar:
    total = NOTHING
    for power, part in poly.by_power(index).items():
        odd = Scalar(generator(index)) if power % 2 else UNITY
        total = total + Scalar(part) * odd * square ** (power // 2)
    return total
