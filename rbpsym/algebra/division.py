"""Exact division and cancelling of common factors of Laurent polynomials."""

from __future__ import annotations

from rbpsym.algebra.poly import Poly
from rbpsym.algebra.ring import cofactors

LARGEST_GCD = 1_000_000  # products of terms, above which a common factor is not looked for


def cancel(num: Poly, den: Poly) -> tuple[Poly, Poly]:
    """num and den without their common factor (sin² + cos² = 1 used to shorten them first)."""
    from rbpsym.algebra.normal import reduce_squares, shorten

    num, den = shorten(num), shorten(den)
    if len(den) < 2 or not num.terms:
        return num, den
    found = _cancel_plain(num, den)
    if found[1] is not den or not _has_partners(num, den):
        return found
    reduced = reduce_squares(num), reduce_squares(den)
    if not reduced[0].terms or not reduced[1].terms:
        return reduced
    found = _cancel_plain(*reduced)
    return found if found[1] is not reduced[1] else (num, den)


def _cancel_plain(num: Poly, den: Poly) -> tuple[Poly, Poly]:
    """The same (identical `den`) if no common factor is found."""
    if len(num) * len(den) > LARGEST_GCD or not num.atoms() & den.atoms():
        return num, den
    return cofactors(num, den)


def _has_partners(num: Poly, den: Poly) -> bool:
    """Whether a sine and the cosine of the same angle occur, one of them below."""
    from rbpsym.algebra.normal import partner

    everywhere = num.atoms() | den.atoms()
    return any(partner(index) in everywhere for index in den.atoms())


def divide(num: Poly, den: Poly) -> Poly | None:
    """num / den if den divides num (as Laurent polynomials), else None."""
    if not num.terms or den.is_monomial():
        return num * den**-1 if num.terms else num
    above, below = cofactors(num, den)
    return above * below**-1 if below.is_monomial() else None
