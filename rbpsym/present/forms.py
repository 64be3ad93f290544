"""Display trees for values that the engine computed, in the form that a textbook prints.

Common factors stand in front, parameters before speeds and functions, coefficients of the
same function are collected, a sum begins with a positive term. The tree's value is the
scalar it was made of (the derivation proves it again for every tree that it prints).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from rbpsym.expr import tree as t
from rbpsym.field import atoms
from rbpsym.field.effort import remembered
from rbpsym.field.poly import ONE, UNIT, Coefficient, Monomial, Poly, inverse, size_of, tidy, times
from rbpsym.field.roots import side_of, with_numbers_inside
from rbpsym.field.scalar import Scalar
from rbpsym.present import bars, grouping
from rbpsym.present.signs import is_upside_down, positive_first, turned, turned_below
from rbpsym.present.style import PLAIN, Style, atom_key, is_quadratic, moves, split, term_key, unsigned, varies

Pieces = tuple[Coefficient, list[bars.Piece]]


def present(value: Scalar, style: Style = PLAIN, *, factor: bool = False) -> t.Node:
    """The value as a display tree; `factor` looks for irreducible factors of sums."""
    return _presented(value, style, factor)


@remembered
def _presented(value: Scalar, style: Style, factor: bool) -> t.Node:
    value = with_numbers_inside(value)
    if value.den is ONE:
        return present_poly(bars.with_joined_angles(value.num), style, factor)
    return _ratio(value.num, value.den, replace(style, whole=True), factor)


def _ratio(num: Poly, den: Poly, style: Style, factor: bool) -> t.Node:
    """num/den with the functions that divide out kept behind the fraction, and no fractions in the sums below it.

    What stands before the sums above and below is cancelled, the sums are kept as they are.
    """
    if den.is_monomial():
        return present(Scalar(num) / Scalar(den), style, factor=factor)
    num, den = bars.with_joined_angles(num), bars.with_joined_angles(den)
    if is_upside_down(den, style):
        num, den = -num, -den
    if below := grouping.divisors(den):
        num, den = num.scaled(1, below), den.scaled(1, below)
    a, low, den = grouping.taken_out(den, style, fenced=True)
    content = den.content()[0]
    a, den = a * content, den.scaled(Fraction(1) / content)
    b, high, num = grouping.taken_out(num, style, fenced=True)
    same = grouping.ratio_to(num.terms, den) if num.terms.keys() == den.terms.keys() else None
    if same is not None:
        b, num, den = b * same, ONE, ONE
    more, lower = (1, []) if den == ONE else _groups(den, style, factor)
    further, upper = (1, []) if num == ONE else _groups(num, style, factor)
    upper, lower = bars.without_shared(upper, lower)
    coefficient, upper = turned(Fraction(b) * further / (a * more), upper, style)
    coefficient, lower = turned_below(coefficient, lower, style)
    node = _quotient(size_of(coefficient), times(high, inverse(low)), upper, [n for n, _ in lower], style)
    return t.neg(node) if coefficient < 0 else node


def _quotient(size: Coefficient, common: Monomial, upper: list[bars.Piece], lower: list[t.Node], style: Style) -> t.Node:
    """size × common × sums over sums."""
    before, behind = split(common, style)
    behind, tangents = _tangents(behind, style)
    functions = [*_powers(behind, style), *tangents]
    above = [*_number(size.numerator), *_powers(before, style)]
    below = [*_number(size.denominator), *_powers(tuple((i, -e) for i, e in (*before, *behind) if e < 0), style)]
    return bars.fraction(above, below, upper, lower, functions)


def _number(size: int) -> list[t.Node]:
    return [t.Num(size)] if size != 1 else []


def present_poly(poly: Poly, style: Style = PLAIN, factor: bool = False) -> t.Node:
    """A polynomial as a tree."""
    if not poly.terms:
        return t.ZERO
    if poly.is_monomial():
        [(m, c)] = poly.terms.items()
        return _signed(c, m, style)
    if any(e < 0 and moves(i, style) for i, e in grouping.shared_powers(poly)):  # over sin β: no further bars in the sum
        style = replace(style, whole=True)
    coefficient, common, rest = grouping.taken_out(poly, style)
    more, pieces = _groups(rest, style, factor)
    coefficient = coefficient * more
    if not common and coefficient == 1:
        return t.mul(*(node for node, _ in pieces))
    return _assembled(coefficient, common, pieces, style)


def _assembled(coefficient: Coefficient, common: Monomial, pieces: list[bars.Piece], style: Style) -> t.Node:
    coefficient, pieces = turned(coefficient, pieces, style)
    before, behind = split(common, style)
    behind, tangents = _tangents(behind, style)
    fixed = [node for node, moving in pieces if not moving]
    moving = [*tangents, *(node for node, moves in pieces if moves)]
    low = _powers(tuple((i, -e) for i, e in behind if e < 0), style)
    head = _monomial_node(size_of(coefficient), before, style, is_quadratic(behind) and not low)
    over_it = bars.is_over_parameter(head) or (bars.is_half(head, pieces) and not is_quadratic(behind))
    if not low and over_it and isinstance(head, t.Div):
        node = bars.over(head, [*pieces, *((tangent, True) for tangent in tangents)], _powers(behind, style))
        return t.neg(node) if coefficient < 0 else node
    factors = bars.sums_before_functions([*_powers(behind, style), *moving])
    top, bottom = (head.num, head.den) if low and isinstance(head, t.Div) else (head, t.ONE)
    node = t.div(t.mul(top, *fixed, *factors), t.mul(bottom, *low))
    return t.neg(node) if coefficient < 0 else node


def _groups(poly: Poly, style: Style, factor: bool) -> Pieces:
    """The rest as a number and one or more (tree, whether it moves) factors."""
    parts = grouping.by_moving(poly, style)
    shared = grouping.shared_coefficient(list(parts.values())) if len(parts) > 1 else None
    if shared is not None:
        rest = Poly({m: ratio for m, fixed in parts.items() if (ratio := grouping.ratio_to(fixed, shared)) is not None})
        return _product(_group(shared, style, factor), _group(rest, style, factor))
    return _group(poly, style, factor)


def _product(first: Pieces, second: Pieces) -> Pieces:
    return first[0] * second[0], first[1] + second[1]


def _group(poly: Poly, style: Style, factor: bool) -> Pieces:
    """One sum with its number and sign taken out, or its factors."""
    found = grouping.best_factors(poly) if factor and grouping.is_worth_factoring(poly, style) else None
    if found is not None:
        return _factor_pieces(*found, style)
    if factor and grouping.splits_by_parameters(poly, style):
        return 1, [(_sum_by_parameters(poly, style), True)]
    number = grouping.common_coefficient(poly, style)
    rest = poly.scaled(Fraction(1) / number) if number != 1 else poly
    return number, [(_sum(rest, style), any(varies(i, style) for i in poly.atoms()))]


def _sum_by_parameters(poly: Poly, style: Style) -> t.Node:
    parts: dict[Monomial, dict[Monomial, Coefficient]] = {}
    for m, c in poly.terms.items():
        parts.setdefault(split(m, style)[0], {})[m] = c
    ordered = sorted(parts.items(), key=lambda item: term_key(item[0], style))
    return t.add(*positive_first([present_poly(Poly(part), style, True) for _, part in ordered]))


def _factor_pieces(coefficient: Coefficient, found: Iterable[tuple[Poly, int]], style: Style) -> Pieces:
    pieces = []
    for base, power in grouping.joined_squares([(bars.with_joined_angles(base), power) for base, power in found]):
        content = base.content()[0]
        base, coefficient = base.scaled(Fraction(1) / content), coefficient * content**power
        if grouping.leads_negative(base, style) or (power % 2 == 0 and grouping.starts_negative(base, style)):
            base, coefficient = -base, coefficient * (-1) ** power
        pieces.append((t.power(_sum(base, style), power), any(varies(i, style) for i in base.atoms())))
    return tidy(coefficient), pieces


def _sum(poly: Poly, style: Style) -> t.Node:
    """A sum, coefficients of the same moving part collected, a positive term first; a square or cube as such."""
    if grouping.perfect_power(poly) is not None:
        return _plain_sum(poly, style)
    parts = grouping.by_moving(poly, style)
    if len(parts) == 1:
        return _plain_sum(poly, style)
    collected = sorted(parts.items(), key=lambda item: term_key(item[0], style))
    plain = t.add(*positive_first([_collected(moving, Poly(fixed), style) for moving, fixed in collected]))
    ways = ((grouping.extensions(poly, style), True), (grouping.by_accelerations(poly), False))
    return min([plain, *(_of_parts(parts, style, factor) for parts, factor in ways if len(parts) > 1)], key=_length)


def _plain_sum(poly: Poly, style: Style) -> t.Node:
    found = grouping.perfect_power(poly)
    if found is not None:
        number, side, n = found
        whole = t.power(_plain_sum(-side if n % 2 == 0 and grouping.leads_negative(side, style) else side, style), n)
        size = t.mul(_monomial_node(size_of(number), UNIT, style), whole)
        return t.neg(size) if number < 0 else size
    inner, parts = replace(style, gathered=True), grouping.gathered(poly, style)
    plain = _of_parts(parts, inner) if len(parts) > 1 else _in_order(poly, style)
    ways = [plain, *(_of_parts(parts, inner) for parts in grouping.by_letters(poly, style))]
    return min(ways, key=_length)


def _length(node: t.Node) -> int:
    return sum(1 for _ in t.walk(node))


def _of_parts(parts: list[Poly], style: Style, factor: bool = True) -> t.Node:
    return t.add(*positive_first([present_poly(part, style, factor) for part in parts]))


def _in_order(poly: Poly, style: Style) -> t.Node:
    ordered = sorted(poly.terms.items(), key=lambda item: term_key(item[0], style))
    if grouping.leads_backwards(poly, style):
        ordered = ordered[::-1]
    return t.add(*positive_first([_signed(c, m, style) for m, c in ordered]))


def _collected(moving: Monomial, fixed: Poly, style: Style) -> t.Node:
    if fixed.is_monomial():
        [(m, c)] = fixed.terms.items()
        both = tuple(sorted((dict(m) | dict(moving)).items()))
        return _signed(c, both, style)
    if grouping.is_inertia(fixed, style) and is_quadratic(moving) and not style.whole:  # an energy: ½Iω²
        return _assembled(Fraction(1, 2), moving, [(_plain_sum(fixed.scaled(2), style), False)], style)
    style = replace(style, whole=True) if any(e < 0 for _, e in moving) else style
    coefficient, common, rest = grouping.taken_out(fixed, style, fenced=True)
    both = tuple(sorted((dict(common) | dict(moving)).items()))
    return _assembled(coefficient, both, [(_plain_sum(rest, style), False)], style)


def _signed(c: Coefficient, m: Monomial, style: Style) -> t.Node:
    before, behind = split(m, style)
    behind, tangents = _tangents(behind, style)
    head, powers = _monomial_node(size_of(c), before, style, is_quadratic(behind)), _powers(behind, style)
    node = t.mul(head, *powers)
    if isinstance(head, t.Div) and isinstance(head.num, t.Num) and bars.is_over_parameter(head):  # x²/p, not (1/p) x²
        node = bars.over(head, [], powers)
    deeper = tuple((i, -e) for i, e in behind if e < 0)
    if deeper:
        node = _with_denominator(size_of(c), before, behind, style)
    node = t.mul(*([] if node == t.ONE and tangents else [node]), *tangents)
    return t.neg(node) if c < 0 else node


QUOTIENTS = {"sin": ("cos", "tan"), "cos": ("sin", "cot")}


def _tangents(m: Monomial, style: Style) -> tuple[Monomial, list[t.Node]]:
    """sin A / cos A is printed tan A, sin² A / cos A sin A tan A; what is left of the monomial, and the tangents."""
    powers, nodes = dict(m), []
    for index, exponent in m if style.tangents else ():
        found = atoms.atom(index)
        other, name = QUOTIENTS.get(found.kind, ("", ""))
        below = atoms.intern(other, found.arg) if other else -1
        low = -powers.get(below, 0)
        if exponent >= low > 0:
            nodes.append(t.power(t.Fn(name, angle_node(found.arg, style)), low))
            del powers[below]
            powers[index] = exponent - low
    return (tuple(item for item in powers.items() if item[1]), nodes) if nodes else (m, [])


def _with_denominator(c: Coefficient, before: Monomial, behind: Monomial, style: Style) -> t.Node:
    """A term that has moving quantities below the bar."""
    top: list[t.Node] = [t.Num(c.numerator)] if c.numerator != 1 else []
    top += _powers(tuple(i for i in before if i[1] > 0), style) + _powers(tuple(i for i in behind if i[1] > 0), style)
    low: list[t.Node] = [t.Num(c.denominator)] if c.denominator != 1 else []
    low += _powers(tuple((i, -e) for i, e in before if e < 0), style)
    low += _powers(tuple((i, -e) for i, e in behind if e < 0), style)
    return t.div(t.mul(*top), t.mul(*low))


def _monomial_node(c: Coefficient, m: Monomial, style: Style, number_in_front: bool = False) -> t.Node:
    """A positive coefficient with its parameters, as one fraction."""
    above = _powers(tuple(i for i in m if i[1] > 0), style)
    below = _powers(tuple((i, -e) for i, e in m if e < 0), style)
    if number_in_front and not below and c.denominator != 1:
        return t.mul(t.Div(t.Num(c.numerator), t.Num(c.denominator)), *above)
    low = t.mul(*([t.Num(c.denominator)] if c.denominator != 1 else []), *below)
    above, tall = bars.without_tall_roots(above) if low != t.ONE else (above, [])
    top = t.mul(*([t.Num(c.numerator)] if c.numerator != 1 or not above else []), *above)
    return t.mul(t.div(top, low), *tall)


def _powers(m: Monomial, style: Style) -> list[t.Node]:
    """The positive powers of a monomial as factors in textbook order."""
    ordered = sorted((item for item in m if item[1] > 0), key=lambda item: atom_key(item[0], style))
    return [t.power(atom_node(index, style), exponent) for index, exponent in ordered]


def atom_node(index: int, style: Style = PLAIN) -> t.Node:
    """One atom as a tree."""
    found = atoms.atom(index)
    if (letter := next((name for own, name, _ in style.called if own == index), "")) or found.kind == "symbol":
        return t.Sym(letter or found.arg)
    if isinstance(found.arg, Poly):
        return t.Fn(found.kind, angle_node(found.arg, style))
    if found.kind == "root":
        side = side_of(found.arg)
        if side is None:
            return t.Sqrt(_radicand(found.arg, style))
        inner = present(side, style, factor=True)
        return t.Abs(inner.arg if isinstance(inner, t.Neg) else inner)
    inner = present(found.arg, unsigned(style) if found.kind == "acos" else style, factor=True)
    return t.neg(t.Fn(found.kind, inner.arg)) if found.kind in ODD and isinstance(inner, t.Neg) else t.Fn(found.kind, inner)


ODD = ("atan", "asin")


def _radicand(value: Scalar, style: Style) -> t.Node:
    """Below a root, a sum has one fraction line at most."""
    if value.den is not ONE or len(value.num) < 2 or not grouping.divisors(value.num):
        return present(value, style, factor=True)
    coefficient, common, rest = grouping.taken_out(value.num, replace(style, whole=True), fenced=True)
    more, pieces = _groups(rest, style, True)
    return _assembled(coefficient * more, common, pieces, style)


def angle_node(angle: Poly, style: Style = PLAIN) -> t.Node:
    """The argument of a sine: its terms, a positive one first, nothing taken out."""
    terms = with_numbers_inside(Scalar(angle)).num.terms
    ordered = sorted(terms.items(), key=lambda item: term_key(item[0], style))
    return t.add(*positive_first([_signed(c, m, style) for m, c in ordered]))
