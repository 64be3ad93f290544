"""Whether a square matrix of scalars has a determinant that is not identically zero."""

from __future__ import annotations

from collections.abc import Sequence

from rbpsym.algebra.modular import PRIME, NoImage, value_of
from rbpsym.algebra.scalar import Scalar
from rbpsym.equality.verdict import Verdict, proved, undecided


def regular_verdict(matrix: Sequence[Sequence[Scalar]]) -> Verdict:
    """PROVED if the determinant is not 0 at one point modulo a prime, else UNDECIDED.

    The point is consistent with all relations between the atoms, so a value other than 0 there
    proves that the determinant does not vanish identically.
    """
    try:
        images = [[_image(entry) for entry in row] for row in matrix]
    except (NoImage, ZeroDivisionError, ValueError):
        return undecided("the determinant of the mass matrix could not be computed at a point")
    if _determinant(images):
        return proved("determinant not zero modulo a prime")
    return undecided("the determinant of the mass matrix is zero at the point that was tried")


def _image(entry: Scalar) -> int:
    return value_of(entry.num) * pow(value_of(entry.den), -1, PRIME) % PRIME


def _determinant(rows: list[list[int]]) -> int:
    """By elimination modulo the prime."""
    product = 1
    while rows:
        place = next((k for k, row in enumerate(rows) if row[0]), None)
        if place is None:
            return 0
        pivot = rows.pop(place)
        product = product * pivot[0] * (-1) ** place % PRIME
        scale = pow(pivot[0], -1, PRIME)
        rows = [[(b - row[0] * scale * a) % PRIME for a, b in zip(pivot[1:], row[1:], strict=True)] for row in rows]
    return product
