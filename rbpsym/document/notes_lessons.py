"""Theory and comparisons as sections."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.derivation.step import Derivation, Lesson, Step
from rbpsym.document.figures.plane_motion import FIGURES
from rbpsym.document.model import Block, FigureBlock, Inlines, Paragraph, Section
from rbpsym.document.phrases import plain
from rbpsym.document.telling import Teller
from rbpsym.document.words import Words
from rbpsym.errors import NotApplicable
from rbpsym.verify.comparison import common_coordinate


def lesson_sections(lesson: Lesson, about: Derivation | None, language: str, prefix: str) -> list[Section]:
    """A section with the introduction of a lesson, and one below it for each of its headings."""
    problem = about.study.problem if about else None
    said = Words(language, problem, prefix, frozenset(step.id for step in lesson.steps))
    intro = (Paragraph(said.say(f"{lesson.kind}.intro")),) if said.has(f"{lesson.kind}.intro") else ()
    first, *parts = _parts(lesson, said)
    teller = Teller(said)
    blocks = (*intro, *_drawn(lesson, said), *teller.steps(first))
    top = Section(_title(lesson, said), blocks, f"{prefix}section.{lesson.kind}", 1)
    return [top, *(_part(steps, lesson, teller, said) for steps in parts)]


def _drawn(lesson: Lesson, said: Words) -> Iterator[Block]:
    """The figure of a theory."""
    if lesson.name in FIGURES:
        scene = FIGURES[lesson.name](said.notation)
        alt = plain("theory.figure.alt", said.language)
        yield FigureBlock((scene,), said.say("theory.figure.caption"), alt, f"{said.prefix}figure.{lesson.name}")


def compared_figure(first: Derivation, second: Derivation, coordinate: str, said: Words) -> Iterator[Block]:
    """Both motions in one plot, where both can be followed."""
    from rbpsym.document.notes_plots import numbers, panels_figure  # with numpy, which is slow to load
    from rbpsym.document.plots.compared import beside, motions

    name = common_coordinate((first.study, second.study), coordinate)
    try:
        pair = motions(first, second)
        panels = list(beside(pair, name))
    except NotApplicable:
        return
    titles = {key: said.title(one.study.problem.title) for key, one in (("first", first), ("second", second))}
    yield panels_figure("compared", panels, said.say("comparison.figure", **titles), pair[0], said)
    yield Paragraph(numbers(pair[0], said))


def _title(lesson: Lesson, said: Words) -> Inlines:
    if lesson.kind == "comparison":
        first, second = (said.title(lesson.slots[name]) for name in ("first", "second"))
        return said.say("comparison.title", first=first, second=second)
    return said.say(f"section.{lesson.kind}")


def _heading(lesson: Lesson, step: Step) -> str:
    return f"{lesson.kind}.heading.{step.id}"


def _parts(lesson: Lesson, said: Words) -> list[list[Step]]:
    """The steps, cut before each that has a heading; the first part is what has none."""
    found: list[list[Step]] = [[]]
    for step in lesson.steps:
        if said.has(_heading(lesson, step)):
            found.append([])
        found[-1].append(step)
    return found


def _part(steps: list[Step], lesson: Lesson, teller: Teller, said: Words) -> Section:
    blocks: Iterator[Block] = teller.steps(steps)
    return Section(said.say(_heading(lesson, steps[0])), tuple(blocks), f"{said.prefix}section.{steps[0].id}", 2)
