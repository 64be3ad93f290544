"""Values in which the roots of squares are taken, by the signs that are known."""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.algebra import Poly, Scalar, atoms, quotient, shorten, with_exponentials_joined
from rbpsym.algebra.roots import simplified_root, tidied, with_image, without_even_roots
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.signs import sign


@dataclass(frozen=True, slots=True)
class Senses:
    """The sense of sums under assumptions, for `Style.sense`."""

    given: Assumptions

    def __call__(self, sum_: Poly) -> int:
        return sign(Scalar(sum_), self.given).sense


def shorter(value: Scalar) -> Scalar:
    """The value with sin² + cos² = 1 used where that makes it shorter, and one exponential in each product."""
    value = with_exponentials_joined(value)
    num = shorten(value.num)
    return value if num is value.num else quotient(num, value.den)


def rooted(value: Scalar, given: Assumptions) -> Scalar:
    """The value with √(x²) = x for what is positive."""
    for index in sorted(value.atoms()):
        found = atoms.atom(index)
        if found.kind == "root":
            inner = found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg)
            image = root_of(inner, given)
            value = with_image(value.num, index, image) / with_image(value.den, index, image)
    return shorter(without_even_roots(value))


def root_of(value: Scalar, given: Assumptions) -> Scalar:
    """√value, with what is declared positive and squared taken out."""
    return simplified_root(value, lambda name: given.sign_of(name) == "positive")


def neat(value: Scalar, given: Assumptions) -> Scalar:
    """The value as it is told: one root in each product, which holds no squares."""
    return shorter(tidied(rooted(value, given), lambda part: sign(part, given).sense))
