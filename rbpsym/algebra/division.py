"""Exact division and cancelling of common factors of Laurent polynomials.

A common factor is first looked for by univariate images modulo a prime (which rule it out
rigorously); only if one may exist, sympy's multivariate greatest common divisor is asked.
"""

from __future__ import annotations

from fractions import Fraction

from rbpsym.algebra.modular import PRIME, free_image, term_values
from rbpsym.algebra.poly import ONE, Monomial, Poly, clean, inverse, times

LARGEST_GCD = 60_000  # products of terms, above which a common factor is not looked for
Terms = list[tuple[dict[int, int], int]]


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
    if not _may_cancel(num, den):
        return num, den
    whole = divide(num, den)
    if whole is not None:
        return whole, ONE
    return _cancel_by_gcd(num, den) if len(num) * len(den) <= LARGEST_GCD else (num, den)


def _has_partners(num: Poly, den: Poly) -> bool:
    """Whether a sine and the cosine of the same angle occur, one of them below."""
    from rbpsym.algebra.normal import partner

    everywhere = num.atoms() | den.atoms()
    return any(partner(index) in everywhere for index in den.atoms())


def divide(num: Poly, den: Poly) -> Poly | None:
    """num / den if den divides num (as Laurent polynomials), else None."""
    num, shift_n = _ordinary(num)
    den, shift_d = _ordinary(den)
    atoms = sorted(num.atoms() | den.atoms())
    rest, lead = dict(num.terms), max(den.terms, key=lambda m: _dense(m, atoms))
    parts: dict[Monomial, Fraction | int] = {}
    for _ in range(4 * len(num) + 50):
        if not rest:
            return clean(parts).scaled(1, times(shift_n, inverse(shift_d)))
        top = max(rest, key=lambda m: _dense(m, atoms))
        step = times(top, inverse(lead))
        if any(exponent < 0 for _, exponent in step):
            return None
        factor = Fraction(rest[top]) / den.terms[lead]
        parts[step] = factor
        _subtract(rest, den, factor, step)
    return None


def _subtract(rest: dict, den: Poly, factor: Fraction, by: Monomial) -> None:
    for m, c in den.terms.items():
        key = times(m, by)
        value = rest.get(key, 0) - factor * c
        if value:
            rest[key] = value
        else:
            rest.pop(key, None)


def _dense(m: Monomial, atoms: list[int]) -> tuple[int, ...]:
    powers = dict(m)
    return tuple(powers.get(index, 0) for index in atoms)


def _ordinary(poly: Poly) -> tuple[Poly, Monomial]:
    _, powers = poly.content()
    return (poly.scaled(1, inverse(powers)), powers) if powers else (poly, ())


def _may_cancel(num: Poly, den: Poly) -> bool:
    """False only if there is no common factor but monomials."""
    shared = num.atoms() & den.atoms()
    if not shared:
        return False
    above, below = term_values(num), term_values(den)
    return any(_may_share(above, below, index) for index in shared)


def _may_share(num: Terms, den: Terms, index: int) -> bool:
    """False only if no common factor contains the atom."""
    a, b = _image(num, index), _image(den, index)
    if len(b) < 2 or len(a) < 2:
        return False
    while b:
        a, b = b, _remainder(a, b)
    return len(a) > 1


def _image(terms: Terms, index: int) -> list[int]:
    """Coefficients modulo the prime by rising power of one atom (from its lowest), the others at
    fixed values."""
    powers = [m.get(index, 0) for m, _ in terms]
    low, high, inverted = min(powers), max(powers), pow(free_image(index), -1, PRIME)
    scales = {power: pow(inverted, power, PRIME) for power in set(powers)}
    image = [0] * (high - low + 1)
    for power, (_, value) in zip(powers, terms, strict=True):
        image[power - low] += value * scales[power]
    return _trim([value % PRIME for value in image])


def _trim(image: list[int]) -> list[int]:
    while image and not image[-1]:
        image.pop()
    return image


def _remainder(a: list[int], b: list[int]) -> list[int]:
    a, lead = list(a), pow(b[-1], -1, PRIME)
    while len(a) >= len(b):
        factor, shift = a[-1] * lead % PRIME, len(a) - len(b)
        for k, value in enumerate(b):
            a[shift + k] = (a[shift + k] - factor * value) % PRIME
        a.pop()
        _trim(a)
    return a


def _cancel_by_gcd(num: Poly, den: Poly) -> tuple[Poly, Poly]:
    from rbpsym.algebra.ring import cofactors

    shift_n, shift_d = num.content()[1], den.content()[1]
    a, b = cofactors(num.scaled(1, inverse(shift_n)), den.scaled(1, inverse(shift_d)))
    return a.scaled(1, shift_n), b.scaled(1, shift_d)
