"""The whole library as a book: topics, problems, their chapters, and an index of what occurs in which problem."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from rbpsym.derivation.step import Derivation
from rbpsym.document.model import Document, Inlines, ItemList, Paragraph, Ref, Section, Text, words
from rbpsym.document.notes import CHECKS, notation_of, problem_sections
from rbpsym.document.notes_checks import checks_table
from rbpsym.document.phrases import has_phrase, phrase, plain
from rbpsym.document.words import Words, capital
from rbpsym.mechanics.study import Study
from rbpsym.notation.letters import without_accents


@dataclass(frozen=True)
class Chapter:
    """A problem of the library: its name, topic and derivation."""

    name: str
    topic: str
    derivation: Derivation

    def title(self, language: str) -> str:
        """The title of the problem."""
        problem = self.derivation.study.problem
        return Words(language, problem).title(problem.title) or self.name


def book(
    chapters: Sequence[Chapter], language: str = "en", detail: str = "standard", *, plots: bool = False
) -> Document:
    """The chapters in their order as one document, with contents, the checks of all steps, and an index."""
    sections: list[Section] = []
    place = 0
    for topic, group in groupby(chapters, key=lambda chapter: chapter.topic):
        sections.append(Section(topic_words(topic, language), (), level=0))
        for chapter in group:
            place += 1
            sections += chapter_sections(chapter, place, language, detail, plots)
    sections += [checks(chapters, language), index(chapters, language)]
    return Document(
        phrase("library.title", language),
        tuple(sections),
        phrase("library.subtitle", language),
        language=language,
        is_book=True,
    )


def topic_words(topic: str, language: str) -> Inlines:
    """The heading of a topic."""
    return capital(words(topic)) if topic else phrase("library.other", language)


def chapter_sections(chapter: Chapter, place: int, language: str, detail: str, plots: bool) -> Iterator[Section]:
    """A problem: its title, then its sections, all in its own notation."""
    notation = notation_of(chapter.derivation, language)
    yield Section(words(chapter.title(language)), (), label(place), 1, notation=notation)
    for section in problem_sections(chapter.derivation, language, detail, f"p{place}.", 2, CHECKS, plots=plots):
        yield Section(section.title, section.blocks, section.label, section.level, notation=notation)


def label(place: int) -> str:
    """The label of a problem by its place in the book."""
    return f"p{place}.part"


def checks(chapters: Sequence[Chapter], language: str) -> Section:
    """In which ways the steps of all problems were checked."""
    steps = [step for chapter in chapters for step in chapter.derivation.steps]
    table = checks_table(steps, Words(language))
    text = Paragraph(phrase("library.count", language, problems=len(chapters), steps=len(steps)))
    return Section(phrase("section.checks", language), (text, table), "section.checks", 1)


def index(chapters: Sequence[Chapter], language: str) -> Section:
    """What occurs on which page."""
    items = tuple((*words(term), *references(map(label, places))) for term, places in occurrences(chapters, language))
    return Section(phrase("library.index", language), (ItemList(items),), "section.index", level=0)


def occurrences(chapters: Sequence[Chapter], language: str) -> list[tuple[str, list[int]]]:
    """Shapes, forces, constraints and phenomena in the order of the alphabet, with the places of their problems."""
    found: dict[str, list[int]] = {}
    for place, chapter in enumerate(chapters, 1):
        for kind in subjects(chapter.derivation.study):
            if has_phrase(f"index.{kind}", language):
                found.setdefault(plain(f"index.{kind}", language), []).append(place)
    return sorted(found.items(), key=lambda entry: without_accents(entry[0].casefold()))


def references(labels: Iterable[str]) -> Inlines:
    """Pages with commas before them."""
    return tuple(part for label in labels for part in (Text(", "), Ref(label, page=True)))


def subjects(study: Study) -> set[str]:
    """The kinds of bodies, forces and constraints of a problem, and what happens in it."""
    problem = study.problem
    elements = problem.elements
    kinds = {body.shape.kind for body in problem.bodies} | {element.kind for element in elements}
    kinds |= {impulse.kind for phase in problem.phases for impulse in phase.impulses}
    slips = any(element.values.get("coefficient") is not None for element in elements)
    return kinds | {name for name, holds in (*happenings(study).items(), ("slipping", slips)) if holds}


def happenings(study: Study) -> Mapping[str, bool]:
    """Phenomena by name, and whether they occur."""
    return {
        "loss": bool(study.losses),
        "need": bool(study.friction_needs),
        "oscillation": any(found.frequencies_squared and found.stable for found in study.equilibria),
        "phases": bool(study.problem.phases),
    }
