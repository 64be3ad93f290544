"""Products of exponentials as one: exp(a)² exp(b) as exp(2a + b), exp(a) exp(-a) as 1; and known squares put in."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.field import atoms
from rbpsym.field.calculus import depends_on, function, inside
from rbpsym.field.normal import short
from rbpsym.field.poly import ONE, Poly, generator
from rbpsym.field.scalar import NOTHING, UNITY, Scalar, total


def is_exponential(index: int) -> bool:
    """Whether an atom is an exponential."""
    return atoms.atom(index).kind == "exp"


def with_exponentials_joined(value: Scalar) -> Scalar:
    """The value with one exponential in each product, also within roots and functions."""
    value = inside(value, with_exponentials_joined)
    if not any(map(is_exponential, value.atoms())):
        return value
    return _joined(value.num) if value.den is ONE else _joined(value.num) / _joined(value.den)


def _joined(poly: Poly) -> Scalar:
    parts = []
    for m, c in poly.terms.items():
        exponent = sum((atoms.atom(i).arg * power for i, power in m if is_exponential(i)), NOTHING)
        rest = Scalar(Poly({tuple(item for item in m if not is_exponential(item[0])): c}))
        parts.append(rest * function("exp", short(exponent)))
    return total(parts)


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
