"""Slides: LaTeX beamer, which breaks the frames; what is not broken and higher than a slide is scaled down."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import accumulate, groupby
from operator import itemgetter

from rbpsym.document import model as d
from rbpsym.document.model import numbered
from rbpsym.document.writers.latex import LATEX, anchor, blocks, source_of
from rbpsym.document.writers.page import Page, Print, page_for, page_of
from rbpsym.document.writers.pdf import compiled, has_pdflatex
from rbpsym.frozen import replace
from rbpsym.pictures.figures.scene import placed
from rbpsym.pictures.figures.tikz import to_tikz
from rbpsym.typeset.escaping import latex_text

# --- what slides show of a document: its figures, its equations of motion and answers with the step to which their words point


SHOWN = (d.FigureBlock, d.ItemList, d.Callout)
MOTION = "section.motion"
NEVER = ("section.checks", "section.results")


def digest(document: d.Document) -> d.Document:
    """One problem with its whole argument, but for checks and tables at the end; of a course one section for each of the first
    level, in which the results follow each other."""
    if len({section.label for section in document.sections if section.label.endswith(MOTION)}) < 2:
        return replace(document, sections=tuple(part for part in document.sections if not part.label.endswith(NEVER)))
    counted = zip(accumulate(part.level <= 1 for part in document.sections), document.sections, strict=True)
    parts = [[part for _, part in group] for _, group in groupby(counted, itemgetter(0))]  # of the first level, with those below
    found = [section for part in parts for section in _gathered(part)]
    labels = {label for section in found for block in section.blocks for label in _labels(block)}
    labels |= {section.label for section in found}
    told = [replace(section, blocks=tuple(_without_gaps(section.blocks, labels))) for section in found]
    return replace(document, sections=tuple(section for section in told if section.blocks or section.level == 0))


def _gathered(part: list[d.Section]) -> Iterator[d.Section]:
    blocks = [block for section in part if not section.label.endswith(NEVER) for block in _wanted(section)]
    kept = _kept(blocks, {id(block) for section in part if section.label.endswith(MOTION) for block in section.blocks})
    found = tuple(block for k, block in enumerate(blocks) if k in kept)
    is_bare = all(isinstance(block, d.Paragraph) for block in found) and any(isinstance(block, d.Display) for block in blocks)
    yield replace(part[0], blocks=() if is_bare else found)  # words that lead to formulas which are not shown


def _wanted(section: d.Section) -> Iterable[d.Block]:
    """All blocks; of a section of words alone the first paragraph, under its title where this is not that of the frame."""
    is_told = not any(isinstance(block, (d.Display, d.FigureBlock, d.Table, d.ItemList)) for block in section.blocks)
    told = section.blocks[:1] if section.level <= 1 else (d.Callout("note", section.title, section.blocks[:1]),)
    return told if is_told and section.blocks else section.blocks


def _kept(blocks: list[d.Block], motion: set[int]) -> set[int]:
    """The places of the answers, the equations of motion and the figures, of the words before a formula, and of the formulas
    to which these point."""
    places = {label: k for k, block in enumerate(blocks) if isinstance(block, d.Display) for label in _labels(block)}
    begins = blocks and isinstance(blocks[0], d.Paragraph) and not isinstance(blocks[min(1, len(blocks) - 1)], d.Display)
    kept = {0} if begins else set()
    for k, block in enumerate(blocks):
        if isinstance(block, SHOWN) or (isinstance(block, d.Paragraph) and block.is_question):
            kept.add(k)
        if isinstance(block, d.Display) and (block.boxed or (block.is_result and id(block) in motion)):
            lead = k - 1 if k and isinstance(blocks[k - 1], d.Paragraph) else k
            kept |= {k, lead, *(places[label] for label in _named(blocks[lead]) if label in places)}
    return kept


def _without_gaps(blocks: Iterable[d.Block], labels: set[str]) -> Iterator[d.Block]:
    """The blocks but for words that point to what is not shown."""
    for block in blocks:
        if isinstance(block, d.Callout):
            inner = tuple(_without_gaps(block.blocks, labels))
            if inner:
                yield replace(block, blocks=inner)
        elif not isinstance(block, d.Paragraph) or set(_named(block)) <= labels:
            yield block


def _labels(block: d.Block) -> Iterator[str]:
    yield from filter(None, (getattr(block, "label", ""), *getattr(block, "also", ())))


def _named(block: d.Block) -> Iterator[str]:
    """The labels to which words point."""
    for inline in block.inlines if isinstance(block, d.Paragraph) else ():
        if isinstance(inline, d.Ref):
            yield inline.label


# ---


COLUMN = 36.0  # em of formulas
WIDEST = 14.0  # cm of a figure


def write_slides(document: d.Document) -> str:
    """The document as a LaTeX source for beamer."""
    document = numbered(document)
    page = page_for(document, SLIDES, COLUMN)
    tops = [part for part in document.sections if part.level == 1]
    inner = "\n\n".join(section(part, page_of(part, page)) for part in document.sections)
    contents, columns = latex_text(page.word("block.contents")), 2 if len(tops) > 9 else 1
    return source_of("slides.tex", document, page, inner, contents=contents, columns=columns)


def slides_files(document: d.Document, stem: str) -> dict[str, str | bytes]:
    """The LaTeX source of the figures and results, and the PDF where pdflatex is installed."""
    source = write_slides(digest(document))
    found: dict[str, str | bytes] = {f"{stem}-slides.tex": source}
    return found | {f"{stem}-slides.pdf": compiled(source)} if has_pdflatex() else found


def section(part: d.Section, page: Page) -> str:
    """The frame of a section, which TeX goes on with on further slides; one without text of its own is a slide with its title."""
    title = page.inlines(part.title)
    command = {0: r"\part", 1: r"\section", 2: r"\subsection"}.get(part.level)
    heading = f"{command}{{{title}}}{anchor(part.label)}\n" if command else ""
    if not part.blocks:
        return f"{heading}\\partframe{{{title}}}"
    return f"{heading}\\begin{{frame}}[allowframebreaks=0.85]{{{title}}}\n\\apart\n{blocks(part.blocks, page)}\n\\end{{frame}}"


def figure(block: d.FigureBlock, page: Page) -> str:
    """Scenes side by side, made smaller where they are a little too wide for a frame."""
    content = "\\quad\n".join(to_tikz(scene, page.notation) for scene in block.scenes)
    bounds = [placed(scene, page.notation).bounds for scene in block.scenes]
    width = sum(right - left for left, _, right, _ in bounds) + 0.35 * (len(bounds) - 1)
    content = rf"\resizebox{{\linewidth}}{{!}}{{{content}}}" if width > WIDEST else content
    caption = rf"\caption{{{page.inlines(block.caption)}}}{anchor(block.label)}"
    return f"\\begin{{figure}}\\centering\n{content}\n{caption}\n\\end{{figure}}"


def fitted(show: Print) -> Print:
    """What is never torn apart: it is scaled down where it is higher than a slide."""
    return lambda block, page: f"\\begin{{fitted}}\n{show(block, page)}\n\\end{{fitted}}"


WHOLE: Mapping[type, Print] = {**{kind: LATEX[kind] for kind in (d.Table, d.Callout)}, d.FigureBlock: figure}
SLIDES: Mapping[type, Print] = {**LATEX, **{kind: fitted(show) for kind, show in WHOLE.items()}}
