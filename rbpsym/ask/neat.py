"""Values in a neat form: squares are taken out of roots, of a product of roots too."""

from __future__ import annotations

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import inside
from rbpsym.algebra.poly import Poly
from rbpsym.algebra.roots import simplified_root, tidied, without_even_roots
from rbpsym.algebra.scalar import UNITY, Scalar
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.rooted import rooted
from rbpsym.mechanics.elimination import short


def neat(value: Scalar, given: Assumptions) -> Scalar:
    """The same value with short roots."""
    value = _joined(rooted(_even(value), given), given)
    return tidied(value, lambda name: given.sign_of(name) == "positive", lambda total: False)


def _even(value: Scalar) -> Scalar:
    return short(without_even_roots(inside(value, _even)))


def _joined(value: Scalar, given: Assumptions) -> Scalar:
    """A product of roots as that of the whole, with what is a square in front."""
    if not value.num.is_monomial():
        return value
    [(m, c)] = value.num.terms.items()
    roots = [(index, exponent) for index, exponent in m if atoms.atom(index).kind == "root"]
    if len(roots) < 2 and all(exponent > 0 for _, exponent in roots):
        return value
    radicand = UNITY
    for index, exponent in roots:
        radicand = radicand * atoms.atom(index).arg ** exponent
    rest = Scalar(Poly({tuple(item for item in m if item not in roots): c}), value.den)
    outer = simplified_root(short(radicand), lambda name: given.sign_of(name) == "positive")
    return outer * rest
