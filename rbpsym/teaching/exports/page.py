"""Blocks of a worksheet as HTML for a learning platform, and the files in which they travel.

Two ways to set formulas: LaTeX between delimiters (Moodle, Canvas, PrairieLearn, GIFT) or MathML (QTI).
Figures become SVG files, drawn by Typst: letters are outlines, so that they look the same everywhere.
"""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Callable, Mapping

from markupsafe import escape

from rbpsym.document import model as d
from rbpsym.document.pictures import drawings
from rbpsym.document.writers.html import HTML
from rbpsym.document.writers.page import Page, Print, shell
from rbpsym.expr.glyphs import Notation
from rbpsym.expr.tree import Node
from rbpsym.pictures.figures.scene import Scene
from rbpsym.teaching.model import BLANK
from rbpsym.teaching.wording import word
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.mathml import to_mathml

SQUARE = r"\square "
SetFormula = Callable[[Node, Notation, bool], str]
PictureTag = Callable[[str, str], str]


def between(opening: str, closing: str, display: tuple[str, str] | None = None) -> SetFormula:
    """Formulas as LaTeX between delimiters, escaped for HTML."""

    def formula(node: Node, notation: Notation, alone: bool) -> str:
        first, last = display if alone and display else (opening, closing)
        return f"{first}{escape(to_latex(node, notation).replace(BLANK, SQUARE))}{last}"

    return formula


def mathml(node: Node, notation: Notation, alone: bool) -> str:
    """Formulas as MathML."""
    return to_mathml(node, notation)


TEX = between(r"\(", r"\)", (r"\[", r"\]"))


def image(path: str, alt: str) -> str:
    """A picture in HTML."""
    return f'<img src="{escape(path)}" alt="{escape(alt)}" />'


def svg(scenes: tuple[Scene, ...], notation: Notation) -> bytes:
    """Scenes side by side as an SVG file of their own."""
    return drawings([(scenes, notation)], "svg", 200.0)[0]


def table(formula: SetFormula, picture: Callable[[d.FigureBlock], str], marks: Mapping[str, str]) -> Mapping[type, Print]:
    """How blocks are printed where formulas are set and pictures shown so; `marks` are the numbers of figures by label."""
    return {
        **HTML,
        d.Text: lambda inline, page: str(escape(inline.text)),
        d.Math: lambda inline, page: formula(inline.node, page.notation, False),
        d.Ref: lambda inline, page: str(escape(marks.get(inline.label) or inline.mark or word("elsewhere", page.language))),
        d.Display: lambda block, page: _display(block, page, formula),
        d.Table: _table_html,
        d.Callout: lambda block, page: f"<div>{f'<p><strong>{page.inlines(block.title)}</strong></p>' if block.title else ''}"
        f"{page.blocks(block.blocks, '')}</div>",
        d.FigureBlock: lambda block, page: _figure(block, page, picture(block), marks.get(block.label)),
    }


def _display(block: d.Display, page: Page, formula: SetFormula) -> str:
    reason = f" &#160; {page.inlines(block.reason)}" if block.reason else ""
    return f"<p>{formula(block.node, page.notation, True)}{reason}</p>"


def _row(cells: tuple[d.Inlines, ...], tag: str, page: Page) -> str:
    return "<tr>" + "".join(f"<{tag}>{page.inlines(cell)}</{tag}>" for cell in cells) + "</tr>"


def _table_html(block: d.Table, page: Page) -> str:
    head = f"<thead>{_row(block.header, 'th', page)}</thead>" if any(block.header) else ""
    rows = "".join(_row(row, "td", page) for row in block.rows)
    return f"<table>{head}<tbody>{rows}</tbody></table>"


def _figure(block: d.FigureBlock, page: Page, shown: str, number: str | None) -> str:
    name = f"{escape(page.word('block.figure', number=number))}. " if number else ""
    return f"<p>{shown}</p>" + (f"<p><em>{name}{page.inlines(block.caption)}</em></p>" if block.caption else "")


# --- zip packages that are the same bytes on every machine


_LONG_AGO = (1980, 1, 1, 0, 0, 0)


def zipped(files: Mapping[str, bytes | str]) -> bytes:
    """A package of files by path, in the order of their paths. Raises ValueError for a path that leads out of it."""
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as package:
        for path, content in sorted(files.items()):
            if path.startswith("/") or ".." in path.split("/") or "\\" in path:
                raise ValueError(f"the path {path} leads out of the package")
            entry = zipfile.ZipInfo(path, _LONG_AGO)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            package.writestr(entry, content)
    return held.getvalue()


def slug(text: str) -> str:
    """A text as a part of a file name: letters, digits, dots and dashes."""
    return re.sub(r"[^A-Za-z0-9.]+", "-", text).strip("-.")[:80] or "worksheet"


def identifier(text: str) -> str:
    """A text as an identifier of XML."""
    return "q-" + re.sub(r"[^A-Za-z0-9]+", "-", text).strip("-")


# --- XML files from the shells of `templates/lms`: every text is escaped there, what is markup already says so


_BAD = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]")


def filled(shell_name: str, /, **values: object) -> str:
    """A shell with its places filled, without characters that no XML file can hold."""
    return _BAD.sub("\ufffd", shell(f"lms/{shell_name}", autoescape=True, **values))


def written(shell_name: str, /, **values: object) -> bytes:
    """The XML file."""
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + filled(shell_name, **values).encode("utf-8")
