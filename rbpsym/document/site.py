"""The library as a site: an index page by topic with small drawings, and pages that link back to it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from markupsafe import Markup

from rbpsym.derivation.step import Derivation
from rbpsym.document.book import Chapter, occurrences, topic_words
from rbpsym.document.figures.schematic import schematic
from rbpsym.document.figures.svg import to_svg
from rbpsym.document.model import Document
from rbpsym.document.notes import notation_of
from rbpsym.document.notes import plain as plain_words
from rbpsym.document.phrases import plain
from rbpsym.document.sketches import sketch_of
from rbpsym.document.writers.html import Around, font, style, write_html
from rbpsym.document.writers.page import shell

HOME = "index.html"
SITE = Around(HOME)
Link = tuple[str, str]


@dataclass(frozen=True, slots=True)
class Card:
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
