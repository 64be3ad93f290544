"""Evaluation modulo a 61-bit prime at fixed pseudo-random points.

A non-zero value proves that a polynomial is not identically zero: every relation between
the atoms (sin² + cos² = 1, multiple angles) holds for the chosen values. A zero value
proves nothing and is always followed by the exact normal form.
"""

from __future__ import annotations

from functools import lru_cache
from hashlib import blake2b

from rbpsym.field import atoms
from rbpsym.field.poly import Coefficient, Monomial, Poly

PRIME = (1 << 61) - 1
PARTS = 12  # angles are taken as multiples of (base angle)/12


class NoImage(Exception):
    """The polynomial has an atom without a consistent image (a root, an odd angle)."""


def is_surely_nonzero(poly: Poly) -> bool:
    """True only if the polynomial is not identically zero; False decides nothing."""
    try:
        return bool(value_of(poly))
    except (NoImage, ZeroDivisionError, ValueError):
        return False


def value_of(poly: Poly) -> int:
    """The image of the polynomial."""
    return sum([_coefficient(c) * _monomial(m) for m, c in poly.terms.items()]) % PRIME


def _coefficient(c: Coefficient) -> int:
    return c if type(c) is int else c.numerator * pow(c.denominator, -1, PRIME) % PRIME


@lru_cache(maxsize=65536)
def _monomial(m: Monomial) -> int:
    product = 1
    for index, exponent in m:
        product = product * pow(atom_image(index), exponent, PRIME) % PRIME
    return product


def _random(label: str) -> int:
    return int.from_bytes(blake2b(label.encode(), digest_size=8).digest(), "big") % (PRIME - 2) + 2


@lru_cache(maxsize=8192)
def atom_image(index: int) -> int:
    """The residue of an atom, consistent with all trigonometric relations."""
    found = atoms.atom(index)
    if found.kind in ("cos", "sin"):
        return angle_image(found.arg)[found.kind == "sin"]
    if found.kind == "root":
        raise NoImage
    return _random(f"{found.kind} {index}")


@lru_cache(maxsize=8192)
def angle_image(angle: Poly) -> tuple[int, int]:
    """(cos, sin) of an angle that is a sum of multiples of base angles."""
    point = (1, 0)
    for m, c in angle.terms.items():
        parts = c * PARTS
        if parts.denominator != 1:
            raise NoImage
        point = _turn(point, _power(_base_point(m), int(parts)))
    return point


def _base_point(m: Monomial) -> tuple[int, int]:
    if m == ((atoms.PI, 1),):
        raise NoImage
    t = _random(f"angle {m}")
    scale = pow(1 + t * t, -1, PRIME)
    return (1 - t * t) * scale % PRIME, 2 * t * scale % PRIME


def _turn(a: tuple[int, int], b: tuple[int, int]) -> tuple[int, int]:
    return (a[0] * b[0] - a[1] * b[1]) % PRIME, (a[0] * b[1] + a[1] * b[0]) % PRIME


def _power(point: tuple[int, int], exponent: int) -> tuple[int, int]:
    if exponent < 0:
        point, exponent = (point[0], -point[1]), -exponent
    result = (1, 0)
    while exponent:
        result = _turn(result, point) if exponent & 1 else result
        point, exponent = _turn(point, point), exponent >> 1
    return result
