"""Boxes of relations: chains in one line and in aligned rows."""

from __future__ import annotations

from rbpsym.notation import boxes as b
from rbpsym.notation import tree as t
from rbpsym.notation.levels import SUM
from rbpsym.notation.setting import Style, draw, draws, wrapped

RELATIONS = {
    "=": "=", "<": "<", ">": ">", "<=": "≤", ">=": "≥", "!=": "≠", "~": "≈", "->": "→",
}  # fmt: skip


@draws(t.System)
def aligned(node: t.Node, style: Style) -> b.Rows:
    """A chain or system as aligned rows; any other formula as one row without a left part."""
    if isinstance(node, t.System):
        return b.Rows(tuple(row for part in node.rows for row in aligned(part, style).rows))
    if not isinstance(node, t.Chain) or not node.ops:
        return b.Rows(((b.Row(()), draw(node, style)),))
    lefts = (draw(node.items[0], style), *(b.Row(()) for _ in node.ops[1:]))
    rights = (b.Row((_relation(op), draw(item, style))) for op, item in zip(node.ops, node.items[1:], strict=True))
    return b.Rows(tuple(zip(lefts, rights, strict=True)))


def _relation(op: str) -> b.Operator:
    return b.Operator(RELATIONS[op], "relation")


@draws(t.Chain)
def _chain(node: t.Chain, style: Style) -> b.Box:
    items = [wrapped(node.items[0], SUM, style)]
    for op, item in zip(node.ops, node.items[1:], strict=True):
        items += [_relation(op), wrapped(item, SUM, style)]
    return b.Row(tuple(items))
