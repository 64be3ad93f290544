"""Whether the methods give the same accelerations, and whether a mass matrix is regular."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rbpsym.algebra.ideal import vanishes_on
from rbpsym.algebra.modular import PRIME, NoImage, value_of
from rbpsym.algebra.scalar import Scalar
from rbpsym.equality.decide import scalars_equal
from rbpsym.equality.verdict import PROVED, Verdict, proved, undecided
from rbpsym.mechanics.study import Study


def agreement(study: Study, found: Mapping[str, Mapping[str, Scalar] | None]) -> dict[str, Verdict]:
    """For each method that applies: its accelerations against those of Newton's and Euler's equations."""
    known = study.dynamics.accelerations
    if known is None:
        return {}
    return {name: _same(study, values, known) for name, values in found.items() if values}


def _same(study: Study, values: Mapping[str, Scalar], known: Mapping[str, Scalar]) -> Verdict:
    verdict = Verdict(PROVED)
    for name, value in values.items():
        verdict = _equal(study, value, known[name])
        if verdict.kind is not PROVED:
            return verdict
    return verdict


def _equal(study: Study, value: Scalar, known: Scalar) -> Verdict:
    """Equality; where conditions tie the coordinates, only the states that satisfy them count."""
    found = scalars_equal(value, known, study.assumptions)
    ties = [tie.value for tie in study.ties]
    if found.kind is PROVED or not ties:
        return found
    if vanishes_on(value - known, ties):
        return proved("in the ideal of the conditions that tie the coordinates")
    return undecided("the coordinates are tied by conditions that were not solved in closed form")


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
