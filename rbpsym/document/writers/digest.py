"""What slides show of a document: its figures, its results with the step to which their words point, and what is asked."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import groupby

from rbpsym.document import model as d

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
