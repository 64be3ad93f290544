"""Typst: the source of the PDF that needs nothing but pip; formulas and drawings carry alt texts."""

from __future__ import annotations

from rbpsym.document import breaking
from rbpsym.document import model as d
from rbpsym.document.model import numbered
from rbpsym.document.writers.page import Page, alone, body, page_for, plain_text, prints, shell
from rbpsym.expr.tree import Node
from rbpsym.pictures.figures.typst import to_typst_drawing
from rbpsym.typeset.escaping import typst_string, typst_text
from rbpsym.typeset.speech import to_speech
from rbpsym.typeset.typst import render, to_typst

COLUMN = 43.0


def write_typst(document: d.Document) -> str:
    """The document as a Typst source file."""
    document = numbered(document)
    page = page_for(document, TYPST, COLUMN)
    return shell(
        "notes.typ",
        title=page.inlines(document.title),
        plain_title=typst_string(plain_text(document.title, document.notation)),
        subtitle=page.inlines(document.subtitle),
        source=page.inlines(document.source),
        language=document.language,
        is_book=document.is_book,
        contents=typst_string(page.word("block.contents")),
        body=body(document, page),
    )


def section(part: d.Section, page: Page) -> str:
    """A heading with its number and what stands under it."""
    number = typst_string(part.number)
    heading = f"#section({part.level}, {number})[{page.inlines(part.title)}]{anchor(part.label)}"
    return f"{heading}\n\n{blocks(part.blocks, page)}".rstrip()


def blocks(parts: tuple[d.Block, ...], page: Page) -> str:
    """Blocks below each other; a paragraph stays with the formula that it leads to."""
    found, led = [], ""
    for block, after in zip(parts, (*parts[1:], None), strict=False):
        shown = display(block, page, led) if led and isinstance(block, d.Display) else page.show(block)
        led = shown if breaking.is_run_in(block, after, page.notation, page.column) else ""
        if not led:
            found.append(f"#lead[{shown}]" if page.is_lead(block, after) else shown)
    return "\n\n".join(found)


def anchor(label: str) -> str:
    """The target of links; `label(...)` takes any characters."""
    return f"#label({typst_string(label)})" if label else ""


def reference(inline: d.Ref, page: Page) -> str:
    """A link that shows the number, or the page."""
    command = "page-of" if inline.page else "link"
    shown = "" if inline.page else f"[{typst_text(inline.mark)}]"
    return f"#{command}(label({typst_string(inline.label)})){shown};"


def math(inline: d.Math, page: Page) -> str:
    """A formula in a sentence, with its spoken form."""
    return f"#m({spoken(inline.node, page)}, ${to_typst(inline.node, page.notation)}$);"


def spoken(node: Node, page: Page) -> str:
    """How a screen reader says the formula, as a Typst string."""
    return typst_string(to_speech(node, page.notation))


def display(block: d.Display, page: Page, lead: str = "") -> str:
    """A displayed formula, behind its sentence if that stands in the same line; the shell sets number, box and reason."""
    lines = breaking.display_lines(block, page.notation, page.column)
    content = " \\\n  ".join(line.shown(render, "&" if len(lines) > 1 else "", 'wide ""') for line in lines)
    settings = [f"alt: {spoken(block.node, page)}"]
    settings += number(block, page)
    settings += ["boxed: true"] if block.boxed else []
    settings += [f"lead: [{lead}]"] if lead else []
    settings += ["shrunk: true"] if breaking.widest(lines) > page.column else []
    settings += reason(block, page)
    return f"#display({', '.join(settings)}, $\n  {content}\n$){anchor(block.label)}"


def number(block: d.Display, page: Page) -> list[str]:
    """The argument of a display that has a number, its own or that of another."""
    if block.repeats:
        return [f"number: [{page.show(block.repeats)}]"]
    return [f"number: {typst_string(block.mark)}"] if block.mark else []


def reason(block: d.Display, page: Page) -> list[str]:
    """The arguments of a display that has a reason."""
    if block.reason is None:
        return []
    beside = "true" if breaking.reason_fits(block, page.notation, page.column) else "false"
    return [f"reason: [{page.inlines(block.reason)}]", f"beside: {beside}"]


def table(block: d.Table, page: Page) -> str:
    """A table with three rules."""
    columns = ", ".join(column(block, place, page) for place in range(len(block.header)))
    align = ", ".join(ALIGN[letter] for letter in block.columns)
    header = cells(block.header, page)
    rows = ",\n  ".join(cells(row, page) for row in block.rows)
    caption = f"[{page.inlines(block.caption)}]" if block.caption else "none"
    name = typst_string(page.word("block.table", number=block.number)) if block.number else "none"
    return (
        f"#notes-table(({columns},), ({align},), {name}, {caption},\n  ({header},),\n  {rows},\n){anchor(block.label)}"
    )


def column(block: d.Table, place: int, page: Page) -> str:
    """The width of a column: words share the room that is left, or wrap in a narrow one."""
    if block.columns[place] == "p" and (room := breaking.wrapped_width(block, place, page.notation, page.column)):
        return f"{room}em"
    wordy = block.columns[place] == "l" and breaking.is_wordy(block, place)
    return "1fr" if wordy else "auto"


ALIGN = {"p": "left", "l": "left", "c": "center", "r": "right"}


def cells(row: tuple[d.Inlines, ...], page: Page) -> str:
    """The cells of a row as content blocks."""
    return ", ".join(f"[{cell_content(cell, page)}]" for cell in row)


def cell_content(cell: d.Inlines, page: Page) -> str:
    """A cell; a formula alone in it stands in display style and is never broken."""
    node = alone(cell)
    return f"#cell({spoken(node, page)}, ${to_typst(node, page.notation)}$);" if node else page.inlines(cell)


def figure(block: d.FigureBlock, page: Page) -> str:
    """Scenes side by side with their caption and alt text."""
    scenes = ",\n".join(to_typst_drawing(scene, page.notation) for scene in block.scenes)
    name = typst_string(page.word("block.figure", number=block.number))
    return (
        f"#notes-figure({name}, [{page.inlines(block.caption)}], {typst_string(block.alt)},\n"
        f"{scenes},\n){anchor(block.label)}"
    )


def item_list(block: d.ItemList, page: Page) -> str:
    """A list."""
    items = ",\n  ".join(f"[{page.inlines(item)}]" for item in block.items)
    return f"#{'enum' if block.ordered else 'list'}(\n  {items},\n)"


def callout(block: d.Callout, page: Page) -> str:
    """A remark with a rule at its left."""
    title = page.inlines(block.title) or typst_text(page.word(f"callout.{block.kind}"))
    return f"#callout({typst_string(block.kind)}, [{title}])[\n{blocks(block.blocks, page)}\n]"


TYPST = prints(
    math, reference, display, table, figure, item_list, callout, section,
    text=lambda inline, page: typst_text(inline.text),
    emph=lambda inline, page: f"#emph[{page.inlines(inline.inlines)}];",
    strong=lambda inline, page: f"#strong[{page.inlines(inline.inlines)}];",
)  # fmt: skip
