"""Display tree -> boxes: every decision of textbook typesetting, made once for all formats."""

from __future__ import annotations

from functools import lru_cache

from rbpsym.notation import algebra_layout, calculus_layout
from rbpsym.notation import boxes as b
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.setting import SUM, Style, draw, draws, wrapped

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


DRAWN_BY = (algebra_layout, calculus_layout)  # loaded: they enter what they draw


@lru_cache(maxsize=4096)
def layout(node: t.Node, notation: Notation = DEFAULT, mode: str = "display") -> b.Box:
    """The boxes of a formula; `mode` is "display", "inline" or "text"."""
    return draw(node, Style(notation, mode))


@lru_cache(maxsize=4096)
def layout_rows(node: t.Node, notation: Notation = DEFAULT, mode: str = "display") -> b.Rows:
    """A chain `a = b = c`, or a system, as rows that are aligned at their relation signs."""
    return aligned(node, Style(notation, mode))
