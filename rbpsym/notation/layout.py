"""Display tree -> boxes: every decision of textbook typesetting, made once for all formats."""

from __future__ import annotations

from functools import lru_cache

from rbpsym.notation import (
    algebra_layout,
    atom_layout,
    calculus_layout,
    function_layout,
    relation_layout,
    setting,
)
from rbpsym.notation import boxes as b
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.setting import Style

DRAWN_BY = (atom_layout, algebra_layout, function_layout, calculus_layout, relation_layout)


@lru_cache(maxsize=4096)
def layout(node: t.Node, notation: Notation = DEFAULT, mode: str = "display") -> b.Box:
    """The boxes of a formula; `mode` is "display", "inline" or "text"."""
    return setting.draw(node, Style(notation, mode))


@lru_cache(maxsize=4096)
def layout_rows(node: t.Node, notation: Notation = DEFAULT, mode: str = "display") -> b.Rows:
    """A chain `a = b = c`, or a system, as rows that are aligned at their relation signs."""
    return relation_layout.aligned(node, Style(notation, mode))
