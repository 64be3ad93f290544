"""What worksheets have beyond notes: numbered tasks, options, rules to write on, lines with marks; about how high each is."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from rbpsym.document.model import Block, Display, FigureBlock, Inlines, Math, OwnBlock, Paragraph
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node

LETTERS = "abcdefghijklmnopqrstuvwxyz"


class Lead(OwnBlock):
    """The beginning of a task: its number, its question, and at the right what it earns."""

    number: str
    inlines: Inlines
    points: str


class AnswerOptions(OwnBlock):
    """Answers to choose from, marked a, b, c; `right` (from 0) is ticked in a key."""

    items: tuple[Inlines, ...]
    right: int | None = None


class Marked(OwnBlock):
    """Formulas below each other, each with its mark (a letter or a number) at the left."""

    lines: tuple[tuple[str, Node], ...]


class WritingRules(OwnBlock):
    """Rules to write answers on, each after some words or a formula; `width` in cm."""

    items: tuple[Inlines, ...]
    width: float = 6.0


class EmptySpace(OwnBlock):
    """Empty paper, in cm."""

    height: float


class Form(OwnBlock):
    """A table whose cells are filled in by hand; the cells of a key are filled in already."""

    header: tuple[Inlines, ...]
    rows: tuple[tuple[Inlines, ...], ...]


# --- about how high a task will be in print, so that it stays on one page where it fits one


ONE_PAGE = 17.0  # cm: what is surely not higher than a page, though it is estimated only
KEPT = 8.0  # cm: what is higher than that leaves too much of a page empty where it does not fit
LINE, ROW, LETTERS_A_LINE = 0.5, 1.2, 80


def height(blocks: Iterable[Block]) -> float:
    """The height in cm, rather too much than too little."""
    return sum(HEIGHTS[type(block)](block) if type(block) in HEIGHTS else ONE_PAGE for block in blocks)


def fits_a_page(blocks: Iterable[Block]) -> bool:
    """Whether a task has no more than a page."""
    return height(blocks) <= ONE_PAGE


def is_kept(blocks: Iterable[Block]) -> bool:
    """Whether a task is kept together."""
    return height(blocks) <= KEPT


def rows(node: t.Node) -> int:
    """How many rows a formula may take."""
    if isinstance(node, t.Relations):
        return sum(map(rows, node.rows))
    return max(1, len(node.items) - 1) if isinstance(node, t.Chain) else 1


def _text(inlines: Inlines) -> float:
    letters = sum(12 if isinstance(part, Math) else len(getattr(part, "text", "")) for part in inlines)
    return LINE * (1 + letters // LETTERS_A_LINE)


HEIGHTS: Mapping[type, Callable[[Any], float]] = {
    Paragraph: lambda block: 0.3 + _text(block.inlines),
    Lead: lambda block: 0.7 + _text(block.inlines),
    Display: lambda block: 0.4 + ROW * rows(block.node),
    FigureBlock: lambda block: 5.5,
    AnswerOptions: lambda block: 0.4 + ROW * len(block.items),
    Form: lambda block: 0.6 + ROW * (1 + len(block.rows)),
    Marked: lambda block: 0.4 + ROW * sum(rows(node) for _, node in block.lines),
    WritingRules: lambda block: 0.4 + len(block.items),
    EmptySpace: lambda block: block.height,
}
