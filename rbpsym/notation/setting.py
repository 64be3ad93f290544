"""The frame of typesetting: display tree -> boxes, by the table that `layout` fills.

`algebra_layout` and `calculus_layout` each add a function a node type with `@draws`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from rbpsym.notation import boxes as b
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.levels import level


@dataclass(frozen=True, slots=True)
class Style:
    """`mode` is "display" (fractions with bars), "inline" (exponents: 3/2) or "text" (one line)."""

    notation: Notation = DEFAULT
    mode: str = "display"

    @property
    def script(self) -> Style:
        """The style of exponents and limits: no fractions with bars."""
        return replace(self, mode="inline")


Draw = Callable[..., b.Box]
TABLE: dict[type, Draw] = {}


def draws(*kinds: type) -> Callable[[Draw], Draw]:
    """Enter a function `(node, style) -> Box` into the table for these node types."""

    def enter(function: Draw) -> Draw:
        TABLE.update(dict.fromkeys(kinds, function))
        return function

    return enter


def draw(node: t.Node, style: Style) -> b.Box:
    """The boxes of a formula."""
    return TABLE[type(node)](node, style)


def fenced(box: b.Box, opening: str = "(", closing: str = ")") -> b.Fence:
    """The box between delimiters that grow if it is tall."""
    return b.Fence(opening, box, closing, b.is_tall(box))


def wrapped(node: t.Node, least: int, style: Style) -> b.Box:
    """The boxes of a part, in parentheses if it binds less than `least`."""
    box = draw(node, style)
    return fenced(box) if level(node, style.mode) < least else box
