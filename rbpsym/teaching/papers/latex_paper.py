r"""Worksheets in LaTeX: the exam class, tasks as \question with points; meant to be edited."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from rbpsym.document import breaking
from rbpsym.document.model import Document, FigureBlock, Section, Table, numbered
from rbpsym.document.writers.latex import LATEX, babel, blocks, captions, cell
from rbpsym.document.writers.latex import section as titled_section
from rbpsym.document.writers.page import Page, Print, page_for, shell
from rbpsym.expr.tree import Node
from rbpsym.pictures.figures.tikz import tikz_styles
from rbpsym.teaching.model import Worksheet
from rbpsym.teaching.papers.blocks import AnswerOptions, EmptySpace, Form, Lead, Marked, WritingRules, height, is_kept
from rbpsym.teaching.papers.layout import head
from rbpsym.typeset.escaping import latex_text
from rbpsym.typeset.latex import PREAMBLE, render

COLUMN = 36.0
INDENT = r"{} \qquad "


def write_paper(document: Document, worksheet: Worksheet, *, is_key: bool = False) -> str:
    """The LaTeX source of a paper, a key or a solution."""
    document = numbered(document)
    page = page_for(document, PAPER, COLUMN)
    language = worksheet.language
    more = {"styles": f"{PREAMBLE}\n{tikz_styles()}", "language": babel(language), "captions": captions(language)}
    return shell("worksheet.tex", body="\n\n".join(_sections(document, page)),
                 **head(worksheet, document, page, latex_text, is_key=is_key) | more)  # fmt: skip


def _sections(document: Document, page: Page) -> list[str]:
    r"""The sections; from the first task of one on it stands in `questions`."""
    found = []
    for part in document.sections:
        first = next((place for place, block in enumerate(part.blocks) if isinstance(block, Lead)), None)
        if first is None:
            found.append(section(part, page))
            continue
        before = replace(part, blocks=part.blocks[:first])
        found.append(section(before, page) if before.blocks or before.title else "")
        own = part.blocks[first:]
        room = f"\\needspace{{{height(own):.1f}cm}}\n" if is_kept(own) else ""
        found.append(f"{room}\\begin{{tasks}}\n{blocks(own, page)}\n\\end{{tasks}}")
    return [text for text in found if text]


def section(part: Section, page: Page) -> str:
    """A section; one without a title is its blocks."""
    return titled_section(part, page) if part.title else blocks(part.blocks, page)


def lead(block: Lead, page: Page) -> str:
    r"""\question with its points (which may be no whole number)."""
    return f"\\task{{{latex_text(block.number)}}}{{{latex_text(block.points)}}}{page.inlines(block.inlines)}"


def options(block: AnswerOptions, page: Page) -> str:
    """Lettered options; the right one is set by \\CorrectChoice, which a key prints in bold."""
    rows = [
        rf"  \{'CorrectChoice' if place == block.right else 'choice'} {cell(item, page)}"
        for place, item in enumerate(block.items)
    ]
    return "\\begin{choices}\n" + "\n".join(rows) + "\n\\end{choices}"


FORM = r"""\begin{center}\renewcommand{\arraystretch}{1.7}
\begin{tabular}{%s}\hline
%s \\ \hline
\end{tabular}\end{center}"""


def form(block: Form, page: Page) -> str:
    """A table to be filled in: high rows, lines between the columns."""
    head = " & ".join(rf"\textbf{{{page.inlines(cell)}}}" for cell in block.header)
    rows = [" & ".join(map(page.inlines, row)) for row in block.rows]
    return FORM % ("|l|" + "c|" * (len(block.header) - 1), " \\\\ \\hline\n".join([head, *rows]))


def marked(block: Marked, page: Page) -> str:
    """Formulas with their marks."""
    rows = [rf"  \item[\textbf{{{mark}}}] ${formula(node, page)}$" for mark, node in block.lines]
    return "\\begin{list}{}{\\leftmargin3em\\itemsep14pt}\n" + "\n".join(rows) + "\n\\end{list}"


def formula(node: Node, page: Page) -> str:
    """A formula in display style, broken where it is too wide."""
    lines = breaking.lines(node, page.notation, page.column - 4)
    if len(lines) == 1:
        return rf"\displaystyle {lines[0].shown(render)}"
    return "\\begin{aligned}[t]" + r" \\ ".join(line.shown(render, "&", INDENT) for line in lines) + "\\end{aligned}"


def rules(block: WritingRules, page: Page) -> str:
    """Rules to write on."""
    rows = [rf"{page.inlines(item)} \rule[-2pt]{{{block.width}cm}}{{0.4pt}}" for item in block.items]
    return "\\par\\smallskip " + r"\par\bigskip ".join(rows) + r"\par"


def here(writer: Print) -> Print:
    """A float that stays where it is: a worksheet is read in order."""
    return lambda block, page: writer(block, page).replace("[!ht]", "[H]", 1)


def unnumbered(block: Table, page: Page) -> str:
    """A table; without a caption it is no float."""
    text = LATEX[Table](block, page)
    if block.caption:
        return text.replace("[!ht]", "[H]", 1)
    return text.replace("\\begin{table}[!ht]\\centering", "\\begin{center}", 1).replace("\\end{table}", "\\end{center}")


PAPER: Mapping[type, Print] = {
    **LATEX,
    Section: section,
    FigureBlock: here(LATEX[FigureBlock]),
    Table: unnumbered,
    Lead: lead,
    AnswerOptions: options,
    Form: form,
    Marked: marked,
    WritingRules: rules,
    EmptySpace: lambda block, page: rf"\vspace{{{block.height}cm}}" if block.height else "",
}
