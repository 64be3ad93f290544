"""The solution: the derivation as in the notes, and each answer from it with the student's numbers."""

from __future__ import annotations

from rbpsym.derivation.step import Derivation
from rbpsym.document.chapters import chapter_sections
from rbpsym.document.model import Block, Paragraph, Ref, Section
from rbpsym.document.notes import shown_steps, words_of
from rbpsym.document.words import Words
from rbpsym.teaching import model as m
from rbpsym.teaching.papers.layout import numbers, solution_blocks
from rbpsym.teaching.wording import say

DETAIL = "standard"


def part_sections(part: m.Part, worksheet: m.Worksheet, derivation: Derivation) -> list[Section]:
    """The sections of one problem: its derivation (the same for all students), then its answers."""
    language = worksheet.language
    several = len(worksheet.parts) > 1
    level = 2 if several else 1
    found = [Section(part.title, (), level=1)] if several else []
    chapters = derivation_sections(part.problem, derivation, language, level)
    labels = {label for chapter in chapters for label in labels_in(chapter)}
    found += chapters
    blocks: list[Block] = (
        [Paragraph(say("solution.numbers", language, given=numbers(part, worksheet)))] if part.given else []
    )
    for item in part.items:
        blocks += [block for block in solution_blocks(item, worksheet) if references(block) <= labels]
    return [*found, Section(say("solution.answers", language), tuple(blocks), level=level)]


def derivation_sections(problem: str, derivation: Derivation, language: str, level: int) -> list[Section]:
    """The chapters of the notes, labelled as the answers refer to them."""
    prefix = f"{problem}."
    said: Words = words_of(derivation, all_steps(derivation), language, prefix)
    return list(chapter_sections(derivation, said, level))


def all_steps(derivation: Derivation) -> frozenset[str]:
    """The steps of the standard detail, and all that an answer may point at."""
    from rbpsym.teaching.targets import targets

    return shown_steps(derivation, DETAIL) | {x.step for x in targets(derivation) if x.step}


def labels_in(section: Section) -> set[str]:
    """What a section's blocks may be referred to by."""
    found = {block.label for block in section.blocks if getattr(block, "label", "")}
    return found | {label for block in section.blocks for label in getattr(block, "also", ())}


def references(block: Block) -> set[str]:
    """What a paragraph refers to; a step that stands in a table only can't be."""
    inlines = block.inlines if isinstance(block, Paragraph) else ()
    return {inline.label for inline in inlines if isinstance(inline, Ref)}
