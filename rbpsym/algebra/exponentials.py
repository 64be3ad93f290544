"""Products of exponentials as one: exp(a)² exp(b) as exp(2a + b), exp(a) exp(-a) as 1."""

from __future__ import annotations

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import function, inside
from rbpsym.algebra.normal import short
from rbpsym.algebra.poly import ONE, Poly
from rbpsym.algebra.scalar import NOTHING, Scalar, total


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
