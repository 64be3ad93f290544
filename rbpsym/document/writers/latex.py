"""LaTeX: article, amsmath and tikz; compiles with plain pdflatex and is meant to be edited."""

from __future__ import annotations

from typing import Any

from rbpsym.document import breaking
from rbpsym.document import model as d
from rbpsym.document.model import numbered
from rbpsym.document.phrases import plain
from rbpsym.document.writers.page import Page, alone, body, page_for, plain_text, prints, shell
from rbpsym.document.writers.rare_letters import with_rare_letters
from rbpsym.pictures.figures.tikz import tikz_styles, to_tikz
from rbpsym.typeset import cutting
from rbpsym.typeset.escaping import latex_text
from rbpsym.typeset.latex import PREAMBLE, render, to_latex

COLUMN = 37.0


def write_latex(document: d.Document) -> str:
    """The document as a LaTeX source file."""
    document = numbered(document)
    page = page_for(document, LATEX, COLUMN)
    return source_of("article.tex", document, page, body(document, page))


def source_of(name: str, document: d.Document, page: Page, inner: str, **more: Any) -> str:
    """The source of a numbered document in a shell of LaTeX."""
    source = shell(
        name,
        title=page.inlines(document.title),
        plain_title=latex_text(plain_text(document.title, document.notation)),
        subtitle=page.inlines(document.subtitle),
        source=page.inlines(document.source),
        is_book=document.is_book,
        language=babel(document.language),
        captions=captions(document.language),
        styles=f"{PREAMBLE}\n{tikz_styles()}",
        body=inner,
        **more,
    )
    return with_rare_letters(source)


def babel(language: str) -> str:
    """The options of the package babel for a language."""
    return plain("latex.babel", language)


def captions(language: str) -> str:
    """What figures and tables are called where babel does not know the language."""
    words = {key: plain(f"block.{key}", language, number="").strip() for key in ("figure", "table")}
    return "".join(rf"\AtBeginDocument{{\renewcommand\{key}name{{{latex_text(word)}}}}}" for key, word in words.items())


HEADINGS = {0: r"\part*", 1: r"\section", 2: r"\subsection", 3: r"\subsubsection*"}


def section(part: d.Section, page: Page) -> str:
    """A heading and what stands under it."""
    if not part.title:
        return blocks(part.blocks, page)
    heading = f"{HEADINGS[min(part.level, 3)]}{{{page.inlines(part.title)}}}{anchor(part.label)}"
    return f"{heading}\n\n{blocks(part.blocks, page)}".rstrip()


def blocks(parts: tuple[d.Block, ...], page: Page) -> str:
    """Blocks below each other; a formula and what it follows are one paragraph for TeX."""
    found = ""
    for block, before in zip(parts, (None, *parts[:-1]), strict=False):
        goes_on = isinstance(before, (d.Paragraph, d.Display)) and isinstance(block, d.Display)
        found += ("" if before is None else "\n" if goes_on else "\n\n") + page.show(block)
    return found


def anchor(label: str) -> str:
    """The target of references."""
    return rf"\label{{{label}}}" if label else ""


def reference(inline: d.Ref, page: Page) -> str:
    """A reference that TeX resolves itself: an equation's comes in brackets."""
    command = r"\pageref" if inline.page else r"\eqref" if inline.mark.startswith("(") else r"\ref"
    return f"{command}{{{inline.label}}}"


def display(block: d.Display, page: Page) -> str:
    """A displayed formula, numbered or not, boxed or not, with its reason."""
    star = "" if block.numbered else "*"
    content = with_reason(block, framed(block, formula(block, page)), page)
    content += rf" \tag*{{{page.show(block.repeats)}}}" if block.repeats else ""
    lines = [rf"\begin{{equation{star}}}{anchor(block.label)}", content, rf"\end{{equation{star}}}"]
    return "\n".join(lines)


def formula(block: d.Display, page: Page) -> str:
    """The formula in one row or an aligned block; shrunk only if nothing else helps."""
    lines = breaking.display_lines(block, page.notation, page.column)
    content = formula_text(lines)
    return rf"\shrunk{{{content}}}" if breaking.widest(lines) > page.column else content


def formula_text(lines: tuple[breaking.DisplayLine, ...]) -> str:
    """One line as it is, several aligned."""
    if len(lines) == 1:
        return f"  {lines[0].shown(render)}"
    rows = (line.shown(render, "&", r"\qquad {}") for line in lines)
    inner = " \\\\\n  ".join(f"&{{-}}{row[2:]}" if row.startswith("&-") else row for row in rows)  # else the sum above goes on
    return f"\\begin{{aligned}}\n  {inner}\n\\end{{aligned}}"


def framed(block: d.Display, content: str) -> str:
    """The content in a box, if it is a result."""
    return rf"\boxed{{{content}}}" if block.boxed else content


def with_reason(block: d.Display, content: str, page: Page) -> str:
    """The content with its reason beside it, or below where there is no room."""
    if block.reason is None:
        return content
    reason = page.inlines(block.reason)
    if breaking.reason_fits(block, page.notation, page.column):
        return rf"{content} \reasonbeside{{{reason}}}"
    return f"\\begin{{gathered}}\n{content} \\\\\n\\reasonbelow{{{reason}}}\n\\end{{gathered}}"


def table(block: d.Table, page: Page) -> str:
    """A table with three rules; columns of words wrap, and what is still too wide is shrunk."""
    lines = [" & ".join(map(page.inlines, block.header)) + r" \\ \midrule"]
    lines += [f"{' & '.join(cell(c, page) for c in row)}{strut(row, page)} \\\\" for row in block.rows]
    rules = "\n".join([r"\toprule", *lines, r"\bottomrule"])
    caption = rf"\caption{{{page.inlines(block.caption)}}}" if block.caption else ""
    head = f"\\begin{{table}}[!ht]\\centering\n{caption}{anchor(block.label)}"
    return f"{head}\n{tabular(block, rules, page)}\n\\end{{table}}"


def cell(inlines: d.Inlines, page: Page) -> str:
    """A cell; a formula alone in it stands in display style."""
    node = alone(inlines)
    return rf"$\displaystyle {to_latex(node, page.notation)}$" if node else page.inlines(inlines)


def strut(row: tuple[d.Inlines, ...], page: Page) -> str:
    """What keeps the lines of a row with tall formulas apart."""
    nodes = [part.node for inlines in row for part in inlines if isinstance(part, d.Math)]
    tall = any(cutting.node_height(node, page.notation) > 1.6 for node in nodes)
    return r"\tallrow" if tall else ""


def tabular(block: d.Table, rules: str, page: Page) -> str:
    """The rules and rows in the environment that gives the columns their widths."""
    columns = "".join(column(block, place, page) for place in range(len(block.header)))
    if "X" in columns:
        return f"\\begin{{tabularx}}{{\\linewidth}}{{{columns}}}\n{rules}\n\\end{{tabularx}}"
    inner = f"\\begin{{tabular}}{{{columns}}}\n{rules}\n\\end{{tabular}}"
    too_wide = breaking.table_width(block, page.notation) > page.column
    return rf"\resizebox{{\linewidth}}{{!}}{{{inner}}}" if too_wide else inner


def column(block: d.Table, place: int, page: Page) -> str:
    """The letter of one column."""
    letter = block.columns[place]
    if letter == "p":
        room = breaking.wrapped_width(block, place, page.notation, page.column)
        return rf">{{\raggedright\arraybackslash}}m{{{room}em}}" if room else "l"
    return "X" if letter == "l" and breaking.is_wordy(block, place) else letter


def figure(block: d.FigureBlock, page: Page) -> str:
    """Scenes side by side, with their caption."""
    scenes = "\\hfil\n".join(to_tikz(scene, page.notation) for scene in block.scenes)
    caption = rf"\caption{{{page.inlines(block.caption)}}}"
    return f"\\begin{{figure}}[!ht]\\centering\n{scenes}\n{caption}{anchor(block.label)}\n\\end{{figure}}"


def item_list(block: d.ItemList, page: Page) -> str:
    """A list."""
    kind = "enumerate" if block.ordered else "itemize"
    items = "\n".join(rf"  \item {page.inlines(item)}" for item in block.items)
    return f"\\begin{{{kind}}}\n{items}\n\\end{{{kind}}}"


def callout(block: d.Callout, page: Page) -> str:
    """A remark with a rule at its left."""
    title = page.inlines(block.title) or latex_text(page.word(f"callout.{block.kind}"))
    joint = "\n" if block.blocks and isinstance(block.blocks[0], d.Display) else "\n\n"
    return f"\\begin{{callout}}{{{block.kind}}}{{{title}}}{joint}{blocks(block.blocks, page)}\n\\end{{callout}}"


LATEX = prints(
    reference, display, table, figure, item_list, callout, section,
    text=lambda inline, page: latex_text(inline.text),
    math=lambda inline, page: f"${to_latex(inline.node, page.notation)}$",
    emph=lambda inline, page: rf"\emph{{{page.inlines(inline.inlines)}}}",
    strong=lambda inline, page: rf"\textbf{{{page.inlines(inline.inlines)}}}",
)  # fmt: skip
