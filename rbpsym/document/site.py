"""The library as a site: an index page by topic with small drawings, and pages that link back to it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from markupsafe import Markup

from rbpsym.derivation.step import Derivation
from rbpsym.document.book import Chapter
from rbpsym.document.figures.schematic import schematic
from rbpsym.document.figures.svg import to_svg
from rbpsym.document.model import Document
from rbpsym.document.notes import notation_of
from rbpsym.document.phrases import plain
from rbpsym.document.sketches import sketch_of
from rbpsym.document.writers.html import font, style, write_html
from rbpsym.document.writers.page import shell

HOME = "index.html"


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
        chapter.name, chapter.title(language), chapter.topic, problem.source, level, drawing(chapter.derivation, language)
    )


def drawing(derivation: Derivation, language: str = "en") -> str:
    """The schematic of a problem; its labels are not read aloud twice."""
    return to_svg(schematic(sketch_of(derivation)), notation_of(derivation, language))


def index_page(courses: Sequence[Card], problems: Sequence[Card], language: str = "en", book: str = "") -> str:
    """The page that leads to all others; `book` is the address of the book, "" if there is none."""
    topics = [(topic, list(group)) for topic, group in groupby(problems, key=lambda card: card.topic)]
    said = {key: plain(f"library.{key}", language) for key in ("title", "subtitle", "courses", "other", "book")}
    return shell(
        "site.html",
        autoescape=True,
        language=language,
        said=said,
        courses=courses,
        topics=[
            (topic[:1].upper() + topic[1:] or said["other"], [shown(card) for card in group]) for topic, group in topics
        ],
        book=book,
        style=Markup(style()),
        font=Markup(font()),
    )


def shown(card: Card) -> dict[str, object]:
    """A card as the page shell takes it."""
    return {
        "name": card.name, "title": card.title, "source": card.source, "level": card.level,
        "drawing": Markup(card.drawing),
    }  # fmt: skip


def page(document: Document) -> str:
    """The notes with a link to the index page."""
    return write_html(document, home=HOME)
