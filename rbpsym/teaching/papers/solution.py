"""The solution: the derivation as in the notes, and each answer from it with the student's numbers."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.document.chapters import chapter_sections
from rbpsym.document.model import Block, Inlines, Math, Paragraph, Ref, Section, Table, words
from rbpsym.document.notes import phase_words, shown_steps, words_of
from rbpsym.document.notes_phases import phase_sections
from rbpsym.document.notes_statement import statement_section
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.proof.step import Derivation
from rbpsym.statement.model import Problem
from rbpsym.teaching import model as m
from rbpsym.teaching.papers.layout import numbers, solution_blocks
from rbpsym.teaching.ranges import measure_text
from rbpsym.teaching.situations import Situation
from rbpsym.teaching.wording import say, spoken

# --- the statement of a problem on a worksheet: words, figure, and the table of the student's numbers


def statement_blocks(derivation: Derivation, said: Words) -> tuple[Block, ...]:
    """What the system is, how it starts and goes on, its figure and the conventions; without the table of symbols."""
    section = statement_section(derivation, Words(said.language, derivation.study.problem, said.prefix), 2)
    return tuple(block for block in section.blocks if not isinstance(block, Table))


def given_table(derivation: Derivation, situation: Situation, said: Words) -> tuple[Block, ...]:
    """Symbol, meaning and number of all that is given; () if nothing is."""
    problem = derivation.study.problem
    rows = tuple(_rows(problem, situation, said))
    if not rows:
        return ()
    header = (*(said.say(f"header.{key}") for key in ("symbol", "meaning")), spoken(said, "paper.value"))
    return (Table(header, rows, (), "cll"),)


def _rows(problem: Problem, situation: Situation, said: Words) -> Iterator[tuple[Inlines, ...]]:
    known = {q.name: q for q in problem.parameters if q.name not in problem.implicit}
    for name, measure in situation.given.items():
        meaning = said.meaning(name, known[name].meaning) if name in known else _start(problem, name, said)
        inlines = words(meaning) if isinstance(meaning, str) else meaning
        yield (Math(t.Sym(name)),), inlines, words(measure_text(measure, said.notation.decimal))


def _start(problem: Problem, name: str, said: Words) -> Inlines:
    """What a constant is at which a coordinate or a speed starts."""
    begun = [(t.Sym(c.name), c.start) for c in problem.coordinates]
    begun += [(t.Sym(f"{c.name}_dot"), c.speed) for c in problem.coordinates]
    of = [turn(node) for node, value in begun for turn in (t.mul, t.neg) if value == turn(t.Sym(name))]
    return said.say("symbols.start", of=of, count=len(of))


# ---


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
    blocks: list[Block] = [Paragraph(say("solution.numbers", language, given=numbers(part, worksheet)))] if part.given else []
    for item in part.items:
        blocks += [block for block in solution_blocks(item, worksheet) if references(block) <= labels]
    return [*found, Section(say("solution.answers", language), tuple(blocks), level=level)]


def derivation_sections(problem: str, derivation: Derivation, language: str, level: int) -> list[Section]:
    """The chapters of the notes, labelled as the answers refer to them."""
    prefix = f"{problem}."
    said: Words = words_of(derivation, all_steps(derivation), language, prefix)
    later = phase_sections(derivation, said, level, phase_words(derivation, DETAIL, language))
    return [*chapter_sections(derivation, said, level), *later]


def all_steps(derivation: Derivation) -> frozenset[str]:
    """The steps of the standard detail, and all that an answer may point at."""
    from rbpsym.teaching.targets import targets

    return shown_steps(derivation, DETAIL) | {x.step for x in targets(derivation) if x.step}


def labels_in(section: Section) -> set[str]:
    """What a section's blocks may be referred to by."""
    found = {getattr(block, "label", "") for block in section.blocks} - {""}
    return found | {label for block in section.blocks for label in getattr(block, "also", ())}


def references(block: Block) -> set[str]:
    """What a paragraph refers to; a step that stands in a table only can't be."""
    inlines = block.inlines if isinstance(block, Paragraph) else ()
    return {inline.label for inline in inlines if isinstance(inline, Ref)}
