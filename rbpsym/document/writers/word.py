"""Word: a .docx with native equations, native tables, links and pictures; needs python-docx."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.document import breaking
from rbpsym.document import model as d
from rbpsym.document.files import extra
from rbpsym.document.model import Display, numbered
from rbpsym.document.writers.page import Page, alone, body, plain_text, prints
from rbpsym.document.writers.word_xml import STAYS, Cell, TableLook, link, paragraph, safe, table_of, text_run
from rbpsym.typeset.cutting import width
from rbpsym.typeset.escaping import typographic
from rbpsym.typeset.layout import layout
from rbpsym.typeset.omml import NOTHING, formula, render, to_omml

# --- displayed formulas in Word: native equations in a row with their number, lines meeting at the relation signs


EM = 250  # twips an em of a formula, with room for Word's own spacing
PADDING = 160
NUMBER = 760
TEXT_WIDTH = 9070  # twips between the margins of the page


def display_table(block: Display, page: Page, name: str) -> str:
    """A formula on lines of its own: space, left sides, right sides, number. A result has a box."""
    lines = breaking.display_lines(block, page.notation, page.column)
    left, right = halves(lines)
    side = max((TEXT_WIDTH - left - right) // 2, 0)
    number = max(TEXT_WIDTH - side - left - right, NUMBER)
    left, right = fitted(left, right, TEXT_WIDTH - side - number)
    columns = (side, left, right, number) if left else (side, right, number)
    rows = [row(line, place, lines, block, name) for place, line in enumerate(lines)]
    rows[0][-1] = Cell(paragraph(aside(block, page), "Number"), rows[0][-1].look)
    return table_of(columns, rows)


def is_aside(block: Display, page: Page) -> bool:
    """Does the reason stand at the right, where there is no number?"""
    return bool(block.reason) and not block.number and breaking.text_width(block.reason or (), page.notation) <= ASIDE


ASIDE = 5.0  # em


def aside(block: Display, page: Page) -> str:
    """What stands at the right: the number, or a short reason."""
    if block.repeats:
        return page.show(block.repeats)
    if is_aside(block, page):
        return page.inlines(block.reason or ())
    return text_run(f"({block.number})") if block.number else ""


def halves(lines: tuple[breaking.DisplayLine, ...]) -> tuple[int, int]:
    """The widths of both sides of the place where lines meet; one line is one piece."""
    if len(lines) == 1:
        return 0, twips(lines[0].width)
    left = max(width(line.left) for line in lines)
    right = max(line.width - width(line.left) for line in lines)
    return (twips(left) if left else 0), twips(right)


def fitted(left: int, right: int, room: int) -> tuple[int, int]:
    """The widths, made smaller where they are too large for the room: Word breaks the lines then."""
    return (left, right) if left + right <= room else (min(left, room // 3), room - min(left, room // 3))


def twips(wide: float) -> int:
    """A width in em as twips."""
    return round(wide * EM) + PADDING


def row(line: breaking.DisplayLine, place: int, lines: tuple[breaking.DisplayLine, ...], block: Display, name: str) -> list[Cell]:
    """A line of the table; the number stands in the middle of all of them."""
    single = len(lines) == 1
    merged = "" if single else '<w:vMerge w:val="restart"/>' if place == 0 else "<w:vMerge/>"
    edges = frame(place, len(lines)) if block.boxed else {}
    cells = sides(line, edges, name if place == 0 else "", single or not halves(lines)[0])
    stays = STAYS if place < len(lines) - 1 else ""
    return [Cell(paragraph("", "Formula", more=stays)), *cells, Cell(paragraph("", "Number"), merged)]


def sides(line: breaking.DisplayLine, edges: dict[str, str], name: str, whole: bool) -> list[Cell]:
    """The cells of a line: all of it in one, or its left and right side."""
    if whole:
        content = render(line.left) + render(line.right)
        return [Cell(paragraph(math(content, "center"), "Formula", name), borders(edges, "left", "right"))]
    left = Cell(paragraph(math(render(line.left), "right"), "Formula", name), borders(edges, "left"))
    indent = ' w:left="440"' if line.indent else ""
    # the empty operand keeps the spaces of a sign with which a line begins
    right = paragraph(math(NOTHING + render(line.right), "left"), "Formula", indent=indent)
    return [left, Cell(right, borders(edges, "right"))]


def math(content: str, side: str) -> str:
    """A paragraph of mathematics."""
    if not content:
        return ""
    return f'<m:oMathPara><m:oMathParaPr><m:jc m:val="{side}"/></m:oMathParaPr>{formula(content)}</m:oMathPara>'


def frame(place: int, count: int) -> dict[str, str]:
    """The edges of the box round a result, of one of its lines."""
    line = '<w:{} w:val="single" w:sz="8" w:space="0" w:color="1D5FA8"/>'
    names = ["left", "right", *(["top"] if place == 0 else []), *(["bottom"] if place == count - 1 else [])]
    return {name: line.format(name) for name in names}


def borders(edges: dict[str, str], *sides: str) -> str:
    """The borders of one cell."""
    kept = [edges[name] for name in ("top", "left", "bottom", "right") if name in edges]
    kept = [edge for edge in kept if edge[3:].split(" ")[0] in (*sides, "top", "bottom")]
    return f"<w:tcBorders>{''.join(kept)}</w:tcBorders>" if kept else ""


# ---


COLUMN = 31.0  # em, between a margin for the number and one like it at the left


class WordPage(Page):
    """A page of Word: `pictures` are the drawn figures by number, `lists` the numberings of ordered lists."""

    pictures: Mapping[str, str] | None = None
    lists: Mapping[int, int] | None = None
    look: str = ""


def write_word(document: d.Document) -> bytes:
    """The document as a .docx file. Raises RbpsymError if python-docx is missing."""
    extra("docx")
    from rbpsym.document.writers import word_package as package

    document = numbered(document)
    title = plain_text(document.title, document.notation)
    file = package.new(title, document.language)
    pictures, lists = package.put_pictures(file, document), package.put_lists(file, document)
    page = WordPage(WORD, document.notation, document.language, COLUMN, pictures, lists)
    package.fill(file, head(document, page) + body(document, page))
    return package.saved(file)


def head(document: d.Document, page: Page) -> str:
    """Title, subtitle and source."""
    lines = (("Title", document.title), ("Subtitle", document.subtitle), ("Source", document.source))
    return "".join(paragraph(page.inlines(inlines), style) for style, inlines in lines if inlines)


def section(part: d.Section, page: Page) -> str:
    """A heading and what stands under it."""
    number = text_run(f"{part.number}\u2002") if part.number else ""
    heading = paragraph(number + page.inlines(part.title), f"Heading{min(max(part.level, 1), 3)}", part.label)
    return heading + blocks(part.blocks, page)


def blocks(parts: tuple[d.Block, ...], page: Page) -> str:
    """Blocks below each other; a paragraph stays with the formula that it leads to."""
    pairs = zip(parts, (*parts[1:], None), strict=False)
    return "".join(
        paragraph(page.inlines(block.inlines), "BodyText", more=STAYS if page.is_lead(block, after) else "")
        if isinstance(block, d.Paragraph)
        else page.show(block)
        for block, after in pairs
    )


def marked(inlines: d.Inlines, page: Page, look: str) -> str:
    """Inlines in a look that is added to the one around them."""
    changed = WordPage(page.table, page.notation, page.language, page.column, look=getattr(page, "look", "") + look)
    return changed.inlines(inlines)


def display(block: d.Display, page: Page) -> str:
    """A displayed formula with its reason below."""
    shown = display_table(block, page, block.label)
    below = () if is_aside(block, page) else block.reason
    return shown + paragraph(page.inlines(below), "Reason") if below else shown


def table(block: d.Table, page: Page) -> str:
    """A native table with three rules; its header is repeated on each page."""
    columns = widths(block, page)
    header = [
        Cell(cell(c, letter, page, "<w:b/>", STAYS), UNDER)
        for c, letter in zip(block.header, block.columns, strict=True)
    ]
    last = len(block.rows) - 1
    stays = [STAYS if last < LONG and place < last else "" for place in range(last + 1)]
    rows = [
        [Cell(cell(c, x, page, stays=stay)) for c, x in zip(row, block.columns, strict=True)]
        for row, stay in zip(block.rows, stays, strict=True)
    ]
    shown = table_of(columns, [header, *rows], TableLook("center", RULES, 90), header=True)
    return captioned(block, "table", page) + shown if block.caption else shown


UNDER = '<w:tcBorders><w:bottom w:val="single" w:sz="4" w:space="0" w:color="1F2430"/></w:tcBorders>'
RULES = "<w:tblBorders>{}{}</w:tblBorders>".format(
    *(f'<w:{side} w:val="single" w:sz="10" w:space="0" w:color="1F2430"/>' for side in ("top", "bottom"))
)
SIDES = {"l": "left", "p": "left", "c": "center", "r": "right"}


def widths(block: d.Table, page: Page) -> list[int]:
    """The columns in twips: as wide as they need be; where that is too much, words give way, then all."""
    places = range(len(block.header))
    wanted = [round(breaking.column_width(block, k, page.notation) * SMALL) + 320 for k in places]
    wordy = [k for k in places if block.columns[k] in "lp" and wraps(block, k)]
    spare, share = TEXT_WIDTH - sum(wanted), sum(wanted[k] for k in wordy)
    if spare < 0 < share:
        kept = max(1 + spare / share, 0.62)
        wanted = [round(w * kept) if k in wordy else w for k, w in enumerate(wanted)]
    factor = min(1.0, TEXT_WIDTH / sum(wanted))
    return [int(w * factor) for w in wanted]


SMALL = 235  # twips an em in a table
LONG = 14  # rows of a table that may be cut at the end of a page


def wraps(block: d.Table, place: int) -> bool:
    """Does a column hold words of which several make a cell?"""
    return any(isinstance(inline, d.Text) and " " in inline.text for row in block.rows for inline in row[place])


def cell(inlines: d.Inlines, letter: str, page: Page, look: str = "", stays: str = "") -> str:
    """The paragraph of a cell; a formula alone in it stands in display style."""
    side = f'{stays}<w:jc w:val="{SIDES[letter]}"/>'
    if node := alone(inlines):
        return paragraph(math(render(layout(node, page.notation)), SIDES[letter]), "Cell", more=side)
    return paragraph(marked(inlines, page, look) if look else page.inlines(inlines), "Cell", more=side)


def captioned(block: d.Table | d.FigureBlock, kind: str, page: Page) -> str:
    """ "Figure 2. What is seen"; a table's stays with the table."""
    name = text_run(page.word(f"block.{kind}", number=block.number) + ". ", "<w:b/>")
    stay = STAYS if kind == "table" else ""
    return paragraph(name + page.inlines(block.caption), "Caption", block.label, more=stay)


def figure(block: d.FigureBlock, page: WordPage) -> str:
    """A picture with its alt text, and its caption below."""
    drawn = (page.pictures or {}).get(block.number, "")
    drawn = drawn.replace("ALTERNATIVE", safe(block.alt)).replace("NAME", safe(f"figure {block.number}"))
    return paragraph(drawn, "Figure") + captioned(block, "figure", page)


def item_list(block: d.ItemList, page: WordPage) -> str:
    """A list; an ordered one has a numbering of its own."""
    number = (page.lists or {}).get(id(block)) if block.ordered else None
    own = f'<w:numPr><w:ilvl w:val="0"/><w:numId w:val="{number}"/></w:numPr>' if number else ""
    style = "ListNumber" if block.ordered else "ListBullet"
    return "".join(paragraph(page.inlines(item), style, more=own) for item in block.items)


def callout(block: d.Callout, page: Page) -> str:
    """A remark in a cell with a rule at its left."""
    title = page.inlines(block.title) if block.title else text_run(page.word(f"callout.{block.kind}"))
    inner = paragraph(title, "CalloutTitle") + blocks(block.blocks, page)
    inner += "" if inner.endswith("</w:p>") else paragraph("", "Gap")
    rule = f'<w:left w:val="single" w:sz="18" w:space="0" w:color="{TONES[block.kind]}"/>'
    look = TableLook(borders=f"<w:tblBorders>{rule}</w:tblBorders>", beside=180, indent=60)
    return table_of([TEXT_WIDTH - 60], [[Cell(inner)]], look)


TONES = {"result": "1D5FA8", "why": "6B7280", "note": "6B7280", "check": "2A7548"}


WORD = prints(
    display, table, figure, item_list, callout, section,
    reference=lambda inline, page: link(inline.label, inline.mark),
    text=lambda inline, page: text_run(typographic(inline.text), page.look),
    math=lambda inline, page: to_omml(inline.node, page.notation),
    emph=lambda inline, page: marked(inline.inlines, page, "<w:i/>"),
    strong=lambda inline, page: marked(inline.inlines, page, "<w:b/>"),
    paragraph=lambda block, page: paragraph(page.inlines(block.inlines), "BodyText"),
)  # fmt: skip
