"""Worksheets in Typst: what the notes' writer prints, and the blocks that only worksheets have."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.document import breaking
from rbpsym.document.model import Document, Inlines, Section, numbered
from rbpsym.document.writers.page import Page, Print, body, page_for, shell
from rbpsym.document.writers.typst import TYPST, blocks, cell_content, spoken
from rbpsym.document.writers.typst import section as titled_section
from rbpsym.expr.tree import Node
from rbpsym.teaching.model import Worksheet
from rbpsym.teaching.papers.blocks import AnswerOptions, EmptySpace, Form, Lead, Marked, WritingRules, fits_a_page, is_kept
from rbpsym.teaching.papers.layout import head
from rbpsym.typeset.escaping import typst_string, typst_text
from rbpsym.typeset.typst import render

COLUMN = 38.0
LEAST = 0.6  # of the room for an answer, where the page has no more to share out


def write_paper(document: Document, worksheet: Worksheet, *, is_key: bool = False) -> str:
    """The Typst source of a paper, a key or a solution."""
    document = numbered(document)
    page = page_for(document, {**PAPER, Section: kept} if is_key else PAPER, COLUMN)
    told = head(worksheet, document, page, typst_text, typst_string, is_key=is_key)
    return shell("worksheet.typ", body=body(document, page), **told)


def kept(part: Section, page: Page) -> str:
    """A section; one without a title is its blocks, kept on one page if that leaves not too much of another empty."""
    text = titled_section(part, page) if part.title else blocks(part.blocks, page)
    whole = "false" if is_kept(part.blocks) else "true"
    return f"#block(breakable: {whole}, width: 100%, above: 1em)[\n{text}\n]\n" if _is_task(part) else text


def section(part: Section, page: Page) -> str:
    """The same with its share of what the page leaves, for the answer."""
    room = 1 + sum(block.height for block in part.blocks if isinstance(block, EmptySpace))
    return kept(part, page) + (f"#v(1em)\n#v({room}fr)" if _is_task(part) else "")


def _is_task(part: Section) -> bool:
    return not part.title and bool(part.blocks) and isinstance(part.blocks[0], Lead) and fits_a_page(part.blocks)


def lead(block: Lead, page: Page) -> str:
    """The number and question of a task, its points at the right."""
    return f"#task([{typst_text(block.number)}], [{page.inlines(block.inlines)}], [{typst_text(block.points)}])"


def options(block: AnswerOptions, page: Page) -> str:
    """Lettered options with a box to tick."""
    items = ", ".join(f"[{cell_content(item, page)}]" for item in block.items)
    right = "none" if block.right is None else str(block.right)
    return f"#options({right}, {items})"


def form(block: Form, page: Page) -> str:
    """A table to be filled in."""
    rows = ", ".join(cells(row, page) for row in (block.header, *block.rows))
    return f"#form-table({len(block.header)}, {rows})"


def cells(row: tuple[Inlines, ...], page: Page) -> str:
    """The cells of a row."""
    return f"({', '.join(f'[{page.inlines(cell)}]' for cell in row)},)"


def marked(block: Marked, page: Page) -> str:
    """Formulas with their marks."""
    items = ", ".join(f"([{mark}], {formula(node, page)})" for mark, node in block.lines)
    return f"#marked({items},)"


def formula(node: Node, page: Page) -> str:
    """A formula that stands in a grid, broken where it is too wide; its first row again, to be measured only."""
    lines = breaking.lines(node, page.notation, page.column - 4)
    rows = " \\ ".join(line.shown(render, "& " if len(lines) > 1 else "", "wide ") for line in lines)
    return f"math.equation(alt: {spoken(node, page)}, math.display(${rows}$)), $ {lines[0].shown(render)} $"


def rules(block: WritingRules, page: Page) -> str:
    """Rules to write on."""
    items = ", ".join(f"[{page.inlines(item)}]" for item in block.items)
    return f"#rules({block.width}cm, {items})"


PAPER: Mapping[type, Print] = {
    **TYPST,
    Section: section,
    Lead: lead,
    AnswerOptions: options,
    Form: form,
    Marked: marked,
    WritingRules: rules,
    EmptySpace: lambda block, page: f"#v({LEAST * block.height:g}cm)" if block.height else "",
}
