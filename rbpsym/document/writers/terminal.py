"""A document in the terminal: prose wrapped, formulas in Unicode, tables drawn, one function a block."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Collection, Iterator, Mapping
from textwrap import wrap
from typing import Any

import click

from rbpsym.decide.verdict import PROVED, REFUTED, UNDECIDED, Kind, Verdict, all_of
from rbpsym.document import model as d
from rbpsym.document.model import numbered
from rbpsym.document.writers.page import plain_text
from rbpsym.expr.glyphs import Notation
from rbpsym.expr.tree import Chain, Relations
from rbpsym.frozen import Frozen, field
from rbpsym.typeset.escaping import columns, padded
from rbpsym.typeset.text import to_text

MARKS: Mapping[Kind, tuple[str, str]] = {PROVED: ("✓", "green"), REFUTED: ("✗", "red"), UNDECIDED: ("?", "yellow")}
UNCERTIFIED = ("○", "green")  # proved, and Rocq was asked and has not certified it
SIDES: Mapping[str, Any] = {"l": "left", "p": "left", "c": "center", "r": "right"}
WIDEST = 100


class Screen(Frozen):
    """Where a document is shown: how names are drawn, the width, and what became of each check; `doubtful`: what a prover
    that was asked did not certify."""

    notation: Notation
    language: str = "en"
    verdicts: Mapping[str, Verdict] = field(default_factory=dict)
    width: int = WIDEST
    doubtful: Collection[str] = ()

    def text(self, inlines: d.Inlines) -> str:
        """Inlines as one line of text."""
        return " ".join(plain_text(inlines, self.notation, self.language).split())


def terminal_lines(document: d.Document, verdicts: Mapping[str, Verdict], doubtful: Collection[str] = ()) -> Iterator[str]:
    """The lines of a document; `verdicts` by the label of a formula put a mark before it, another if it is `doubtful`."""
    document = numbered(document)
    width = min(shutil.get_terminal_size((WIDEST, 24)).columns, WIDEST)
    screen = Screen(document.notation, document.language, verdicts, max(width, 40), doubtful)
    yield click.style(screen.text(document.title), bold=True)
    for section in document.sections:
        yield from ("", click.style(screen.text(section.title), bold=True, underline=True))
        for block in section.blocks:
            yield from BLOCKS[type(block)](block, screen)


def plain_lines(document: d.Document) -> Iterator[str]:
    """The same without marks and colours."""
    yield from map(click.unstyle, terminal_lines(document, {}))


def _paragraph(block: d.Paragraph, screen: Screen) -> Iterator[str]:
    text = screen.text(block.inlines)
    yield from (f"  {row}" for row in wrap(text, screen.width - 2, break_long_words=False, break_on_hyphens=False))


def _display(block: d.Display, screen: Screen) -> Iterator[str]:
    found = [screen.verdicts[label] for label in (block.label, *block.also) if label in screen.verdicts]
    verdict = all_of(found) if found else None
    mark, color = MARKS[verdict.kind] if verdict else (" ", "white")
    if verdict and verdict.is_proved and {block.label, *block.also} & {*screen.doubtful}:
        mark, color = UNCERTIFIED
    rows = _rows(block, screen)
    last = f"{padded(rows[-1], screen.width - 7 - len(block.mark))} {block.mark}".rstrip()
    for row in [*rows[:-1], last]:
        yield f"    {click.style(mark, fg=color)} {click.style(row, bold=block.boxed)}"
        mark = " "
    if block.reason:
        yield f"      ({screen.text(block.reason)})"
    if verdict and not verdict.is_proved:
        yield from (f"      {row}" for row in wrap(str(verdict), screen.width - 6))


def _rows(block: d.Display, screen: Screen) -> list[str]:
    """The formula in one line, or a chain that is too long in one line a link."""
    line = to_text(block.node, screen.notation)
    if isinstance(block.node, Chain) and columns(line) > screen.width - 12:
        line = to_text(Relations((block.node,)), screen.notation)
    return line.splitlines()


def _table(block: d.Table, screen: Screen) -> Iterator[str]:
    from rich.box import SIMPLE_HEAD
    from rich.console import Console
    from rich.table import Table as Drawn
    from rich.text import Text

    drawn = Drawn(box=SIMPLE_HEAD, pad_edge=False)
    for head, side in zip(block.header, block.columns, strict=True):
        drawn.add_column(Text(screen.text(head)), justify=SIDES[side], overflow="fold")
    for row in block.rows:
        drawn.add_row(*(Text(screen.text(cell)) for cell in row))
    console = Console(width=screen.width - 4, color_system=None, highlight=False)
    with console.capture() as capture:
        console.print(drawn)
    yield from (f"    {line}".rstrip() for line in capture.get().strip("\n").splitlines())
    if block.caption:
        yield from _told("table", block.number, screen.text(block.caption), screen)


def _told(kind: str, number: str, text: str, screen: Screen) -> Iterator[str]:
    """Number and caption of a table or figure."""
    from rbpsym.document.phrases import plain

    head = plain(f"block.{kind}", screen.language, number=number)
    yield from (f"    {row}" for row in wrap(f"{head}. {text}", screen.width - 4))


def _items(block: d.ItemList, screen: Screen) -> Iterator[str]:
    for place, item in enumerate(block.items, 1):
        first = f"  {place}. " if block.ordered else "  · "
        yield from wrap(screen.text(item), screen.width, initial_indent=first, subsequent_indent=" " * len(first))


def _callout(block: d.Callout, screen: Screen) -> Iterator[str]:
    yield f"  {click.style(screen.text(block.title), bold=True)}"
    for inner in block.blocks:
        yield from BLOCKS[type(inner)](inner, screen)


BLOCKS: Mapping[type, Callable[[Any, Screen], Iterator[str]]] = {
    d.Paragraph: _paragraph, d.Display: _display, d.Table: _table, d.ItemList: _items, d.Callout: _callout,
    d.FigureBlock: lambda block, screen: _told("figure", block.number, block.alt, screen),
}  # fmt: skip
