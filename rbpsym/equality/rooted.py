"""Values in which the roots of squares of positive quantities are taken."""

from __future__ import annotations

from rbpsym.algebra import atoms
from rbpsym.algebra.normal import shorten
from rbpsym.algebra.roots import simplified_root, with_image, without_even_roots
from rbpsym.algebra.scalar import Scalar, quotient
from rbpsym.equality.assumptions import Assumptions


def shorter(value: Scalar) -> Scalar:
    """The value with sin² + cos² = 1 used where that makes it shorter."""
    num = shorten(value.num)
    return value if num is value.num else quotient(num, value.den)


def rooted(value: Scalar, given: Assumptions) -> Scalar:
    """The value with √(x²) = x for what is positive."""
    for index in sorted(value.atoms()):
        found = atoms.atom(index)
        if found.kind == "root":
            inner = found.arg if isinstance(found.arg, Scalar) else Scalar(found.arg)
            image = simplified_root(inner, lambda name: given.sign_of(name) == "positive")
            value = with_image(value.num, index, image) / with_image(value.den, index, image)
    return shorter(without_even_roots(value))
