"""What is taken out of a sum before it is printed: common factors, numbers, shared sums, irreducible factors."""

from __future__ import annotations

import math
from fractions import Fraction
from math import isqrt

from rbpsym.algebra import atoms
from rbpsym.algebra.poly import ONE, Coefficient, Monomial, Poly, inverse, tidy, times
from rbpsym.algebra.style import Style, is_quadratic, moves, split, term_key
from rbpsym.quantities import LENGTH, MASS, NUMBER

MOST_FACTORED, FEW = 16, 6  # terms; longer sums are not worth the search for factors


def taken_out(poly: Poly, style: Style) -> tuple[Coefficient, Monomial, Poly]:
    """(coefficient, monomial, rest) with poly = coefficient × monomial × rest."""
    if poly.is_monomial():
        [(m, c)] = poly.terms.items()
        return c, m, ONE
    if is_inertia(poly, style):
        common = split(_common_powers(poly), style)[1]
        number = Fraction(1, 2) if is_quadratic(common) else 1
        return number, common, poly.scaled(Fraction(1) / number, inverse(common)) if common else poly
    common = _common_powers(poly)
    rest = poly.scaled(1, inverse(common)) if common else poly
    coefficient = common_coefficient(rest, style)
    if coefficient != 1:
        rest = rest.scaled(Fraction(1) / coefficient)
    return coefficient, common, rest


def is_inertia(poly: Poly, style: Style) -> bool:
    """Whether the parameters of every term form a moment of inertia, which a reader wants to see one by one."""
    if any(c < 0 for c in poly.terms.values()) or square(poly.scaled(1, inverse(_common_powers(poly)))) is not None:
        return False
    return bool(style.dimensions) and all(_is_inertia_term(split(m, style)[0], style) for m in poly.terms)


def _is_inertia_term(fixed: Monomial, style: Style) -> bool:
    total = NUMBER
    for index, exponent in fixed:
        name = atoms.symbol_name(index)
        if name is None:
            return False
        total = total * style.dimensions.get(name, NUMBER) ** exponent
    return total == MASS * LENGTH**2


def _common_powers(poly: Poly) -> Monomial:
    shared: dict[int, int] | None = None
    for m in poly.terms:
        powers = dict(m)
        if shared is None:
            shared = powers
            continue
        shared = {i: _nearer(e, powers[i]) for i, e in shared.items() if i in powers and e * powers[i] > 0}
    return tuple(sorted((shared or {}).items()))


def _nearer(a: int, b: int) -> int:
    return min(a, b) if a > 0 else max(a, b)


def divisors(den: Poly) -> Monomial:
    """What some terms of a denominator are divided by: both sides are multiplied by it."""
    lowest: dict[int, int] = {}
    for m in den.terms:
        for index, exponent in m:
            lowest[index] = min(lowest.get(index, 0), exponent)
    return tuple(sorted((index, -exponent) for index, exponent in lowest.items() if exponent < 0))


def plain_value(poly: Poly) -> float | None:
    """The value of a polynomial in π alone."""
    if any(atoms.symbol_name(index) != "pi" for index in poly.atoms()):
        return None
    return sum(float(c) * math.prod(math.pi**e for _, e in m) for m, c in poly.terms.items())


def common_coefficient(poly: Poly, style: Style) -> Coefficient:
    """The number, its sign included, that is taken out of a sum (1 where a reader would leave it)."""
    found = square(poly)
    if found is not None:
        return found[0]
    values = list(poly.terms.values())
    sign = -1 if leads_negative(poly, style) else 1
    content = poly.content()[0]
    whole = all(c.denominator == 1 for c in values)
    if whole:
        return sign * content.numerator
    same = len({c.denominator for c in values}) == 1
    broken = all(c.denominator != 1 for c in values)
    varies = style.whole or (
        any(moves(i, style) for i in poly.atoms()) and not any(is_quadratic(m) for m in poly.terms)
    )
    return tidy(sign * content) if same or style.whole or (broken and varies) else sign


def starts_negative(poly: Poly, style: Style) -> bool:
    """Whether the first term in order is negative."""
    return poly.terms[min(poly.terms, key=lambda m: term_key(m, style))] < 0


def leads_negative(poly: Poly, style: Style) -> bool:
    """Whether all terms are negative, or the one that is taken off is known to be the greater."""
    return all(c < 0 for c in poly.terms.values()) or (len(poly) == 2 and _names(poly, -1, 1) in style.greater)


def leads_positive(poly: Poly, style: Style) -> bool:
    """Whether a difference is known to be positive."""
    return len(poly) == 2 and _names(poly, 1, -1) in style.greater


def _names(poly: Poly, first: int, second: int) -> tuple[str | None, ...]:
    """The two symbols of c (a xⁿ - b yⁿ), a ≥ b, x the one with the sign `first`; c may hold further factors."""
    found = {}
    for m, c in poly.scaled(1, inverse(_common_powers(poly))).terms.items():
        if len(m) == 1 and m[0][1] > 0:
            found[1 if c > 0 else -1] = (atoms.symbol_name(m[0][0]), m[0][1], abs(c))
    if len(found) < 2 or found[1][1] != found[-1][1] or found[first][2] < found[second][2]:
        return (None, None)
    return found[first][0], found[second][0]


def square(poly: Poly) -> tuple[Coefficient, Poly] | None:
    """(c, x ± y) for c (x² ± 2 x y + y²), None for other sums."""
    squares = [(m, c) for m, c in poly.terms.items() if all(e % 2 == 0 for _, e in m)]
    if len(poly) != 3 or len(squares) != 2:
        return None
    [(mixed, twice)] = [item for item in poly.terms.items() if item not in squares]
    number = poly.content()[0] * (1 if squares[0][1] > 0 else -1)
    (x, c), (y, d) = ((tuple((i, e // 2) for i, e in m), _root(c / number)) for m, c in squares)
    twice = twice / number
    if c is None or d is None or times(x, y) != mixed or abs(twice) != 2 * c * d:
        return None
    return tidy(number), Poly({x: c, y: d if twice > 0 else -d})


def _root(c: Coefficient) -> Coefficient | None:
    """The rational square root."""
    if c < 0:
        return None
    top, low = isqrt(c.numerator), isqrt(c.denominator)
    return tidy(Fraction(top, low)) if (top * top, low * low) == (c.numerator, c.denominator) else None


def shared_coefficient(groups: list[dict[Monomial, Coefficient]]) -> Poly | None:
    """The coefficient sum that all groups have up to a number, None if they differ."""
    first = groups[0]
    if len(first) < 2 or any(g.keys() != first.keys() for g in groups[1:]):
        return None
    shared = Poly(first)
    return shared if all(ratio_to(g, shared) is not None for g in groups) else None


def ratio_to(group: dict[Monomial, Coefficient], shared: Poly) -> Coefficient | None:
    """The number that makes one group of the other, None if there is none."""
    ratios = {Fraction(c) / shared.terms[m] for m, c in group.items()}
    return tidy(ratios.pop()) if len(ratios) == 1 else None


def by_moving(poly: Poly, style: Style) -> dict[Monomial, dict[Monomial, Coefficient]]:
    """Coefficients in the parameters by the moving part of the terms."""
    parts: dict[Monomial, dict[Monomial, Coefficient]] = {}
    for m, c in poly.terms.items():
        fixed, moving = split(m, style)
        parts.setdefault(moving, {})[fixed] = c
    return parts


def splits_by_parameters(poly: Poly, style: Style) -> bool:
    """Whether terms with the same parameters belong together (a weight's and a spring's, say)."""
    fixed, moving = zip(*(split(m, style) for m in poly.terms), strict=True)
    return 1 < len(set(fixed)) < len(set(moving))


def is_worth_factoring(poly: Poly, style: Style) -> bool:
    """Short sums, or sums of moving quantities with plain numbers: others hardly ever have factors."""
    if len(poly) < 2 or any(e < 0 for m in poly.terms for _, e in m):
        return False
    plain = all(moves(index, style) for index in poly.atoms())
    return len(poly) <= (MOST_FACTORED if plain else FEW)


def best_factors(poly: Poly, style: Style) -> tuple[Coefficient, tuple[tuple[Poly, int], ...]] | None:
    """Factors of the sum as it is, or with one of sin², cos² replaced; None if it has none."""
    from rbpsym.algebra.sympy_bridge import factors

    for form in _forms(poly):
        coefficient, found = factors(form)
        if len(found) > 1 or (found and found[0][1] > 1):
            return coefficient, found
    return None


def _forms(poly: Poly) -> list[Poly]:
    from rbpsym.algebra.normal import without_squares

    _forms = [poly]
    for kind in ("sin", "cos"):
        form = poly
        for index in sorted(poly.atoms()):
            if atoms.atom(index).kind == kind:
                form = without_squares(form, index)
        if form != poly and len(form) > 1:
            _forms.append(form)
    return _forms
