"""The statement of a problem on a worksheet: words, figure, and the table of the student's numbers."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.derivation.step import Derivation
from rbpsym.document.model import Block, Inlines, Math, Table, words
from rbpsym.document.notes_statement import statement_section
from rbpsym.document.words import Words
from rbpsym.notation import tree as t
from rbpsym.statement.model import Problem
from rbpsym.teaching.model import Measure
from rbpsym.teaching.situations import Situation
from rbpsym.teaching.units import measure_text
from rbpsym.teaching.wording import spoken


def statement_blocks(derivation: Derivation, said: Words) -> tuple[Block, ...]:
    """What the system is and how it starts, its figure and the conventions; without the table of symbols."""
    section = statement_section(derivation, said, 2)
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
        yield (Math(t.Sym(name)),), inlines, _value(measure, said.notation.decimal)


def _start(problem: Problem, name: str, said: Words) -> Inlines:
    """What a constant is at which a coordinate or a speed starts."""
    of = [t.Sym(c.name) for c in problem.coordinates if getattr(c.start, "name", None) == name]
    of += [t.Sym(f"{c.name}_dot") for c in problem.coordinates if getattr(c.speed, "name", None) == name]
    return said.say("symbols.start", of=of, count=len(of))


def _value(measure: Measure, mark: str) -> Inlines:
    return words(measure_text(measure, mark))
