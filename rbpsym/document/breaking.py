"""How a displayed formula is cut into lines: at relations first, then before + and − of a sum.

All formats break a formula in the same places: widths are estimates in em, from the boxes that
`typeset.layout` makes of the display tree.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache

from rbpsym.document.model import Block, Display, Emph, Inlines, Math, Paragraph, Ref, Strong, Table, Text
from rbpsym.expr.glyphs import Notation
from rbpsym.expr.tree import Node, rows
from rbpsym.frozen import Frozen
from rbpsym.typeset import boxes as b
from rbpsym.typeset.cutting import INDENT, flat, node_width, opened, packed, pieces, terms, width
from rbpsym.typeset.layout import layout_rows

EMPTY = b.Row(())


class DisplayLine(Frozen):
    """One line of a display: what stands before and after the alignment mark.

    An `indent`ed line goes on with the sum of the line above and begins with its sign.
    """

    left: b.Box
    right: b.Box
    indent: bool = False

    @property
    def width(self) -> float:
        """In em."""
        return width(self.left) + width(self.right) + (INDENT if self.indent else 0.0)

    def shown(self, render: Callable[[b.Box], str], mark: str = "", indent: str = "") -> str:
        """What a format prints of it, its alignment mark before the relation sign."""
        return f"{render(self.left)} {mark}{indent if self.indent else ''}{render(self.right)}".strip()


@lru_cache(maxsize=4096)
def lines(node: Node, notation: Notation, column: float) -> tuple[DisplayLine, ...]:
    """The lines of a displayed formula in a column of that many em."""
    parts = rows(node)
    lefts = [width(layout_rows(part, notation).rows[0][0]) for part in parts]
    widest_left = max((left for left in lefts if left <= 0.5 * column), default=0.0)
    room = [column - max(widest_left - left, 0.0) for left in lefts]
    found = tuple(line for part, own in zip(parts, room, strict=True) for line in chain_lines(part, notation, own))
    if widest(found) > column:  # no room with the relation signs below each other: each line from the margin on
        return tuple(DisplayLine(EMPTY, b.Row((*flat(line.left), *flat(line.right))), line.indent) for line in found)
    return found


def display_lines(block: Display, notation: Notation, column: float) -> tuple[DisplayLine, ...]:
    """The lines of a displayed block; its box takes room."""
    return lines(block.node, notation, column - (3.0 if block.boxed else 0.0))


def chain_lines(node: Node, notation: Notation, column: float) -> Iterator[DisplayLine]:
    """The lines of a chain: one, or one for each relation and more for long sums."""
    found = layout_rows(node, notation).rows
    left, rights = found[0][0], tuple(right for _, right in found)
    margin = width(left)
    if margin + sum(map(width, rights)) <= column * SHARES.get(len(rights), SEVERAL):
        yield DisplayLine(left, b.Row(tuple(flat(b.Row(rights)))))
        return
    if margin and margin + max(map(least, rights)) > column:
        yield from long_left(left, rights, column)
        return
    yield from with_short_ends(left, rights, column - margin)


def long_left(left: b.Box, rights: tuple[b.Box, ...], column: float) -> Iterator[DisplayLine]:
    """The lines of a left side that has no room beside a right one; a very short one ("= 0") ends its last line."""
    end = rights[0] if width(rights[0]) <= SHORT else EMPTY
    *before, last = sum_lines(EMPTY, left, column - width(end))
    yield from before
    if end is EMPTY or last.width + width(end) > column:
        yield last
        yield from with_short_ends(EMPTY, rights, column - INDENT)
        return
    yield DisplayLine(EMPTY, b.Row((*flat(last.right), *flat(end))), last.indent)
    yield from with_short_ends(EMPTY, rights[1:], column - INDENT)


# How much of the column a chain of that many relations may fill on one line.
SHARES, SEVERAL = {1: 1.0, 2: 0.9}, 0.9


def with_short_ends(left: b.Box, rights: tuple[b.Box, ...], room: float) -> Iterator[DisplayLine]:
    """A line for each side of a chain; a very short one ("= 0") goes on with the line before."""
    held: DisplayLine | None = None
    for right in rights:
        if held and width(right) <= SHORT and held.width + width(right) <= room:
            held = DisplayLine(held.left, b.Row((*flat(held.right), *flat(right))), held.indent)
            continue
        if held:
            yield held
        *before, held = sum_lines(left, right, room)
        yield from before
        left = EMPTY
    if held:
        yield held


SHORT = 3.0


def sum_lines(left: b.Box, right: b.Box, room: float) -> Iterator[DisplayLine]:
    """A line, or several if its right side is a sum that is too long for the room."""
    groups = [right] if width(right) <= room else list(packed(opened(right, room), room - INDENT))
    yield DisplayLine(left, groups[0])
    yield from (DisplayLine(EMPTY, group, True) for group in groups[1:])


def least(box: b.Box) -> float:
    """The width that a side can be broken down to."""
    return max((width(piece) for term in terms(box) for piece in pieces(term, 0.0)), default=0.0) + INDENT


def widest(found: tuple[DisplayLine, ...]) -> float:
    """The width of the block: its widest left and right parts meet at the alignment mark."""
    return max(width(line.left) for line in found) + max(line.width - width(line.left) for line in found)


INLINE_WIDTHS: Mapping[type, Callable[..., float]] = {
    Text: lambda inline, notation: 0.45 * len(inline.text),
    Ref: lambda inline, notation: 0.45 * len(inline.mark),
    Math: lambda inline, notation: node_width(inline.node, notation),
    Emph: lambda inline, notation: text_width(inline.inlines, notation),
    Strong: lambda inline, notation: 1.1 * text_width(inline.inlines, notation),
}


def text_width(inlines: Inlines, notation: Notation) -> float:
    """The width of inlines on one line, in em."""
    return sum(INLINE_WIDTHS[type(inline)](inline, notation) for inline in inlines)


def is_run_in(block: Block, after: Block | None, notation: Notation, column: float) -> bool:
    """Is a paragraph so short that the formula to which it leads has room in its line?"""
    if not isinstance(block, Paragraph) or not isinstance(after, Display) or after.reason is not None:
        return False
    found = display_lines(after, notation, column)
    return len(found) == 1 and text_width(block.inlines, notation) + found[0].width + NUMBER <= column


NUMBER = 6.0  # em: what the number at the right takes, the box, and the room between


def reason_fits(block: Display, notation: Notation, column: float) -> bool:
    """Is there room for the reason beside the formula (with the number at the right)?"""
    used = widest(display_lines(block, notation, column)) + 0.9 * text_width(block.reason or (), notation)
    return used + 5.0 <= 0.92 * column


NARROW = 9.0


def wrapped_width(block: Table, place: int, notation: Notation, column: float) -> float:
    """The width of a column of words that must be wrapped for the table to have room in a column of the page: what the others
    leave, and no less than a narrow one; 0 if there is room."""
    if column_width(block, place, notation) <= NARROW or table_width(block, notation, math.inf) <= column:
        return 0
    return max(NARROW, math.floor(NARROW + column - table_width(block, notation)))


def column_width(block: Table, place: int, notation: Notation) -> float:
    """The width of a column whose cells do not wrap, in em."""
    return max(text_width(row[place], notation) for row in (block.header, *block.rows))


def is_wordy(block: Table, place: int) -> bool:
    """Does a column hold words that should wrap? (Formulas never do.)"""
    return any(isinstance(inline, Text) and len(inline.text) > 26 for row in block.rows for inline in row[place])


def table_width(block: Table, notation: Notation, narrow: float = NARROW) -> float:
    """The width of a table whose cells do not wrap, but for its narrow columns of words, in em."""
    widths = [column_width(block, place, notation) for place in range(len(block.header))]
    widths = [min(w, narrow) if letter == "p" else w for w, letter in zip(widths, block.columns, strict=True)]
    return sum(widths) + 1.1 * len(widths)
