"""A document as plain text: one line a paragraph, formulas in Unicode, tables with bars between cells."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.document.model import Callout, Display, Document, FigureBlock, ItemList, Paragraph, Section, Table
from rbpsym.document.writers.page import Page, Print, body
from rbpsym.document.writers.plain_text import PLAIN
from rbpsym.notation.text import to_text


def plain_document(document: Document) -> str:
    """A numbered document as text."""
    page = Page(BLOCKS, document.notation, document.language)
    return "\n\n".join(filter(None, [page.inlines(document.title), body(document, page)]))


def display(block: Display, page: Page) -> str:
    """A formula, indented, with its number."""
    lines = to_text(block.node, page.notation).splitlines()
    number = f"   ({block.number})" if block.number else ""
    return "\n".join(f"    {line}" for line in lines) + number


def table(block: Table, page: Page) -> str:
    """Header and rows."""
    return "\n".join(" | ".join(map(page.inlines, row)) for row in (block.header, *block.rows))


def section(part: Section, page: Page) -> str:
    """A heading and what stands under it."""
    title = f"{part.number} {page.inlines(part.title)}".strip()
    return "\n\n".join(filter(None, [title, page.blocks(part.blocks)]))


BLOCKS: Mapping[type, Print] = {
    **PLAIN,
    Paragraph: lambda block, page: page.inlines(block.inlines),
    Display: display,
    Table: table,
    FigureBlock: lambda block, page: f"[{block.alt}]",
    ItemList: lambda block, page: "\n".join(f"- {page.inlines(item)}" for item in block.items),
    Callout: lambda block, page: page.blocks(block.blocks),
    Section: section,
}
