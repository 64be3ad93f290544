"""Displayed formulas in Word: native equations in a row with their number, lines meeting at the relation signs."""

from __future__ import annotations

from rbpsym.document import breaking
from rbpsym.document.model import Display
from rbpsym.document.writers.page import Page
from rbpsym.document.writers.word_xml import STAYS, Cell, paragraph, table_of, text_run
from rbpsym.notation.omml import NOTHING, formula, render

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
    return bool(block.reason) and not block.number and breaking.text_width(block.reason, page.notation) <= ASIDE


ASIDE = 5.0  # em


def aside(block: Display, page: Page) -> str:
    """What stands at the right: the number, or a short reason."""
    if block.repeats:
        return page.show(block.repeats)
    if is_aside(block, page):
        return page.inlines(block.reason)
    return text_run(f"({block.number})") if block.number else ""


def halves(lines: tuple[breaking.DisplayLine, ...]) -> tuple[int, int]:
    """The widths of both sides of the place where lines meet; one line is one piece."""
    if len(lines) == 1:
        return 0, twips(lines[0].width)
    left = max(breaking.width(line.left) for line in lines)
    right = max(line.width - breaking.width(line.left) for line in lines)
    return (twips(left) if left else 0), twips(right)


def fitted(left: int, right: int, room: int) -> tuple[int, int]:
    """The widths, made smaller where they are too large for the room: Word breaks the lines then."""
    return (left, right) if left + right <= room else (min(left, room // 3), room - min(left, room // 3))


def twips(width: float) -> int:
    """A width in em as twips."""
    return round(width * EM) + PADDING


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
