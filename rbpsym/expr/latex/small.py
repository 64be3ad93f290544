"""How small the sides of a relation are: dW = F dx is of first order on both; else an italic d is no differential."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

from rbpsym.expr import tree as t
from rbpsym.expr.latex.tokens import closed
from rbpsym.expr.symbol_table import LatexReader

Orders = frozenset[int | Fraction]
_JOINED, _SUMMED = ("dotted", "crossed"), ("sum", "named", "marked", "±", "∓")
_REACHING, _WHOLE = ("varied", "several", "operator", "∂", "∇"), ("integral", "path", "∮")


def is_small(node: t.Node) -> bool:
    """Is it a differential?"""
    return isinstance(node, t.Formal) and node.kind == "differential"


def differentials(node: t.Node, text: str) -> list[tuple[int, int]]:
    """Where a differential begins with an italic d."""
    return [part.span for part in t.walk(node) if is_small(part) and part.span and text[part.span[0]] == "d"]


def is_balanced(node: t.Node, text: str) -> bool:
    """Is no side of a relation known to be small where another is known not to be? An area dA is dx dy, of any order."""
    if isinstance(node, t.Relations):
        return all(is_balanced(row, text) for row in node.rows)
    if not isinstance(node, t.Chain) or not differentials(node, text):
        return True
    return len({0 in one for one in map(_orders, node.items) if one}) < 2


def _orders(node: t.Node) -> Orders:
    """The order; none where it is not known: for 0, a change or variation, and for a sum of several, x + dx."""
    kind = node.kind if isinstance(node, t.Formal) else ""
    if kind == "differential" and isinstance(node, t.Formal):
        told = node.parts[-1] if node.parts[1:] else t.ONE  # d², đ; any other is what it is divided by
        return frozenset([told.value] if isinstance(told, t.Num) else [1] if isinstance(told, t.Word) else [])
    parts = [_orders(part) for part in t.children(node)]
    if isinstance(node, (t.Mul, t.Dot, t.Cross)) or kind in _JOINED:
        return frozenset(map(sum, product(*parts)))
    if isinstance(node, t.Div):
        return frozenset(above - below for above, below in product(*parts) if not above * below)  # none: dσ/(d cos θ)
    if isinstance(node, (t.Add, t.Neg, t.Group, t.Abs)) or kind in _SUMMED:
        return parts[0] if len({*parts}) == 1 else frozenset()
    if isinstance(node, t.Pow) and isinstance(node.exponent, t.Num):
        return frozenset(one * node.exponent.value for one in parts[0])
    whole = isinstance(node, (t.Integral, t.PathIntegral, t.BodyIntegral)) or kind in _WHOLE
    known = all(parts) and not isinstance(node, (t.Delta, t.Word)) and kind not in _REACHING and node != t.ZERO
    return frozenset([0]) if whole or (known and {*parts} <= {frozenset([0])}) else frozenset()


def is_material(reader: LatexReader) -> bool:
    """Does a D stand in front above and below, as in Dv/Dt?"""
    places = (reader.position, closed(reader.tokens, reader.position) + 1)
    texts = ["".join(token.text for token in reader.tokens[place : place + 3]) for place in places]
    return texts[0][:2] == texts[1][:2] == "{D" and texts[0][2:] not in ("_", "^", "'") and texts[1][2:].isalpha()
