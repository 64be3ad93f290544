"""HTML: one file with MathML and inline SVG, no script and no network, light and dark."""

from __future__ import annotations

import base64
import re
from functools import cache

from markupsafe import Markup, escape

from rbpsym.document import breaking
from rbpsym.document import model as d
from rbpsym.document.files import data_folder
from rbpsym.document.model import Display, numbered
from rbpsym.document.writers.page import Page, alone, body, page_for, plain_text, prints, shell
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen
from rbpsym.pictures.figures.svg import color_rules, to_svg
from rbpsym.typeset import boxes as b
from rbpsym.typeset.accents import accented
from rbpsym.typeset.cutting import terms, width
from rbpsym.typeset.escaping import typographic
from rbpsym.typeset.mathml import render, to_mathml

# --- formulas in HTML: MathML whose lines fold at + and − where the screen is narrow


OPEN = '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block">'


HELD = re.compile("<math(?:(?!</math>).)*</math>[.,;:!?)»”]+", re.DOTALL)  # a mark does not stand alone on the next line
TOGETHER = r'<span class="held">\g<0></span>'


def inline_math(node: Node, page: Page) -> str:
    """A formula within a sentence."""
    return accented(to_mathml(node, page.notation))


def display_math(block: Display, page: Page) -> str:
    """A displayed formula as a table of lines; the style sheet folds it on a phone."""
    lines = breaking.display_lines(block, page.notation, page.column)
    rows = "".join(map(table_row, lines))
    return accented(f'{OPEN}<mtable displaystyle="true" class="lines">{rows}</mtable></math>')


def table_row(line: breaking.DisplayLine) -> str:
    """One line: its left side, then its terms, each of which may move to the next line."""
    left = f'<mtd class="left">{render(line.left)}</mtd>'
    kind = "right indent" if line.indent else "right"
    pieces = "".join(map(folding_piece, folding_pieces(line.right)))
    return f'<mtr>{left}<mtd class="{kind}">{pieces}</mtd></mtr>'


def widest_piece(block: Display, page: Page) -> float:
    """The width in em of the widest part of a formula that stands on one line even on a phone."""
    lines = breaking.display_lines(block, page.notation, page.column)
    return max(width(piece) for line in lines for piece in (line.left, *folding_pieces(line.right)))


def folding_piece(piece: b.Row) -> str:
    """A piece; the sign at its start keeps the spaces that it has between two terms."""
    first, *others = piece.items
    if not isinstance(first, b.Operator) or first.kind == "prefix":
        return render(piece)
    sign = render(first).replace("<mo>", '<mo form="infix">')
    return f"<mrow>{sign}{render(b.Row(tuple(others)))}</mrow>"


def folding_pieces(box: b.Box) -> tuple[b.Row, ...]:
    """The pieces of a line: cut before each relation sign and each sign of a sum."""
    return tuple(part for term in terms(box) for part in at_relations(term))


def at_relations(term: b.Row) -> list[b.Row]:
    """A term cut before the relation signs within it."""
    groups: list[list[b.Box]] = [[]]
    for item in term.items:
        if isinstance(item, b.Operator) and item.kind == "relation":
            groups.append([])
        groups[-1].append(item)
    return [b.Row(tuple(group)) for group in groups if group]


# ---


COLUMN = 32.0


class Around(Frozen):
    """The site that a page stands in: its index page, the problems of the same topic, the ones before and after.

    Each is an address with a title; what is "" or empty is left out.
    """

    home: str = ""
    topic: str = ""
    others: tuple[tuple[str, str], ...] = ()
    before: tuple[str, str] | None = None
    after: tuple[str, str] | None = None


def write_html(document: d.Document, around: Around = Around()) -> str:
    """The document as one HTML file, with links to the site `around` it."""
    document = numbered(document)
    page = page_for(document, HTML, COLUMN)
    return shell(
        "notes.html",
        autoescape=True,
        title=Markup(page.inlines(document.title)),
        plain_title=plain_text(document.title, document.notation),
        subtitle=Markup(page.inlines(document.subtitle)),
        source=Markup(page.inlines(document.source)),
        language=document.language,
        around=around,
        home_name=page.word("library.home"),
        contents=page.word("block.contents"),
        sections=[(section_id(s), s.number, Markup(page.inlines(s.title))) for s in document.sections if s.level == 1],
        style=Markup(style()),
        font=Markup(font()),
        body=Markup(body(document, page)),
    )


@cache
def style() -> str:
    """The style sheet, with the colours of the figures."""
    sheet = (data_folder("templates") / "notes.css").read_text(encoding="utf-8")
    return f"{color_rules()}\n{sheet}"


@cache
def font() -> str:
    """The embedded math font in base64, "" if none is shipped."""
    path = data_folder("templates") / "math.woff2"
    return base64.b64encode(path.read_bytes()).decode() if path.is_file() else ""


def section_id(part: d.Section) -> str:
    """The target of links to a section."""
    return part.label or f"section-{part.number}"


def section(part: d.Section, page: Page) -> str:
    """A heading and what stands under it."""
    if not part.title:
        return page.blocks(part.blocks, "\n")
    rank = min(max(part.level, 1), 3) + 1
    number = f'<span class="section-number">{escape(part.number)}</span> ' if part.number else ""
    name = identity(section_id(part) if part.number else part.label)
    heading = f"<h{rank}{name}>{number}{page.inlines(part.title)}</h{rank}>"
    return f"{heading}\n{page.blocks(part.blocks, chr(10))}"


def identity(label: str) -> str:
    """The id attribute of a block."""
    return f' id="{escape(label)}"' if label else ""


def reference(inline: d.Ref, page: Page) -> str:
    """A link that shows the number."""
    return f'<a href="#{escape(inline.label)}">{escape(inline.mark)}</a>'


def display(block: d.Display, page: Page) -> str:
    """A displayed formula with its number at the right; boxes are CSS."""
    mark = page.show(block.repeats) if block.repeats else block.mark
    number = f'<span class="number">{mark}</span>' if mark else ""
    math = display_math(block, page)
    math = f'<div class="formula{" boxed" if block.boxed else ""}"{shrinking(block, page)}>{math}</div>'
    aside = reason(block, page)
    kind = "display with-aside" if 'class="reason beside"' in aside else "display"
    return f'<div class="{kind}"{identity(block.label)}>{math}{aside}{number}</div>'


def shrinking(block: d.Display, page: Page) -> str:
    """How wide the widest piece is that does not fold, if a phone has less room: it is set smaller there and scrolls."""
    widest = widest_piece(block, page)
    return f' tabindex="0" style="--wide:{widest:.1f}"' if widest > PHONE else ""


PHONE = 14.0  # em


def reason(block: d.Display, page: Page) -> str:
    """The reason of a step, beside or below."""
    if block.reason is None:
        return ""
    place = "beside" if breaking.reason_fits(block, page.notation, page.column) else "below"
    return f'<span class="reason {place}">{page.inlines(block.reason)}</span>'


def table(block: d.Table, page: Page) -> str:
    """A table that scrolls by itself where the screen is narrow."""
    caption = captioned(block, "table", page) if block.caption else ""
    head = row(block.header, block.columns, "th", page)
    rows = "\n".join(row(cells, block.columns, "td", page) for cells in block.rows)
    return (
        f'<div class="table" role="region" tabindex="0"{identity(block.label)}'
        f' aria-label="{escape(page.word("block.table", number=block.number).strip())}"><table>'
        f"{f'<caption>{caption}</caption>' if caption else ''}"
        f"<thead>{head}</thead>\n<tbody>{rows}</tbody></table></div>"
    )


def row(cells: tuple[d.Inlines, ...], columns: str, tag: str, page: Page) -> str:
    """One row of a table."""
    kinds = [f'{tag} scope="col"' if tag == "th" else tag] * len(cells)
    inner = "".join(
        f'<{kind} class="{letter}">{content(cell, page)}</{tag}>'
        for kind, letter, cell in zip(kinds, columns, cells, strict=True)
    )
    return f"<tr>{inner}</tr>"


def content(cell: d.Inlines, page: Page) -> str:
    """A cell; a formula alone in it stands in display style."""
    found = page.inlines(cell)
    return found.replace("<math ", '<math displaystyle="true" ', 1) if alone(cell) else found


def captioned(block: d.Table | d.FigureBlock, kind: str, page: Page) -> str:
    """ "Figure 2. What is seen"."""
    name = escape(page.word(f"block.{kind}", number=block.number))
    return f'<span class="caption-name">{name}.</span> {page.inlines(block.caption)}'


def figure(block: d.FigureBlock, page: Page) -> str:
    """Scenes side by side with their caption; one image for a screen reader."""
    scenes = "\n".join(to_svg(scene, page.notation) for scene in block.scenes)
    caption = captioned(block, "figure", page)
    return (
        f'<figure{identity(block.label)}><div class="scenes" role="img"'
        f' aria-label="{escape(block.alt)}">{scenes}</div>'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def item_list(block: d.ItemList, page: Page) -> str:
    """A list."""
    tag = "ol" if block.ordered else "ul"
    items = "\n".join(f"<li>{page.inlines(item)}</li>" for item in block.items)
    return f"<{tag}>{items}</{tag}>"


def callout(block: d.Callout, page: Page) -> str:
    """A remark with a rule at its left."""
    title = page.inlines(block.title) or escape(page.word(f"callout.{block.kind}"))
    inner = page.blocks(block.blocks, "\n")
    return f'<div class="callout {escape(block.kind)}"><p class="callout-title">{title}</p>\n{inner}</div>'


HTML = prints(
    reference, display, table, figure, item_list, callout, section,
    text=lambda inline, page: str(escape(typographic(inline.text))),
    math=lambda inline, page: inline_math(inline.node, page),
    emph=lambda inline, page: f"<em>{page.inlines(inline.inlines)}</em>",
    strong=lambda inline, page: f"<strong>{page.inlines(inline.inlines)}</strong>",
    paragraph=lambda block, page: f"<p>{HELD.sub(TOGETHER, page.inlines(block.inlines))}</p>",
)  # fmt: skip
