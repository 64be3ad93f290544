"""Display trees for values that the engine computed, in the form that a textbook prints.

Common factors stand in front, parameters before speeds and functions, coefficients of the
same function are collected, a sum begins with a positive term. The tree's value is the
scalar it was made of (the derivation proves it again for every tree that it prints).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from rbpsym.algebra import atoms
from rbpsym.algebra.poly import ONE, UNIT, Coefficient, Monomial, Poly, inverse, tidy
from rbpsym.algebra.scalar import Scalar
from rbpsym.notation import tree as t
from rbpsym.quantities import LENGTH, MASS, NUMBER, Dimension

DERIVED = ("_dot", "_ddot")
MOST_FACTORED, FEW = 16, 6  # terms; longer sums are not worth the search for factors


@dataclass(frozen=True)
class Style:
    """Order of factors: `rank` sorts parameters, `moving` are names that vary with time.

    With `dimensions`, a sum of moments of inertia keeps its terms whole (m ℓ²/3 + M ℓ²). With
    `whole`, sums get whole coefficients, as above a bar whose denominator has them.
    """

    rank: Mapping[str, tuple] = field(default_factory=dict)
    moving: frozenset[str] = frozenset()
    dimensions: Mapping[str, Dimension] = field(default_factory=dict)
    whole: bool = False


PLAIN = Style()


def present(value: Scalar, style: Style = PLAIN, *, factor: bool = False) -> t.Node:
    """The value as a display tree; `factor` looks for irreducible factors of sums."""
    if value.den is ONE:
        return present_poly(value.num, style, factor)
    return present_ratio(value.num, value.den, replace(style, whole=True), factor=factor)


def present_ratio(num: Poly, den: Poly, style: Style = PLAIN, *, factor: bool = False) -> t.Node:
    """num/den as they are, with the functions that divide out kept behind the fraction."""
    if den.is_monomial():
        return present(Scalar(num) / Scalar(den), style, factor=factor)
    den = present_poly(den, style, factor)
    coefficient, common, rest = _taken_out(num, style)
    more, pieces = (1, []) if rest == ONE else _groups(rest, style, factor)
    coefficient, pieces = _turned(coefficient * more, pieces)
    sign = coefficient < 0
    before, behind = _split(common, style)
    inside = [p for p, moving in pieces if not moving]
    outside = [p for p, moving in pieces if moving]
    size = abs(coefficient)
    above = _powers(before, style)
    below = _powers(tuple((i, -e) for i, e in before if e < 0), style)
    num = t.mul(*([t.Num(size.numerator)] if size.numerator != 1 else []), *above, *inside)
    den = t.mul(*([t.Num(size.denominator)] if size.denominator != 1 else []), *below, den)
    if num == t.ONE and outside and behind == UNIT:
        num, outside = t.mul(*outside), []
    node = t.mul(t.div(num, den), *_powers(behind, style), *outside)
    return t.neg(node) if sign else node


def present_poly(poly: Poly, style: Style = PLAIN, factor: bool = False) -> t.Node:
    """A polynomial as a tree."""
    if not poly.terms:
        return t.ZERO
    if poly.is_monomial():
        [(m, c)] = poly.terms.items()
        return _signed(c, m, style)
    coefficient, common, rest = _taken_out(poly, style)
    more, pieces = _groups(rest, style, factor)
    coefficient = coefficient * more
    if not common and coefficient == 1:
        return t.mul(*(node for node, _ in pieces))
    return _assembled(coefficient, common, pieces, style)


def _turned(coefficient: Coefficient, pieces: list[tuple[t.Node, bool]]) -> tuple[Coefficient, list]:
    """-(a - b) is printed b - a."""
    if coefficient > 0:
        return coefficient, pieces
    for k, (node, moving) in enumerate(pieces):
        if isinstance(node, t.Add) and len(node.terms) == 2 and isinstance(node.terms[1], t.Neg):
            turned = t.Add((node.terms[1].arg, t.Neg(node.terms[0])))
            return -coefficient, [*pieces[:k], (turned, moving), *pieces[k + 1 :]]
    return coefficient, pieces


def _assembled(coefficient: Coefficient, common: Monomial, pieces, style: Style) -> t.Node:
    coefficient, pieces = _turned(coefficient, pieces)
    before, behind = _split(common, style)
    fixed = [node for node, moving in pieces if not moving]
    moving = [node for node, moves in pieces if moves]
    head = _monomial_node(abs(coefficient), before, style, _is_quadratic(behind))
    node = t.mul(*([] if head == t.ONE else [head]), *fixed, *_powers(behind, style), *moving)
    return t.neg(node) if coefficient < 0 else node


def _taken_out(poly: Poly, style: Style) -> tuple[Coefficient, Monomial, Poly]:
    """(coefficient, monomial, rest) with poly = coefficient × monomial × rest."""
    if poly.is_monomial():
        [(m, c)] = poly.terms.items()
        return c, m, ONE
    if _is_inertia(poly, style):
        return 1, UNIT, poly
    common = _common_powers(poly)
    rest = poly.scaled(1, inverse(common)) if common else poly
    coefficient = _common_coefficient(rest, style)
    if coefficient != 1:
        rest = rest.scaled(Fraction(1) / coefficient)
    return coefficient, common, rest


def _is_inertia(poly: Poly, style: Style) -> bool:
    """Whether the terms are moments of inertia, which a reader wants to see one by one."""
    if not style.dimensions:
        return False
    total = NUMBER
    for index, exponent in next(iter(poly.terms)):
        name = atoms.symbol_name(index)
        if name is None or _moves(index, style):
            return False
        total = total * style.dimensions.get(name, NUMBER) ** exponent
    return total == MASS * LENGTH**2 and not any(_moves(i, style) for i in poly.atoms())


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


def _common_coefficient(poly: Poly, style: Style) -> Coefficient:
    values = list(poly.terms.values())
    sign = -1 if _leads_negative(poly, style) else 1
    content = poly.content()[0]
    whole = all(c.denominator == 1 for c in values)
    if whole:
        return sign * content.numerator
    same = len({c.denominator for c in values}) == 1
    broken = all(c.denominator != 1 for c in values)
    varies = style.whole or any(_moves(i, style) for i in poly.atoms()) and not any(_is_quadratic(m) for m in poly.terms)
    return tidy(sign * content) if same or style.whole or (broken and varies) else sign


Pieces = tuple[Coefficient, list[tuple[t.Node, bool]]]


def _groups(poly: Poly, style: Style, factor: bool) -> Pieces:
    """The rest as a number and one or more (tree, whether it moves) factors."""
    parts = _by_moving(poly, style)
    shared = _shared_coefficient(list(parts.values())) if len(parts) > 1 else None
    if shared is not None:
        rest = Poly({m: _ratio_to(fixed, shared) for m, fixed in parts.items()})
        return _product(_group(shared, style, factor), _group(rest, style, factor))
    return _group(poly, style, factor)


def _product(first: Pieces, second: Pieces) -> Pieces:
    return first[0] * second[0], first[1] + second[1]


def _group(poly: Poly, style: Style, factor: bool) -> Pieces:
    """One sum with its number and sign taken out, or its factors."""
    found = _best_factors(poly, style) if factor and _is_worth_factoring(poly, style) else None
    if found is not None:
        return _factor_pieces(*found, style)
    if factor and _splits_by_parameters(poly, style):
        return 1, [(_sum_by_parameters(poly, style), True)]
    number = _common_coefficient(poly, style)
    rest = poly.scaled(Fraction(1) / number) if number != 1 else poly
    return number, [(_sum(rest, style), any(_moves(i, style) for i in poly.atoms()))]


def _best_factors(poly: Poly, style: Style) -> tuple[Coefficient, tuple[tuple[Poly, int], ...]] | None:
    """Factors of the sum as it is, or with one of sin², cos² replaced; None if it has none."""
    from rbpsym.algebra.sympy_bridge import factors

    for form in _forms(poly):
        coefficient, found = factors(form)
        if len(found) > 1 or (found and found[0][1] > 1):
            return coefficient, found
    return None


def _forms(poly: Poly) -> list[Poly]:
    from rbpsym.algebra.normal import without_squares

    forms = [poly]
    for kind in ("sin", "cos"):
        form = poly
        for index in sorted(poly.atoms()):
            if atoms.atom(index).kind == kind:
                form = without_squares(form, index)
        if form != poly and len(form) > 1:
            forms.append(form)
    return forms


def _splits_by_parameters(poly: Poly, style: Style) -> bool:
    """Whether terms with the same parameters belong together (a weight's and a spring's, say)."""
    fixed, moving = zip(*(_split(m, style) for m in poly.terms), strict=True)
    return 1 < len(set(fixed)) < len(set(moving))


def _sum_by_parameters(poly: Poly, style: Style) -> t.Node:
    parts: dict[Monomial, dict[Monomial, Coefficient]] = {}
    for m, c in poly.terms.items():
        parts.setdefault(_split(m, style)[0], {})[m] = c
    ordered = sorted(parts.items(), key=lambda item: _term_key(item[0], style))
    return t.add(*_positive_first([present_poly(Poly(part), style, True) for _, part in ordered]))


def _is_worth_factoring(poly: Poly, style: Style) -> bool:
    """Short sums, or sums of moving quantities with plain numbers: others hardly ever have factors."""
    if len(poly) < 2 or any(e < 0 for m in poly.terms for _, e in m):
        return False
    plain = all(_moves(index, style) for index in poly.atoms())
    return len(poly) <= (MOST_FACTORED if plain else FEW)


def _by_moving(poly: Poly, style: Style) -> dict[Monomial, dict[Monomial, Coefficient]]:
    """Coefficients in the parameters by the moving part of the terms."""
    parts: dict[Monomial, dict[Monomial, Coefficient]] = {}
    for m, c in poly.terms.items():
        fixed, moving = _split(m, style)
        parts.setdefault(moving, {})[fixed] = c
    return parts


def _factor_pieces(coefficient: Coefficient, found, style: Style) -> tuple[Coefficient, list[tuple[t.Node, bool]]]:
    pieces = []
    for base, power in found:
        content = base.content()[0]
        base, coefficient = base.scaled(Fraction(1) / content), coefficient * content**power
        if _leads_negative(base, style) or (power % 2 == 0 and _starts_negative(base, style)):
            base, coefficient = -base, coefficient * (-1) ** power
        pieces.append((t.power(_sum(base, style), power), any(_moves(i, style) for i in base.atoms())))
    return tidy(coefficient), pieces


def _starts_negative(poly: Poly, style: Style) -> bool:
    return poly.terms[min(poly.terms, key=lambda m: _term_key(m, style))] < 0


def _leads_negative(poly: Poly, style: Style) -> bool:
    return all(c < 0 for c in poly.terms.values())


def _sum(poly: Poly, style: Style) -> t.Node:
    """A sum, coefficients of the same moving part collected, a positive term first."""
    parts = _by_moving(poly, style)
    if len(parts) == 1:
        return _plain_sum(poly, style)
    collected = sorted(parts.items(), key=lambda item: _term_key(item[0], style))
    nodes = [_collected(moving, Poly(fixed), style) for moving, fixed in collected]
    return t.add(*_positive_first(nodes))


def _shared_coefficient(groups: list[dict[Monomial, Coefficient]]) -> Poly | None:
    """The coefficient sum that all groups have up to a number, None if they differ."""
    first = groups[0]
    if len(first) < 2 or any(g.keys() != first.keys() for g in groups[1:]):
        return None
    shared = Poly(first)
    return shared if all(_ratio_to(g, shared) is not None for g in groups) else None


def _ratio_to(group: dict[Monomial, Coefficient], shared: Poly) -> Coefficient | None:
    ratios = {Fraction(c) / shared.terms[m] for m, c in group.items()}
    return tidy(ratios.pop()) if len(ratios) == 1 else None


def _plain_sum(poly: Poly, style: Style) -> t.Node:
    ordered = sorted(poly.terms.items(), key=lambda item: _term_key(item[0], style))
    return t.add(*_positive_first([_signed(c, m, style) for m, c in ordered]))


def _positive_first(nodes: list[t.Node]) -> list[t.Node]:
    first = next((k for k, node in enumerate(nodes) if not _is_negative(node)), 0)
    return [nodes[first], *nodes[:first], *nodes[first + 1 :]]


def _is_negative(node: t.Node) -> bool:
    return isinstance(node, t.Neg) or (isinstance(node, t.Num) and node.value < 0)


def _collected(moving: Monomial, fixed: Poly, style: Style) -> t.Node:
    if fixed.is_monomial():
        [(m, c)] = fixed.terms.items()
        both = tuple(sorted((dict(m) | dict(moving)).items()))
        return _signed(c, both, style)
    coefficient, common, rest = _taken_out(fixed, style)
    both = tuple(sorted((dict(common) | dict(moving)).items()))
    return _assembled(coefficient, both, [(_plain_sum(rest, style), False)], style)


def _split(m: Monomial, style: Style) -> tuple[Monomial, Monomial]:
    """(parameters, moving part) of a monomial."""
    return tuple(i for i in m if not _moves(i[0], style)), tuple(i for i in m if _moves(i[0], style))


def _moves(index: int, style: Style) -> bool:
    found = atoms.atom(index)
    if found.kind == "symbol":
        return found.arg in style.moving or found.arg.endswith(DERIVED)
    return found.kind in ("cos", "sin") or (found.kind != "root" or bool(_root_moves(found.arg, style)))


def _root_moves(radicand: Scalar, style: Style) -> bool:
    return any(_moves(index, style) for index in radicand.atoms())


def _signed(c: Coefficient, m: Monomial, style: Style) -> t.Node:
    before, behind = _split(m, style)
    node = t.mul(_monomial_node(abs(c), before, style, _is_quadratic(behind)), *_powers(behind, style))
    deeper = tuple((i, -e) for i, e in behind if e < 0)
    if deeper:
        node = _with_denominator(abs(c), before, behind, style)
    return t.neg(node) if c < 0 else node


def _with_denominator(c: Coefficient, before: Monomial, behind: Monomial, style: Style) -> t.Node:
    """A term that has moving quantities below the bar."""
    top = [t.Num(c.numerator)] if c.numerator != 1 else []
    top += _powers(tuple(i for i in before if i[1] > 0), style) + _powers(tuple(i for i in behind if i[1] > 0), style)
    low = [t.Num(c.denominator)] if c.denominator != 1 else []
    low += _powers(tuple((i, -e) for i, e in before if e < 0), style)
    low += _powers(tuple((i, -e) for i, e in behind if e < 0), style)
    return t.div(t.mul(*top), t.mul(*low))


def _is_quadratic(moving: Monomial) -> bool:
    """Whether a speed is squared (an energy): then the number stands as a fraction in front."""
    return any(e == 2 and (atoms.symbol_name(i) or "").endswith("_dot") for i, e in moving)


def _monomial_node(c: Coefficient, m: Monomial, style: Style, number_in_front: bool = False) -> t.Node:
    """A positive coefficient with its parameters, as one fraction."""
    above = _powers(tuple(i for i in m if i[1] > 0), style)
    below = _powers(tuple((i, -e) for i, e in m if e < 0), style)
    if number_in_front and not below and c.denominator != 1:
        return t.mul(t.Div(t.Num(c.numerator), t.Num(c.denominator)), *above)
    top = t.mul(*([t.Num(c.numerator)] if c.numerator != 1 or not above else []), *above)
    low = t.mul(*([t.Num(c.denominator)] if c.denominator != 1 else []), *below)
    return t.div(top, low)


def _powers(m: Monomial, style: Style) -> list[t.Node]:
    """The positive powers of a monomial as factors in textbook order."""
    ordered = sorted((item for item in m if item[1] > 0), key=lambda item: _atom_key(item[0], style))
    return [t.power(atom_node(index, style), exponent) for index, exponent in ordered]


KIND_RANK = {"root": 6, "symbol": 5, "cos": 9, "sin": 8}


def _atom_key(index: int, style: Style) -> tuple:
    found = atoms.atom(index)
    if found.kind == "symbol":
        return style.rank.get(found.arg, _default_rank(found.arg))
    return KIND_RANK.get(found.kind, 10), repr_key(index)


def _default_rank(name: str) -> tuple:
    if name.endswith("_ddot"):
        return (7, 1, name)
    return (7, 0, name) if name.endswith("_dot") else (5, 0, name)


def repr_key(index: int) -> str:
    """A stable text for sorting atoms."""
    from rbpsym.algebra.scalar import _name

    return _name(index)


def _term_key(m: Monomial, style: Style) -> tuple:
    """Terms with accelerations first, then by parameters, constants of motion last."""
    names = [atoms.symbol_name(i) or "" for i, _ in m]
    second = 0 if any(n.endswith("_ddot") for n in names) else 1
    keys = sorted((_atom_key(i, style), -e) for i, e in m)
    return (second, [(str(k), e) for k, e in keys])


def atom_node(index: int, style: Style = PLAIN) -> t.Node:
    """One atom as a tree."""
    found = atoms.atom(index)
    if found.kind == "symbol":
        return t.Sym(found.arg)
    if isinstance(found.arg, Poly):
        return t.Fn(found.kind, angle_node(found.arg, style))
    if found.kind == "root":
        return t.Sqrt(present(found.arg, style))
    return t.Fn(found.kind, present(found.arg, style))


def angle_node(angle: Poly, style: Style = PLAIN) -> t.Node:
    """The argument of a sine: its terms, a positive one first, nothing taken out."""
    ordered = sorted(angle.terms.items(), key=lambda item: _term_key(item[0], style))
    return t.add(*_positive_first([_signed(c, m, style) for m, c in ordered]))
