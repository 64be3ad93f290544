"""What is taken out of a sum before it is printed: common factors, numbers, shared sums, irreducible factors."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import combinations

from rbpsym.field import atoms
from rbpsym.field.poly import ONE, Coefficient, Monomial, Poly, inverse, size_of, tidy, times
from rbpsym.present.style import Style, is_quadratic, moves, split, term_key, varies
from rbpsym.quantities import LENGTH, MASS, NUMBER

MOST_FACTORED, FEW, FEWEST = 16, 12, 4  # terms; longer sums are not worth the search for factors
ENOUGH = 2  # letters that a common factor of some terms has to save


def taken_out(poly: Poly, style: Style, *, fenced: bool = False) -> tuple[Coefficient, Monomial, Poly]:
    """(coefficient, monomial, rest) with poly = coefficient × monomial × rest.

    A rest that will stand in brackets, because something is taken out of it or, with `fenced`, stands
    before it, has no denominators of its own where that would make several fraction lines.
    """
    if poly.is_monomial():
        [(m, c)] = poly.terms.items()
        return c, m, ONE
    if is_inertia(poly, style) and not style.whole:
        common = split(shared_powers(poly), style)[1]
        number = Fraction(1, 2) if is_quadratic(common) else 1
        return number, common, poly.scaled(Fraction(1) / number, inverse(common)) if common else poly
    common = shared_powers(poly)
    rest = poly.scaled(1, inverse(common)) if common else poly
    coefficient = _energy_half(rest) if is_quadratic(common) else 1
    if coefficient == 1:
        coefficient = common_coefficient(rest, style)
    if coefficient != 1:
        rest = rest.scaled(Fraction(1) / coefficient)
    if (fenced or common or coefficient not in (1, -1)) and _has_several_bars(coefficient, common, rest, style):
        return _over_one_bar(coefficient, common, rest, style)
    return coefficient, common, rest


def _energy_half(rest: Poly) -> Coefficient:
    """½ M (1 + R²/(2 b²)) v², never M (½ + R²/(4 b²)) v²."""
    broken = [c for c in rest.terms.values() if c.denominator != 1]
    return Fraction(1, 2) if broken and all(c.denominator % 2 == 0 and c > 0 for c in rest.terms.values()) else 1


def _has_several_bars(coefficient: Coefficient, common: Monomial, rest: Poly, style: Style) -> bool:
    """Whether a parameter divides some term within the brackets, and there are other fraction lines beside it."""
    power = perfect_power(rest)
    terms = (power[1] if power else rest).terms
    divided = [_divided_by(m, style) for m in terms]
    lines = sum(bool(names) or c.denominator != 1 for names, c in zip(divided, terms.values(), strict=True))
    over = bool(_divided_by(common, style))
    if not any(divided):
        return over and lines > 0
    if style.whole or over or (coefficient.denominator != 1 and not is_quadratic(common)):
        return True
    return lines > 1 and any(set(names) != {"pi"} for names in divided if names)


def _divided_by(m: Monomial, style: Style) -> list[str]:
    """The parameters below the bar of a term."""
    return [atoms.symbol_name(i) or "" for i, e in m if e < 0 and not moves(i, style)]


def _over_one_bar(coefficient: Coefficient, common: Monomial, rest: Poly, style: Style) -> tuple[Coefficient, Monomial, Poly]:
    """The same with all parameters that divide a term of the rest taken out of it."""
    below = split(divisors(rest), style)[0]
    rest = rest.scaled(1, below)
    number = tidy(rest.content()[0])
    return tidy(coefficient * number), times(common, inverse(below)), rest.scaled(Fraction(1) / number)


def is_inertia(poly: Poly, style: Style) -> bool:
    """Whether every term is a moment of inertia, mass times a square, which a reader wants to see one by one."""
    if any(c < 0 for c in poly.terms.values()) or perfect_power(poly.scaled(1, inverse(shared_powers(poly)))):
        return False
    return bool(style.dimensions) and all(_is_inertia_term(split(m, style)[0], style) for m in poly.terms)


def _is_inertia_term(fixed: Monomial, style: Style) -> bool:
    total = NUMBER
    for index, exponent in fixed:
        name = atoms.symbol_name(index)
        dimension = style.dimensions.get(name, NUMBER) if name else NUMBER
        if name is None or (dimension == LENGTH and exponent % 2):
            return False
        total = total * dimension**exponent
    return total == MASS * LENGTH**2


def shared_powers(poly: Poly) -> Monomial:
    """What all terms of a sum have in common."""
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


def common_coefficient(poly: Poly, style: Style) -> Coefficient:
    """The number, its sign included, that is taken out of a sum (1 where a reader would leave it)."""
    found = perfect_power(poly)
    if found is not None:
        number, side, n = found
        return -number if n % 2 and leads_negative(side, style) else number
    values = list(poly.terms.values())
    sign = -1 if leads_negative(poly, style) else 1
    content = poly.content()[0]
    whole = all(c.denominator == 1 for c in values)
    if whole:
        return sign * content.numerator
    same = len({c.denominator for c in values}) == 1
    broken = all(c.denominator != 1 for c in values)
    varies = style.whole or (any(moves(i, style) for i in poly.atoms()) and not any(is_quadratic(m) for m in poly.terms))
    return tidy(sign * content) if same or style.whole or (broken and varies) else sign


def starts_negative(poly: Poly, style: Style) -> bool:
    """Whether the first term in order is negative."""
    return poly.terms[min(poly.terms, key=lambda m: term_key(m, style))] < 0


def leads_negative(poly: Poly, style: Style) -> bool:
    """Whether all terms are negative, or the sum is known to be, such as one in which the greater is taken off."""
    if all(c < 0 for c in poly.terms.values()) or (len(poly) == 2 and _names(poly, -1, 1) in style.greater):
        return True
    return any(c < 0 for c in poly.terms.values()) and len(poly) <= FEW and style.sense(poly) < 0


def leads_backwards(poly: Poly, style: Style) -> bool:
    """Whether a sum of two symbols is to begin with the second in order, which is known to be the greater."""
    found = sorted((m for m in poly.terms), key=lambda m: term_key(m, style))
    names = [atoms.symbol_name(m[0][0]) for m in found if len(m) == 1 and m[0][1] == 1]
    return len(found) == 2 == len(names) and (names[1], names[0]) in style.greater


def joined_squares(found: Iterable[tuple[Poly, int]]) -> list[tuple[Poly, int]]:
    """The factors with (x - y)(x + y) as x² - y², but for a number and a function."""
    left = list(found)
    for first, second in combinations(found, 2):
        product = first[0] * second[0]
        if first[1] == second[1] == 1 and len(first[0]) == len(second[0]) == 2 and _is_of_squares(product):
            left = [factor for factor in left if factor not in (first, second)]
            return [(product, 1), *joined_squares(left)]
    return left


def _is_of_squares(product: Poly) -> bool:
    kinds = {atoms.atom(index).kind for index in product.atoms()}
    return len(product) == 2 and not (() in product.terms and kinds & {"cos", "sin"})


def leads_positive(poly: Poly, style: Style) -> bool:
    """Whether a difference is known to be positive."""
    return (len(poly) == 2 and _names(poly, 1, -1) in style.greater) or (len(poly) <= FEW and style.sense(poly) > 0)


def _names(poly: Poly, first: int, second: int) -> tuple[str | None, ...]:
    """The two symbols of c (a xⁿ - b yⁿ), a ≥ b, x the one with the sign `first`; c may hold further factors."""
    found: dict[int, tuple[str | None, int, Coefficient]] = {}
    poly = poly.scaled(1, divisors(poly))
    for m, c in poly.scaled(1, inverse(shared_powers(poly))).terms.items():
        if len(m) == 1 and m[0][1] > 0:
            found[1 if c > 0 else -1] = (atoms.symbol_name(m[0][0]), m[0][1], size_of(c))
    if len(found) < 2 or found[1][1] != found[-1][1] or found[first][2] < found[second][2]:
        return (None, None)
    return found[first][0], found[second][0]


def perfect_power(poly: Poly) -> tuple[Coefficient, Poly, int] | None:
    """(c, x ± y, n) for c (x ± y)ⁿ multiplied out, n from 2 to 4 (c > 0 where n is odd); None for other sums."""
    n = len(poly) - 1
    pure = [(m, c) for m, c in poly.terms.items() if all(e % n == 0 for _, e in m)] if n in (2, 3, 4) else []
    for first, second in combinations(pure, 2):
        number = poly.content()[0] * (1 if first[1] > 0 or n % 2 else -1)
        (x, c), (y, d) = ((tuple((i, e // n) for i, e in m), _root(c / number, n)) for m, c in (first, second))
        if not c or not d:
            continue
        for sign in (1, -1)[: 2 - n % 2]:
            side = Poly({x: c, y: sign * d})
            if (side**n).scaled(number) == poly:
                return tidy(number), side, n
    return None


def _root(c: Coefficient, n: int) -> Coefficient | None:
    """The rational n-th root; None if there is none."""
    if c < 0:
        root = _root(-c, n) if n % 2 else None
        return None if root is None else -root
    top, low = (round(part ** (1 / n)) for part in (c.numerator, c.denominator))
    return tidy(Fraction(top, low)) if (top**n, low**n) == (c.numerator, c.denominator) else None


def shared_coefficient(groups: list[dict[Monomial, Coefficient]]) -> Poly | None:
    """The coefficient sum that all groups have up to a number, None if they differ."""
    first = groups[0]
    if len(first) < 2 or any(g.keys() != first.keys() for g in groups[1:]):
        return None
    shared = Poly(first)
    return shared if all(ratio_to(g, shared) is not None for g in groups) else None


def ratio_to(group: Mapping[Monomial, Coefficient], shared: Poly) -> Coefficient | None:
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


def gathered(poly: Poly, style: Style) -> list[Poly]:
    """The sum in parts, each with a factor that saves letters: (R² + r²) ω² - 4 g d, not R² ω² + r² ω² - 4 g d."""
    if len(poly) < 3 or style.gathered or is_inertia(poly, style):
        return [poly]
    best, found = (ENOUGH, 0), poly
    parts = sorted({item for m in poly.terms for item in m}, key=lambda item: term_key((item,), style))
    for index, exponent in parts:  # not by their numbers, which depend on what was met before
        shared = [m for m in poly.terms if dict(m).get(index, 0) / exponent >= 1]
        part = Poly({m: poly.terms[m] for m in shared})
        letters = sum(1 + (e != 1) for _, e in shared_powers(part))
        if ((len(part) - 1) * letters, letters) > best:
            best, found = ((len(part) - 1) * letters, letters), part
    return [poly] if len(found) == len(poly) else [found, *gathered(poly - found, style)]


def by_accelerations(poly: Poly) -> list[Poly]:
    """The sum in parts, one for each acceleration and one for what is without any; [] where each stands in one term only."""
    parts: dict[tuple[str, ...], dict[Monomial, Coefficient]] = {}
    for m, c in poly.terms.items():
        parts.setdefault(tuple(name for i, _ in m if (name := atoms.symbol_name(i) or "").endswith("_ddot")), {})[m] = c
    return [Poly(part) for part in parts.values()] if any(len(part) > 1 for names, part in parts.items() if names) else []


def extensions(poly: Poly, style: Style) -> list[Poly]:
    """Parts F (±x ± a)ⁿ of a sum, n = 1 or 2, x coordinates or speeds, a a parameter: k (s - L) beside M g, not k s - k L;
    of sines and cosines, too: v_0²/ℓ² + (2 g/ℓ) (cos θ - cos θ_0).

    Not where a letter of the bracket stands alone in the rest as well, which is collected by that letter.
    """
    found: list[Poly] = []
    rest = poly
    terms = sorted(poly.terms.items(), key=lambda item: term_key(item[0], style))
    for m, c in terms if len(terms) <= FEW and not style.gathered else ():
        before, behind = split(m, style)
        kind = _letter(behind[:1]) if len(behind) == 1 and behind[0][1] == 1 else ""
        if len(behind) != 1 or behind[0][1] not in (1, 2) or not (kind or behind[0][1] == 2) or (not before and c in (1, -1)):
            continue
        whole = _square(rest, c, before, behind[0][0]) if behind[0][1] == 2 else _multiples(rest, c, before, kind)
        letters = whole.scaled(1, inverse(before)).atoms()
        if {varies(i, style) for i in letters} == {True, False} and not _is_bare(rest - whole, letters, style):
            found, rest = [*found, whole], rest - whole
    if not found or not rest:
        return []
    return [*found, rest] if any(varies(i, style) for i in rest.atoms()) else [rest, *found]


def _is_bare(rest: Poly, letters: frozenset[int], style: Style) -> bool:
    """Whether one of the letters stands in a term with nothing that moves but them."""
    return any({i for i, _ in split(m, style)[1]} <= letters and letters & {i for i, _ in m} for m in rest.terms)


def _multiples(poly: Poly, c: Coefficient, before: Monomial, kind: str) -> Poly:
    """The terms ±c F x of the sum, x any letter, or sine, or cosine, F = `before`."""
    return Poly({n: d for n, d in poly.terms.items() if size_of(d) == size_of(c) and _letter(times(n, inverse(before))) == kind})


def _letter(m: Monomial) -> str:
    """Whether it is a letter, a sine or a cosine; "" for others."""
    kind = atoms.atom(m[0][0]).kind if len(m) == 1 and m[0][1] == 1 else ""
    return kind if kind in ("symbol", "sin", "cos") else ""


def _square(poly: Poly, c: Coefficient, before: Monomial, x: int) -> Poly:
    """The terms c F (x ± a)² of the sum, F = `before`; none where it has no such terms."""
    for n in poly.terms:
        a = tuple((i, e // 2) for i, e in times(n, inverse(before)) if e == 2)
        if _letter(a) == "symbol" and a[0][0] != x:
            for sign in (1, -1):
                whole = (Poly({((x, 1),): 1, a: sign}) ** 2).scaled(c, before)
                if whole.terms.items() <= poly.terms.items():
                    return whole
    return Poly({})


def by_letters(poly: Poly, style: Style) -> list[list[Poly]]:
    """The sum in parts with the same power of a letter, for each letter: M g ℓ (M + m) - m² (M + 2 m) v²."""
    if style.gathered or not FEWEST <= len(poly) <= FEW or is_inertia(poly, style):
        return []
    letters = sorted(poly.atoms(), key=lambda i: term_key(((i, 1),), style))  # not by their numbers
    powers = ([part.scaled(1, ((i, k),) if k else ()) for k, part in poly.by_power(i).items()] for i in letters)
    return [parts for parts in powers if 1 < len(parts) < len(poly)]


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


def best_factors(poly: Poly) -> tuple[Coefficient, tuple[tuple[Poly, int], ...]] | None:
    """Factors of the sum as it is, or with one of sin², cos² replaced; None if it has none."""
    from rbpsym.field.ring import factors

    for form in _forms(poly):
        coefficient, found = factors(form)
        if len(found) > 1 or (found and found[0][1] > 1):
            return coefficient, found
    return None


def _forms(poly: Poly) -> list[Poly]:
    from rbpsym.field.normal import without_squares

    _forms = [poly]
    for kind in ("sin", "cos"):
        form = poly
        for index in sorted(poly.atoms()):
            if atoms.atom(index).kind == kind:
                form = without_squares(form, index)
        if form != poly and len(form) > 1:
            _forms.append(form)
    return _forms
