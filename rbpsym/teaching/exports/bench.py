"""What all exports work with: one worksheet, its page, and what could not be carried so far."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property

from rbpsym.document.model import Block, Inlines
from rbpsym.document.writers.page import Page
from rbpsym.document.writers.plain_text import plain_text
from rbpsym.teaching.exports.page import Paper, blocks_html
from rbpsym.teaching.exports.telling import feedback, word
from rbpsym.teaching.model import Item, OrderKey, Slip, Worksheet


@dataclass(frozen=True)
class Desk:
    """A worksheet on its way into a format; `missing` collects (item, what the format can't carry)."""

    worksheet: Worksheet
    paper: Paper
    missing: list[tuple[Item, str]] = field(default_factory=list)

    @cached_property
    def page(self) -> Page:
        """The page on which formulas and words are set."""
        return self.paper.page(self.worksheet.notation, self.worksheet.language)

    def lacks(self, item: Item, what: str) -> None:
        """Note what the format can't carry."""
        self.missing.append((item, what))

    def word(self, key: str) -> str:
        """A word in the language of the worksheet."""
        return word(key, self.worksheet.language)

    def html(self, blocks: Iterable[Block]) -> str:
        """Blocks as HTML."""
        shown = tuple(blocks)
        self.paper.number(shown)
        return blocks_html(shown, self.page)

    def inlines(self, inlines: Inlines) -> str:
        """Inlines as HTML."""
        return self.page.inlines(inlines)

    def formula(self, node: object) -> str:
        """A formula within a sentence."""
        return self.paper.formula(node, self.worksheet.notation, False)

    def plain(self, inlines: Inlines) -> str:
        """Inlines as plain text."""
        return plain_text(inlines, self.worksheet.notation, self.worksheet.language)

    def question(self, item: Item) -> str:
        """The statement of the problem and what is asked, so that each question stands alone."""
        return self.html((*self.worksheet.part_of(item.id).statement, *item.prompt))

    def solution(self, item: Item) -> str:
        """The way to the answer, "" if none is given."""
        return self.html(item.solution)

    def feedback(self, slip: Slip | None) -> str:
        """The feedback of a wrong answer as HTML."""
        return f"<p>{self.inlines(feedback(slip, self.worksheet))}</p>"


def nearest_pairs(key: OrderKey) -> list[tuple[int, int]]:
    """The conditions on the order that do not follow from others."""
    follows = {(i, k) for i, j in key.before for h, k in key.before if h == j}
    return sorted(key.before - follows)


def free_pairs(key: OrderKey, most: int = 2) -> list[tuple[int, int]]:
    """Some pairs that may stand either way, so that not every pair is bound."""
    closed = set(key.before)
    while True:
        more = {(i, k) for i, j in closed for h, k in closed if h == j} - closed
        if not more:
            break
        closed |= more
    count = len(key.pieces)
    found = [(i, j) for i in range(count) for j in range(i + 1, count) if not {(i, j), (j, i)} & closed]
    return found[:most]


def orders(key: OrderKey, most: int = 24) -> list[tuple[int, ...]] | None:
    """All right orders; None if they are more than `most`."""
    found: list[tuple[int, ...]] = []

    def grow(order: tuple[int, ...]) -> None:
        if len(found) > most:
            return
        if len(order) == len(key.pieces):
            found.append(order)
            return
        for place in range(len(key.pieces)):
            if place not in order and all(i in order for i, j in key.before if j == place):
                grow((*order, place))

    grow(())
    return found if len(found) <= most else None
