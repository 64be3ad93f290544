"""cos A cos B + sin A sin B as cos(A - B), and its three sisters, wherever a sum has both products."""

from __future__ import annotations

from rbpsym.algebra import atoms
from rbpsym.algebra.normal import partner
from rbpsym.algebra.poly import ONE, Coefficient, Monomial, Poly, clean, times
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.trig import cosine, sine

Terms = dict[Monomial, Coefficient]
TRIG = {"cos", "sin"}


def with_joined_angles(poly: Poly) -> Poly:
    """The same polynomial with fewer terms, where two of them are the sine or cosine of a sum of angles."""
    if len(poly) < 2 or sum(atoms.atom(index).kind in TRIG for index in poly.atoms()) < 4:
        return poly
    for m, c in poly.terms.items():
        for first, second in _pairs(m):
            found = _joined(poly.terms, m, c, first, second)
            if found is not None:
                return with_joined_angles(found)
    return poly


def _pairs(m: Monomial) -> list[tuple[int, int]]:
    """Two sines or cosines of different angles that are factors of a term, each once."""
    found = [index for index, exponent in m if exponent == 1 and atoms.atom(index).kind in TRIG]
    return [(a, b) for k, a in enumerate(found) for b in found[k + 1 :] if atoms.atom(a).arg != atoms.atom(b).arg]


def _joined(terms: Terms, m: Monomial, c: Coefficient, first: int, second: int) -> Poly | None:
    """The sum with this term and its partner joined, None if it has no partner."""
    a, b = atoms.atom(first), atoms.atom(second)
    rest = tuple(item for item in m if item[0] not in (first, second))
    if {partner(first), partner(second)} & {index for index, exponent in rest if exponent < 0}:
        return None  # tan A cos B + sin B stays
    other = times(rest, tuple(sorted([(partner(first), 1), (partner(second), 1)])))
    size = terms.get(other)
    if size is None or abs(size) != abs(c):
        return None
    left, right = Scalar(a.arg), Scalar(b.arg)
    if a.kind == b.kind:  # cos A cos B ± sin A sin B
        sign = 1 if size != c else -1
        whole = cosine(left + right if sign > 0 else left - right) * (c if a.kind == "cos" or sign < 0 else -c)
    else:  # sin A cos B ± cos A sin B
        sign = 1 if size == c else -1
        whole = sine(left + right if sign > 0 else left - right) * (c if a.kind == "sin" or sign > 0 else -c)
    if whole.den is not ONE:
        return None
    kept = {key: value for key, value in terms.items() if key not in (m, other)}
    for key, value in whole.num.terms.items():
        joined = times(rest, key)
        kept[joined] = kept.get(joined, 0) + value
    return clean(kept)
