"""Theory and comparisons as sections."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.derivation.step import Derivation, Lesson
from rbpsym.document.chapters import said_step
from rbpsym.document.model import Block, Inlines, Paragraph, Section
from rbpsym.document.words import Words


def lesson_sections(lesson: Lesson, about: Derivation | None, language: str, prefix: str) -> list[Section]:
    """One section with all steps of a lesson."""
    problem = about.study.problem if about else None
    said = Words(language, problem, prefix, frozenset(step.id for step in lesson.steps))
    return [Section(_title(lesson, said), tuple(_blocks(lesson, said)), prefix + "section." + lesson.kind, 1)]


def _title(lesson: Lesson, said: Words) -> Inlines:
    if lesson.kind == "comparison":
        return said.say("comparison.title", first=said.title(lesson.slots["first"]), second=said.title(lesson.slots["second"]))
    return said.say(f"section.{lesson.kind}")


def _blocks(lesson: Lesson, said: Words) -> Iterator[Block]:
    if said.has(f"{lesson.kind}.intro"):
        yield Paragraph(said.say(f"{lesson.kind}.intro"))
    for step in lesson.steps:
        yield from said_step(step, said)
