"""Markdown with `$` and `$$` for GitHub; figures as alt texts, since it can't hold drawings."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.document import breaking
from rbpsym.document.escaping import markdown_text
from rbpsym.document.model import (
    Callout,
    Display,
    Document,
    Emph,
    FigureBlock,
    ItemList,
    Math,
    Paragraph,
    Ref,
    Section,
    Strong,
    Table,
    Text,
)
from rbpsym.document.numbering import numbered
from rbpsym.document.writers.latex import COLUMN, formula_text
from rbpsym.document.writers.page import Page, Print, body, page_for
from rbpsym.notation.latex import to_latex


def write_markdown(document: Document) -> str:
    """The document as Markdown."""
    document = numbered(document)
    page = page_for(document, MARKDOWN, COLUMN)
    head = [f"# {page.inlines(document.title)}", page.inlines(document.subtitle)]
    head += [f"*{page.inlines(document.source)}*"] if document.source else []
    return "\n\n".join([*filter(None, head), body(document, page)]) + "\n"


def section(part: Section, page: Page) -> str:
    """A heading and what stands under it."""
    number = f"{part.number} " if part.number else ""
    heading = f"{'#' * (min(part.level, 3) + 1)} {number}{page.inlines(part.title)}"
    return f"{heading}\n\n{page.blocks(part.blocks)}"


def display(block: Display, page: Page) -> str:
    """A formula between double dollars, its reason below."""
    lines = breaking.display_lines(block, page.notation, page.column)
    tag = rf" \tag{{{block.number}}}" if block.number else ""
    content = formula_text(lines)
    content = rf"\boxed{{{content}}}" if block.boxed else content
    reason = f"\n\n*({page.inlines(block.reason)})*" if block.reason else ""
    return f"$$\n{content}{tag}\n$$" + reason


def table(block: Table, page: Page) -> str:
    """A pipe table with its caption above."""
    rules = " | ".join({"l": ":--", "p": ":--", "c": ":-:", "r": "--:"}[letter] for letter in block.columns)
    rows = [" | ".join(map(page.inlines, row)) for row in (block.header, *block.rows)]
    lines = "\n".join(f"| {row} |" for row in (rows[0], rules, *rows[1:]))
    return f"{captioned(block, 'table', page)}\n\n{lines}" if block.caption else lines


def captioned(block: Table | FigureBlock, kind: str, page: Page) -> str:
    """ "**Figure 2.** What is seen"."""
    return f"**{page.word(f'block.{kind}', number=block.number)}.** {page.inlines(block.caption)}"


def figure(block: FigureBlock, page: Page) -> str:
    """The caption and what would be seen."""
    return f"> {captioned(block, 'figure', page)}\n>\n> {markdown_text(block.alt)}"


def item_list(block: ItemList, page: Page) -> str:
    """A list."""
    marks = [f"{place}." if block.ordered else "-" for place in range(1, len(block.items) + 1)]
    pairs = zip(marks, block.items, strict=True)
    return "\n".join(f"{mark} {page.inlines(item)}" for mark, item in pairs)


def callout(block: Callout, page: Page) -> str:
    """A quoted block with its title."""
    title = page.inlines(block.title) or markdown_text(page.word(f"callout.{block.kind}"))
    inner = f"**{title}**\n\n{page.blocks(block.blocks)}"
    return "\n".join(f"> {line}".rstrip() for line in inner.splitlines())


MARKDOWN: Mapping[type, Print] = {
    Text: lambda inline, page: markdown_text(inline.text),
    Math: lambda inline, page: f"${to_latex(inline.node, page.notation)}$",
    Ref: lambda inline, page: inline.mark,
    Emph: lambda inline, page: f"*{page.inlines(inline.inlines)}*",
    Strong: lambda inline, page: f"**{page.inlines(inline.inlines)}**",
    Paragraph: lambda block, page: page.inlines(block.inlines),
    Display: display,
    Table: table,
    FigureBlock: figure,
    ItemList: item_list,
    Callout: callout,
    Section: section,
}
