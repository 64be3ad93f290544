"""What stands above a fraction line, below it, before and behind it."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.expr import tree as t
from rbpsym.field import atoms
from rbpsym.field.normal import partner_of
from rbpsym.field.poly import ONE, Coefficient, Monomial, Poly, clean, times
from rbpsym.field.scalar import Scalar
from rbpsym.field.trig import cosine, sine

Piece = tuple[t.Node, bool]  # a factor, and whether it moves
SHORT = 15  # letters, numbers and functions of a sum that stands above the bar where nothing else does


def fraction(above: list[t.Node], below: list[t.Node], sums: list[Piece], lower: list[t.Node], functions: list[t.Node]) -> t.Node:
    """Factors and sums over factors and sums; functions and sums that move stand behind the bar."""
    inside = [node for node, moving in sums if not moving]
    outside = [node for node, moving in sums if moving]
    above, tall = without_tall_roots(above)
    functions = [*tall, *functions]
    if not inside and outside and all(isinstance(node, t.Num) for node in above) and all(map(is_short, outside)):
        inside, outside = outside, []
    if not above and not inside and not outside:
        inside, functions = functions, []
    whole = t.div(t.mul(*roots_last([*above, *inside])), t.mul(*roots_last(sums_before_functions([*below, *lower]))))
    return t.mul(whole, *sums_before_functions([*functions, *outside]))


def over(head: t.Div, sums: list[Piece], behind: list[t.Node]) -> t.Node:
    """A fraction that has a parameter below it, times sums and what moves.

    Short sums of parameters stand above the bar; where nothing else does, unknowns or any short sums do.
    """
    top = [node for node, moving in sums if not moving and is_short(node)]
    if isinstance(head.num, t.Num) and not top:
        top = [node for node in behind if isinstance(powered(node)[0], t.Sym)]
        top = top or [node for node, _ in sums if all(is_short(node) for node, _ in sums)]
    rest = [node for node in (*behind, *(node for node, _ in sums)) if node not in top]
    return t.mul(t.div(t.mul(*roots_last([head.num, *top])), head.den), *sums_before_functions(rest))


def is_half(head: t.Node, sums: list[Piece]) -> bool:
    """Whether one over a number stands before one short sum of parameters: (c + μ b)/2."""
    one = isinstance(head, t.Div) and head.num == t.ONE and len(sums) == 1
    return one and all(not moving and is_short(node) for node, moving in sums)


def is_over_parameter(head: t.Node) -> bool:
    """Whether something else than a number is divided by."""
    return isinstance(head, t.Div) and not isinstance(head.den, t.Num)


def without_shared(upper: list[Piece], lower: list[Piece]) -> tuple[list[Piece], list[Piece]]:
    """(R - a)/(R - a)² is 1/(R - a)."""
    for k, (above, moving) in enumerate(upper):
        for j, (below, _) in enumerate(lower):
            (base, power), (other, lower_power) = powered(above), powered(below)
            if base == other:
                left = min(power, lower_power)
                upper = [*upper[:k], (t.power(base, power - left), moving), *upper[k + 1 :]]
                lower = [*lower[:j], (t.power(base, lower_power - left), moving), *lower[j + 1 :]]
                return without_shared(*([piece for piece in pieces if piece[0] != t.ONE] for pieces in (upper, lower)))
    return upper, lower


def powered(node: t.Node) -> tuple[t.Node, Coefficient]:
    """Base and exponent of a factor."""
    if isinstance(node, t.Pow) and isinstance(node.exponent, t.Num):
        return node.base, node.exponent.value
    return node, 1


def is_short(node: t.Node) -> bool:
    """Whether a formula has few letters, and no bar of its own."""
    parts = list(t.walk(node))
    return not any(isinstance(part, t.Div) for part in parts) and sum(map(_is_letter, parts)) <= SHORT


def _is_letter(node: t.Node) -> bool:
    return isinstance(node, (t.Sym, t.Num, t.Fn))


def sums_before_functions(factors: list[t.Node]) -> list[t.Node]:
    """(s + x cos β) sin β: a function in front of parentheses could be read as one of what they hold."""
    functions = [node for node in factors if isinstance(powered(node)[0], t.Fn)]
    if not any(isinstance(powered(node)[0], t.Add) for node in factors):
        return factors
    return [*(node for node in factors if node not in functions), *functions]


def without_tall_roots(factors: list[t.Node]) -> tuple[list[t.Node], list[t.Node]]:
    """The factors that may stand above a bar, and roots, which stand behind it if one is of a fraction."""
    roots: list[t.Node] = [node for node in factors if isinstance(node, t.Sqrt)]
    if not any(isinstance(node, t.Sqrt) and isinstance(node.arg, t.Div) for node in roots):
        return factors, []
    return [node for node in factors if node not in roots], roots


def roots_last(factors: list[t.Node]) -> list[t.Node]:
    """M (3 R - 2 h) √(2 g h), the sum before the root."""
    plain = [node for factor in factors for node in (factor.factors if isinstance(factor, t.Mul) else (factor,))]
    if not any(isinstance(powered(node)[0], t.Add) for node in plain):
        return plain
    return sorted(plain, key=lambda node: isinstance(powered(node)[0], t.Sqrt))


Terms = Mapping[Monomial, Coefficient]
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
    others = partner_of(first), partner_of(second)
    if set(others) & {index for index, exponent in rest if exponent < 0}:
        return None  # tan A cos B + sin B stays
    other = times(rest, tuple(sorted((index, 1) for index in others)))
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
