"""Slides: LaTeX beamer, its frames filled by estimated heights; a frame that is still too full is scaled down."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import groupby

from rbpsym.document import breaking
from rbpsym.document import model as d
from rbpsym.document.escaping import latex_text
from rbpsym.document.figures.placing import placed
from rbpsym.document.figures.tikz import to_tikz
from rbpsym.document.numbering import numbered
from rbpsym.document.writers.latex import LATEX, anchor, blocks, source_of
from rbpsym.document.writers.page import Page, Print, page_for, page_of
from rbpsym.document.writers.pdf import compiled, has_pdflatex
from rbpsym.frozen import dataclass, replace

# --- what slides show of a document: its figures, its results with the step to which their words point, and what is asked


SHOWN = (d.FigureBlock, d.ItemList, d.Callout)
NEVER = ("section.checks", "section.results")


def digest(document: d.Document) -> d.Document:
    """The document with one section for each of the first level, in which the results follow each other."""
    parts = [list(group) for _, group in groupby(document.sections, _Counter())]
    found = [section for part in parts for section in _gathered(part)]
    labels = {label for section in found for block in section.blocks for label in _labels(block)}
    labels |= {section.label for section in found}
    told = [replace(section, blocks=tuple(_without_gaps(section.blocks, labels))) for section in found]
    return replace(document, sections=tuple(section for section in told if section.blocks or section.level == 0))


class _Counter:
    """Numbers the sections of the first level, each with those below it."""

    def __init__(self) -> None:
        self.count = 0

    def __call__(self, section: d.Section) -> int:
        self.count += section.level <= 1
        return self.count


def _gathered(part: list[d.Section]) -> Iterator[d.Section]:
    blocks = [block for section in part if not section.label.endswith(NEVER) for block in _wanted(section)]
    kept = _kept(blocks)
    yield replace(part[0], blocks=tuple(block for k, block in enumerate(blocks) if k in kept))


def _wanted(section: d.Section) -> Iterable[d.Block]:
    """All blocks; of a section of words alone the first paragraph, under its title where this is not that of the frame."""
    is_told = not any(isinstance(block, (d.Display, d.FigureBlock, d.Table, d.ItemList)) for block in section.blocks)
    told = section.blocks[:1] if section.level <= 1 else (d.Callout("note", section.title, section.blocks[:1]),)
    return told if is_told and section.blocks else section.blocks


def _kept(blocks: list[d.Block]) -> set[int]:
    """The places of the results and figures, of the words before a result, and of the formulas to which these point."""
    places = {label: k for k, block in enumerate(blocks) if isinstance(block, d.Display) for label in _labels(block)}
    kept = {0} if blocks and isinstance(blocks[0], d.Paragraph) else set()
    for k, block in enumerate(blocks):
        if isinstance(block, SHOWN):
            kept.add(k)
        if isinstance(block, d.Display) and block.boxed:
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


COLUMN = 36.0  # em of formulas; text has 40
TEXT = 40.0
FULL = 24.0  # em of a frame below its title
CENTIMETRE = 2.85  # em
WIDEST = TEXT / CENTIMETRE  # cm of a figure


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
    """The frames of a section; one without text of its own is a frame with its title."""
    title = page.inlines(part.title)
    command = {0: r"\part", 1: r"\section", 2: r"\subsection"}.get(part.level)
    heading = f"{command}{{{title}}}{anchor(part.label)}\n" if command else ""
    if not part.blocks:
        return f"{heading}\\partframe{{{title}}}"
    found = list(frames(part.blocks, page))
    return heading + "\n\n".join(frame(title, place, group, page) for place, group in enumerate(found))


def frame(title: str, place: int, group: tuple[d.Block, ...], page: Page) -> str:
    """A frame; the second of a section and those after it say so."""
    count = rf"\,{{\small({place + 1})}}" if place else ""
    return (
        f"\\begin{{frame}}{{{title}{count}}}\n\\begin{{fitted}}\n{blocks(group, page)}\n\\end{{fitted}}\n\\end{{frame}}"
    )


@dataclass(frozen=True, slots=True)
class FramePiece:
    """Blocks that stay on one frame, and their height in em."""

    blocks: tuple[d.Block, ...]
    height: float


def frames(found: tuple[d.Block, ...], page: Page) -> Iterator[tuple[d.Block, ...]]:
    """The blocks in as few groups as fit frames, about equally full."""
    whole = list(pieces(found, page))
    heights = [piece.height for piece in whole]
    fewest = len(packed(heights, FULL, FULL))
    limits = (FULL * share for share in (0.5, 0.6, 0.7, 0.8, 0.9, 1.0))
    even = next(groups for limit in limits if len(groups := packed(heights, limit, limit)) == fewest)
    yield from (tuple(block for k in group for block in whole[k].blocks) for group in even)


def pieces(found: tuple[d.Block, ...], page: Page) -> Iterator[FramePiece]:
    """What must not be torn apart: words and the formula they lead to; a table is cut between rows."""
    lead: tuple[d.Block, ...] = ()
    for block, after in zip(found, (*found[1:], None), strict=True):
        if isinstance(block, d.Paragraph) and isinstance(after, (d.Display, d.Table, d.ItemList)):
            lead = (*lead, block)
            continue
        first, *others = cut(block, page, FULL - sum(height(b, page) for b in lead))
        yield FramePiece((*lead, first), sum(height(b, page) for b in (*lead, first)))
        yield from (FramePiece((part,), height(part, page)) for part in others)
        lead = ()


def cut(block: d.Block, page: Page, room: float) -> list[d.Block]:
    """A block as several that each fit a frame, where that is possible."""
    if isinstance(block, d.Table):
        return cut_table(block, page, room)
    if isinstance(block, d.ItemList):
        return cut_list(block, page, room)
    return list(cut_callout(block, page)) if isinstance(block, d.Callout) else [block]


def cut_table(block: d.Table, page: Page, room: float) -> list[d.Block]:
    """A table as several; only the first has caption and label."""
    groups = packed([row_height(row, page) for row in block.rows], room - 4.0, FULL - 2.0)
    first, *others = (tuple(block.rows[k] for k in group) for group in groups)
    rest = replace(block, caption=(), label="", number="")
    return [replace(block, rows=first), *(replace(rest, rows=rows) for rows in others)]


def cut_list(block: d.ItemList, page: Page, room: float) -> list[d.Block]:
    """A list as several; an ordered one is kept whole, since its numbers would begin anew."""
    if block.ordered:
        return [block]
    groups = packed([text_height(item, page) for item in block.items], room, FULL)
    return [replace(block, items=tuple(block.items[k] for k in group)) for group in groups]


def cut_callout(block: d.Callout, page: Page) -> Iterator[d.Block]:
    """A remark as several with the same title."""
    groups = packed([height(inner, page) for inner in block.blocks], FULL - 3.0, FULL - 3.0)
    yield from (replace(block, blocks=tuple(block.blocks[k] for k in group)) for group in groups)


def packed(heights: list[float], room: float, next_room: float) -> list[list[int]]:
    """Places in groups, the first within `room`, the others within `next_room`."""
    groups: list[list[int]] = [[]]
    for place, own in enumerate(heights):
        limit = room if len(groups) == 1 else next_room
        if groups[-1] and sum(heights[k] for k in groups[-1]) + own > limit:
            groups.append([])
        groups[-1].append(place)
    return groups


def height(block: d.Block, page: Page) -> float:
    """The height of a block in em."""
    return HEIGHTS[type(block)](block, page)


def text_height(inlines: tuple, page: Page, wide: float = TEXT) -> float:
    """Lines of text with formulas in it, and the gap below them."""
    tall = max((breaking.node_height(i.node, page.notation) for i in inlines if isinstance(i, d.Math)), default=1.0)
    return math.ceil(breaking.text_width(inlines, page.notation) / wide) * max(1.25, 0.8 * tall) + 0.5


def display_height(block: d.Display, page: Page) -> float:
    """Its lines, the box, the reason below."""
    lines = breaking.display_lines(block, page.notation, page.column)
    own = sum(max(breaking.height(line.left), breaking.height(line.right)) * 1.06 + 0.4 for line in lines)
    below = block.reason is not None and not breaking.reason_fits(block, page.notation, page.column)
    return own + 1.3 + (1.4 if block.boxed else 0.0) + (1.8 if below else 0.0)


def table_height(block: d.Table, page: Page) -> float:
    """Header, rows and caption."""
    return 2.2 + (1.6 if block.caption else 0.0) + sum(row_height(row, page) for row in block.rows)


def row_height(row: tuple, page: Page) -> float:
    """A row: its tallest formula, or words in two lines where they are many."""
    nodes = [inline.node for cell in row for inline in cell if isinstance(inline, d.Math)]
    tall = max((breaking.node_height(node, page.notation) for node in nodes), default=1.0)
    wordy = max(breaking.text_width(cell, page.notation) for cell in row) > TEXT / 2
    return max(2.6 if tall > 1.6 else 1.3, tall * 1.1 + 0.4, 2.5 if wordy and len(row) > 1 else 0)


def figure(block: d.FigureBlock, page: Page) -> str:
    """Scenes side by side, made smaller where they are a little too wide for a frame."""
    content = "\\quad\n".join(to_tikz(scene, page.notation) for scene in block.scenes)
    content = rf"\resizebox{{\linewidth}}{{!}}{{{content}}}" if figure_width(block, page) > WIDEST else content
    caption = rf"\caption{{{page.inlines(block.caption)}}}{anchor(block.label)}"
    return f"\\begin{{figure}}\\centering\n{content}\n{caption}\n\\end{{figure}}"


def figure_width(block: d.FigureBlock, page: Page) -> float:
    """The width of its scenes side by side, in cm."""
    bounds = [placed(scene, page.notation).bounds for scene in block.scenes]
    return sum(right - left for left, _, right, _ in bounds) + 0.35 * (len(bounds) - 1)


def figure_height(block: d.FigureBlock, page: Page) -> float:
    """Its scenes in a row, and the caption."""
    bounds = [placed(scene, page.notation).bounds for scene in block.scenes]
    tallest = max((top - bottom for _, bottom, _, top in bounds), default=0.0)
    share = min(1.0, WIDEST / max(figure_width(block, page), 1e-9))
    return tallest * share * CENTIMETRE + 1.0 + text_height(block.caption, page)


HEIGHTS: Mapping[type, Callable[..., float]] = {
    d.Paragraph: lambda block, page: text_height(block.inlines, page),
    d.Display: display_height,
    d.Table: table_height,
    d.FigureBlock: figure_height,
    d.ItemList: lambda block, page: sum(text_height(item, page, TEXT - 3) for item in block.items) + 0.5,
    d.Callout: lambda block, page: 2.6 + sum(height(inner, page) for inner in block.blocks),
}

SLIDES: Mapping[type, Print] = {**LATEX, d.FigureBlock: figure}
