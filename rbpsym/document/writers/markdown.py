"""Markdown with `$` and `$$` for GitHub; figures are SVG files beside it, or their alt texts alone."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rbpsym.document import breaking
from rbpsym.document import model as d
from rbpsym.document.model import numbered
from rbpsym.document.writers.latex import COLUMN, formula_text
from rbpsym.document.writers.page import Page, alone, body, prints
from rbpsym.expr.letters import script
from rbpsym.typeset import cutting
from rbpsym.typeset.escaping import markdown_text
from rbpsym.typeset.latex import to_latex

# --- laTeX that survives Markdown: on GitHub, formulas pass through the reader of Markdown before MathJax
# Taken for emphasis: an underscore after a bracket (github.com/github/markup, issue 1575). Taken for
# escapes: a backslash before punctuation. Taken for HTML: < and >. Unknown to MathJax: \mathpzc.


COMMANDS: Mapping[str, str] = {r"\,": r"\thinspace ", r"\{": r"\lbrace ", r"\}": r"\rbrace ", r"\;": r"\thickspace "}


def in_markdown(latex: str) -> str:
    """The same formula, written so that no part of it is taken for Markdown."""
    for command, word in COMMANDS.items():
        latex = latex.replace(command, word)
    latex = re.sub(r"\\mathpzc\{(\w)\}", lambda found: script(found[1]), latex)
    latex = re.sub(r"(?<=[^\w\s\\])_", "_ ", latex)
    latex = re.sub(r" *([<>]) *", lambda found: {"<": r" \lt ", ">": r" \gt "}[found[1]], latex)
    return latex.replace("](", "] (").replace("*", r"\ast ")


def in_cell(text: str) -> str:
    """Text of a cell on one line; the bars of formulas would part cells (those of words are escaped)."""
    return re.sub(r"(?<!\\)\||(?<=\\left)\||(?<=\\right)\|", r"\\vert ", text.replace("\n", " "))


def wrapped(mark: str, text: str) -> str:
    """Emphasised text: the marks must stand at letters, not at spaces."""
    inner = text.strip()
    if not inner:
        return text
    before, after = text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]
    return f"{before}{mark}{inner}{mark}{after}"


# ---


class MarkdownPage(Page):
    """A page of Markdown: `pictures` are the addresses of the drawn figures by number."""

    pictures: Mapping[str, str] | None = None


def write_markdown(document: d.Document, pictures: Mapping[str, str] | None = None) -> str:
    """The document as Markdown; a figure without an address in `pictures` is told by its alt text."""
    document = numbered(document)
    page = markdown_page(document, pictures)
    return "\n\n".join([*head(document, page), body(document, page)]) + "\n"


def markdown_files(document: d.Document, stem: str) -> dict[str, str | bytes]:
    """The Markdown file and an SVG file for each figure, by the names that they should have."""
    from rbpsym.document.pictures import pictures

    drawn = {f"{stem}-figure-{number}.svg": found for number, found in pictures(numbered(document), "svg").items()}
    places = {picture.number: name for name, picture in drawn.items()}
    return {f"{stem}.md": write_markdown(document, places)} | {name: found.content for name, found in drawn.items()}


def markdown_page(document: d.Document, pictures: Mapping[str, str] | None = None) -> MarkdownPage:
    """The page that a numbered document is printed on."""
    return MarkdownPage(MARKDOWN, document.notation, document.language, COLUMN, pictures)


def head(document: d.Document, page: Page) -> list[str]:
    """Title, subtitle and source."""
    found = [f"# {page.inlines(document.title)}", page.inlines(document.subtitle)]
    found += [f"*{page.inlines(document.source)}*"] if document.source else []
    return [line for line in found if line]


def section(part: d.Section, page: Page) -> str:
    """A heading and what stands under it."""
    number = f"{part.number} " if part.number else ""
    heading = f"{'#' * (min(part.level, 3) + 1)} {number}{page.inlines(part.title)}"
    return f"{heading}\n\n{page.blocks(part.blocks)}"


def display(block: d.Display, page: Page) -> str:
    """A formula between double dollars, its reason below."""
    lines = breaking.display_lines(block, page.notation, page.column)
    tag = rf" \tag{{{block.mark.strip('()')}}}" if block.mark else ""
    content = formula_text(lines)
    content = rf"\boxed{{{content}}}" if block.boxed else content
    reason = f"\n\n{wrapped('*', f'({page.inlines(block.reason)})')}" if block.reason else ""
    return f"$$\n{in_markdown(content)}{tag}\n$$" + reason


def table(block: d.Table, page: Page) -> str:
    """A pipe table with its caption above."""
    rules = " | ".join({"l": ":--", "p": ":--", "c": ":-:", "r": "--:"}[letter] for letter in block.columns)
    rows = [" | ".join(cell(inlines, page) for inlines in row) for row in (block.header, *block.rows)]
    lines = "\n".join(f"| {row} |" for row in (rows[0], rules, *rows[1:]))
    return f"{captioned(block, 'table', page)}\n\n{lines}" if block.caption else lines


def cell(inlines: d.Inlines, page: Page) -> str:
    """A cell; a formula alone in it stands in display style."""
    if (node := alone(inlines)) is None:
        return in_cell(page.inlines(inlines))
    style = r"\displaystyle " if cutting.node_height(node, page.notation) > 1.6 else ""
    return in_cell(f"${style}{in_markdown(to_latex(node, page.notation))}$")


def captioned(block: d.Table | d.FigureBlock, kind: str, page: Page) -> str:
    """ "**Figure 2.** What is seen"."""
    return f"**{page.word(f'block.{kind}', number=block.number)}.** {page.inlines(block.caption)}"


def figure(block: d.FigureBlock, page: Page) -> str:
    """The picture and its caption; without a picture, what would be seen."""
    address = (getattr(page, "pictures", None) or {}).get(block.number)
    if address is None:
        return f"> {captioned(block, 'figure', page)}\n>\n> {markdown_text(block.alt)}"
    return f"![{markdown_text(' '.join(block.alt.split()))}]({address})\n\n{captioned(block, 'figure', page)}"


def item_list(block: d.ItemList, page: Page) -> str:
    """A list."""
    marks = [f"{place}." if block.ordered else "-" for place in range(1, len(block.items) + 1)]
    pairs = zip(marks, block.items, strict=True)
    return "\n".join(f"{mark} {page.inlines(item)}" for mark, item in pairs)


def callout(block: d.Callout, page: Page) -> str:
    """A quoted block with its title."""
    title = page.inlines(block.title) or markdown_text(page.word(f"callout.{block.kind}"))
    inner = f"**{title}**\n\n{page.blocks(block.blocks)}"
    return "\n".join(f"> {line}".rstrip() for line in inner.splitlines())


MARKDOWN = prints(
    display, table, figure, item_list, callout, section,
    text=lambda inline, page: markdown_text(inline.text),
    math=lambda inline, page: f"${in_markdown(to_latex(inline.node, page.notation))}$",
    reference=lambda inline, page: inline.mark,
    emph=lambda inline, page: wrapped("*", page.inlines(inline.inlines)),
    strong=lambda inline, page: wrapped("**", page.inlines(inline.inlines)),
)  # fmt: skip
