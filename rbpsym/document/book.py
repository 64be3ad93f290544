"""The whole library: as a book by topic with an index, and as a site with a page for each problem."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from markupsafe import Markup

from rbpsym.document.model import Document, Inlines, ItemList, Paragraph, Ref, Section, Text, words
from rbpsym.document.notes import CHECKS, notation_of, problem_sections
from rbpsym.document.notes import plain as plain_words
from rbpsym.document.notes_checks import checks_table
from rbpsym.document.phrases import has_phrase, phrase, plain
from rbpsym.document.words import Words, capital
from rbpsym.document.writers.html import Around, font, style, write_html
from rbpsym.document.writers.page import shell
from rbpsym.expr.letters import without_accents
from rbpsym.frozen import Frozen
from rbpsym.mechanics.study import Study
from rbpsym.pictures.figures.schematic import schematic
from rbpsym.pictures.figures.svg import to_svg
from rbpsym.pictures.sketches import sketch_of
from rbpsym.proof.step import Derivation


class Chapter(Frozen):
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


# --- the library as a site: an index page by topic with small drawings, and pages that link back to it


HOME = "index.html"
SITE = Around(HOME)
Link = tuple[str, str]


class Card(Frozen):
    """An entry of the index page; `drawing` is an SVG or empty."""

    name: str
    title: str
    topic: str = ""
    source: str = ""
    level: str = ""
    drawing: str = ""


def problem_card(chapter: Chapter, language: str, level: str = "") -> Card:
    """The entry of a problem, with its drawing."""
    problem = chapter.derivation.study.problem
    return Card(
        chapter.name,
        chapter.title(language),
        chapter.topic,
        problem.source,
        level,
        drawing(chapter.derivation, language),
    )


def drawing(derivation: Derivation, language: str = "en") -> str:
    """The schematic of a problem; its labels are not read aloud twice."""
    return to_svg(schematic(sketch_of(derivation)), notation_of(derivation, language))


def index_page(
    courses: Sequence[Card],
    problems: Sequence[Card],
    language: str = "en",
    book: str = "",
    found: Sequence[tuple[str, Sequence[Link]]] = (),
) -> str:
    """The page that leads to all others; `book` is the address of the book, "" if there is none.

    `found` are the words of the index with links to the problems in which they occur.
    """
    topics = [(topic, list(group)) for topic, group in groupby(problems, key=lambda card: card.topic)]
    said = {key: plain(f"library.{key}", language) for key in SAID}
    return shell(
        "site.html",
        autoescape=True,
        language=language,
        said=said,
        courses=courses,
        topics=[
            (f"topic-{place}", plain_words(topic_words(topic, language)), [shown(card) for card in group])
            for place, (topic, group) in enumerate(topics, 1)
        ],
        found=found,
        book=book,
        style=Markup(style()),
        font=Markup(font()),
    )


SAID = ("title", "subtitle", "courses", "problems", "other", "book", "index")


def shown(card: Card) -> dict[str, object]:
    """A card as the page shell takes it."""
    return {
        "name": card.name, "title": card.title, "source": card.source, "level": card.level,
        "drawing": Markup(card.drawing),
    }  # fmt: skip


def link(chapter: Chapter, language: str) -> Link:
    """The address of the page of a problem, and its title."""
    return f"{chapter.name}.html", chapter.title(language)


def occurring(chapters: Sequence[Chapter], language: str) -> list[tuple[str, list[Link]]]:
    """The words of the index, each with links to the problems in which it occurs."""
    return [
        (term, [link(chapters[place - 1], language) for place in places])
        for term, places in occurrences(chapters, language)
    ]


def around(chapters: Sequence[Chapter], place: int, language: str) -> Around:
    """What the page of a problem leads to: the index page, its topic, the problems before and after it."""
    own = chapters[place]
    others = tuple(link(c, language) for c in chapters if c.topic == own.topic and c is not own)
    before = link(chapters[place - 1], language) if place else None
    after = link(chapters[place + 1], language) if place + 1 < len(chapters) else None
    return Around(HOME, plain_words(topic_words(own.topic, language)), others, before, after)


def page(document: Document, site: Around = SITE) -> str:
    """The notes with links to the index page and to other problems."""
    return write_html(document, site)
