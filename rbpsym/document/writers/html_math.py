"""Formulas in HTML: MathML whose lines fold at + and − where the screen is narrow."""

from __future__ import annotations

from rbpsym.document import breaking
from rbpsym.document.accents import accented
from rbpsym.document.model import Display
from rbpsym.document.writers.page import Page
from rbpsym.notation import boxes as b
from rbpsym.notation.mathml import render, to_mathml
from rbpsym.notation.tree import Node

OPEN = '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block">'


def inline_math(node: Node, page: Page) -> str:
    """A formula within a sentence."""
    return accented(to_mathml(node, page.notation))


def display_math(block: Display, page: Page) -> str:
    """A displayed formula as a table of lines; the style sheet folds it on a phone."""
    lines = breaking.display_lines(block, page.notation, page.column)
    rows = "".join(map(table_row, lines))
    return accented(f'{OPEN}<mtable displaystyle="true" class="lines">{rows}</mtable></math>')


def table_row(line: breaking.Line) -> str:
    """One line: its left side, then its terms, each of which may move to the next line."""
    left = f'<mtd class="left">{render(line.left)}</mtd>'
    kind = "right indent" if line.indent else "right"
    pieces = "".join(map(folding_piece, folding_pieces(line.right)))
    return f'<mtr>{left}<mtd class="{kind}">{pieces}</mtd></mtr>'


def widest_piece(block: Display, page: Page) -> float:
    """The width in em of the widest part of a formula that stands on one line even on a phone."""
    lines = breaking.display_lines(block, page.notation, page.column)
    return max(breaking.width(piece) for line in lines for piece in (line.left, *folding_pieces(line.right)))


def folding_piece(piece: b.Row) -> str:
    """A piece; the sign at its start keeps the spaces that it has between two terms."""
    first, *others = piece.items
    if not isinstance(first, b.Operator) or first.kind == "prefix":
        return render(piece)
    sign = render(first).replace("<mo>", '<mo form="infix">')
    return f"<mrow>{sign}{render(b.Row(tuple(others)))}</mrow>"


def folding_pieces(box: b.Box) -> tuple[b.Row, ...]:
    """The pieces of a line: cut before each relation sign and each sign of a sum."""
    return tuple(part for term in breaking.terms(box) for part in at_relations(term))


def at_relations(term: b.Row) -> list[b.Row]:
    """A term cut before the relation signs within it."""
    groups: list[list[b.Box]] = [[]]
    for item in term.items:
        if isinstance(item, b.Operator) and item.kind == "relation":
            groups.append([])
        groups[-1].append(item)
    return [b.Row(tuple(group)) for group in groups if group]
