"""Where the minus of a sum goes: b - a and not -(a - b), a positive term first, no negative denominators."""

from __future__ import annotations

from rbpsym.expr import tree as t
from rbpsym.field.evaluate import scalar
from rbpsym.field.poly import Coefficient, Poly
from rbpsym.present.bars import Piece
from rbpsym.present.grouping import leads_negative, leads_positive, perfect_power
from rbpsym.present.style import Style, moves


def is_upside_down(den: Poly, style: Style) -> bool:
    """Whether the terms that do not vary are all negative: then both sides change their sign."""
    still = [c for m, c in den.terms.items() if not any(moves(i, style) for i, _ in m)]
    if leads_negative(den, style) or leads_positive(den, style):
        return leads_negative(den, style)
    power = perfect_power(den)
    if power is not None:
        return power[0] < 0
    return bool(still) and all(c < 0 for c in still)


def turned(coefficient: Coefficient, pieces: list[Piece], style: Style) -> tuple[Coefficient, list[Piece]]:
    """-(a - b) is printed b - a, unless a is known to be the greater."""
    if coefficient > 0:
        return coefficient, pieces
    for k, (node, moving) in enumerate(pieces):
        if isinstance(node, t.Add) and len(node.terms) == 2 and t.is_negative(node.terms[1]) and _may_turn(node, style):
            turned = t.Add((t.neg(node.terms[1]), t.neg(node.terms[0])))
            return -coefficient, [*pieces[:k], (turned, moving), *pieces[k + 1 :]]
    return coefficient, pieces


def turned_below(coefficient: Coefficient, pieces: list[Piece], style: Style) -> tuple[Coefficient, list[Piece]]:
    """The same of a denominator of parameters; one with functions, 3 (M + m) - 2 m cos² β, has one sign wherever it stands."""
    has_functions = any(isinstance(part, t.Fn) for node, _ in pieces for part in t.walk(node))
    return (coefficient, pieces) if has_functions else turned(coefficient, pieces, style)


def _may_turn(node: t.Add, style: Style) -> bool:
    if _compared(node.terms[0], getattr(node.terms[1], "arg", None)) in style.greater:
        return False
    return style.sense(scalar(node).num) <= 0


def _compared(first: t.Node | None, second: t.Node | None) -> tuple[str | None, str | None]:
    """The names a, b of a - b, aⁿ - bⁿ and 1 - b/a."""
    if isinstance(second, t.Div) and first == t.ONE:
        return _compared(second.den, second.num)
    if isinstance(first, t.Pow) and isinstance(second, t.Pow) and first.exponent == second.exponent:
        return _compared(first.base, second.base)
    (more, first), (less, second) = _counted(first), _counted(second)
    if more > less:
        return _compared(first, second)
    return getattr(first, "name", None), getattr(second, "name", None)


def _counted(node: t.Node | None) -> tuple[Coefficient, t.Node | None]:
    """The number before a product, and the rest."""
    if isinstance(node, t.Mul) and isinstance(node.factors[0], t.Num):
        return node.factors[0].value, t.mul(*node.factors[1:])
    return 1, node


def positive_first(nodes: list[t.Node]) -> list[t.Node]:
    """The terms of a sum, one that is not taken off at the beginning."""
    if not nodes:
        return nodes
    first = next((k for k, node in enumerate(nodes) if not _begins_negative(node)), 0)
    return [nodes[first], *nodes[:first], *nodes[first + 1 :]]


def _begins_negative(node: t.Node) -> bool:
    return t.is_negative(node.terms[0] if isinstance(node, t.Add) else node)
