"""WordprocessingML: runs, paragraphs, cells and tables as strings."""

from __future__ import annotations

import re
import zlib
from collections.abc import Sequence
from html import escape

from rbpsym.frozen import Frozen

W = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
UNPRINTABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")


def safe(text: str) -> str:
    """Text with XML's own characters escaped and those that XML forbids left out."""
    return escape(UNPRINTABLE.sub("", text))


def text_run(text: str, look: str = "") -> str:
    """Words; `look` is what is in their properties ("<w:b/>")."""
    properties = f"<w:rPr>{look}</w:rPr>" if look else ""
    return f'<w:r>{properties}<w:t xml:space="preserve">{safe(text)}</w:t></w:r>' if text else ""


def paragraph(content: str, style: str = "", label: str = "", *, more: str = "", indent: str = "") -> str:
    """A paragraph in a style, with a bookmark if it has a label."""
    properties = f'<w:pStyle w:val="{style}"/>' if style else ""
    properties += more + (f"<w:ind{indent}/>" if indent else "")
    properties = f"<w:pPr>{properties}</w:pPr>" if properties else ""
    return f"<w:p>{properties}{bookmarked(content, label)}</w:p>"


STAYS = "<w:keepNext/>"  # on the page of what follows


def bookmarked(content: str, label: str) -> str:
    """The content as the target of links."""
    if not label:
        return content
    number = zlib.crc32(label.encode("utf-8", "replace")) & 0x7FFFFFFF
    return f'<w:bookmarkStart w:id="{number}" w:name="{target(label)}"/>{content}<w:bookmarkEnd w:id="{number}"/>'


def target(label: str) -> str:
    """The name of a bookmark: at most 40 letters, digits and underscores."""
    plain = re.sub(r"\W", "_", label, flags=re.ASCII)[:28]
    return f"b_{plain}_{zlib.crc32(label.encode('utf-8', 'replace')):08x}"


def link(label: str, mark: str) -> str:
    """A link to a bookmark."""
    return f'<w:hyperlink w:anchor="{target(label)}" w:history="1">{text_run(mark)}</w:hyperlink>'


class Cell(Frozen):
    """A cell: paragraphs, and what is in its properties besides the width."""

    content: str
    look: str = ""


class TableLook(Frozen):
    """Properties of a table: its place on the line, its borders, the space beside the cells' words in twips."""

    side: str = "left"
    borders: str = ""
    beside: int = 40
    indent: int = 0


def table_of(
    columns: Sequence[int], rows: Sequence[Sequence[Cell]], look: TableLook = TableLook(), *, header: bool = False
) -> str:
    """A table with columns of given widths in twips, and the gap that parts it from a table below it.

    The first of its rows is a `header` that is repeated on each page.
    """
    grid = "".join(f'<w:gridCol w:w="{width}"/>' for width in columns)
    lines = "".join(row(cells, columns, header=header and place == 0) for place, cells in enumerate(rows))
    return f"<w:tbl>{settings(sum(columns), look)}<w:tblGrid>{grid}</w:tblGrid>{lines}</w:tbl>{GAP}"


def settings(width: int, look: TableLook) -> str:
    """The properties of a table, in the order of the standard."""
    beside = "".join(f'<w:{side} w:w="{look.beside}" w:type="dxa"/>' for side in ("left", "right"))
    return (
        f'<w:tblPr><w:tblW w:w="{width}" w:type="dxa"/><w:jc w:val="{look.side}"/>'
        f'<w:tblInd w:w="{look.indent}" w:type="dxa"/>{look.borders}'
        f'<w:tblLayout w:type="fixed"/><w:tblCellMar>{beside}</w:tblCellMar></w:tblPr>'
    )


def row(cells: Sequence[Cell], columns: Sequence[int], *, header: bool = False) -> str:
    """A row that stays on one page."""
    repeated = "<w:tblHeader/>" if header else ""
    inner = "".join(
        f'<w:tc><w:tcPr><w:tcW w:w="{width}" w:type="dxa"/>{cell.look}<w:vAlign w:val="center"/></w:tcPr>'
        f"{cell.content}</w:tc>"
        for cell, width in zip(cells, columns, strict=True)
    )
    return f"<w:tr><w:trPr><w:cantSplit/>{repeated}</w:trPr>{inner}</w:tr>"


GAP = '<w:p><w:pPr><w:pStyle w:val="Gap"/></w:pPr></w:p>'
