"""The whole library: a book in each format, and a site with a page for each problem and course."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import click

from rbpsym.commands.listing import place
from rbpsym.commands.progress import Progress
from rbpsym.commands.shelf import Entry, shelf
from rbpsym.commands.solve import exit_code
from rbpsym.commands.watching import KeptDerivations
from rbpsym.courses import derive_course
from rbpsym.document.book import Card, Chapter, around, book, index_page, occurring, page, problem_card
from rbpsym.document.files import write_all
from rbpsym.document.notes import course_notes, notes
from rbpsym.document.writers import files
from rbpsym.errors import RbpsymError
from rbpsym.statement.course import load_course

if TYPE_CHECKING:
    from rbpsym.commands.notes import NotesWish

STEM = "library"


def write_library(wish: NotesWish) -> int:
    """Writes all; tells the files. 1 if a problem can't be derived or not all of it is proved."""
    kept = KeptDerivations(wish.simulation)
    problems, failed = derived(wish, kept)
    made = dict(book_files(problems, wish))
    if "html" in wish.formats:
        made |= site_files(problems, wish, kept)
    for file in write_all(wish.output, made):
        click.echo(str(file))
    for error in failed:
        click.echo(error, err=True)
    return 0 if not failed and all(is_fine(chapter) for chapter in problems) else 1


def derived(wish: NotesWish, kept: KeptDerivations) -> tuple[list[Chapter], list[str]]:
    """The problems by topic and from easy to hard, and the sentences of those that can't be derived."""
    entries = sorted((entry for entry in shelf() if entry.kind == "problem"), key=place)
    found, failed = [], []
    with Progress("deriving", len(entries)) as progress:
        for entry in entries:
            progress.step(entry.name)
            try:
                found.append(Chapter(entry.name, entry.topic(wish.language), kept.derivation(entry.path)))
            except RbpsymError as error:
                failed.append(f"{entry.name} is left out: {error}")
    return found, failed


def is_fine(chapter: Chapter) -> bool:
    """Is all of a problem proved?"""
    return exit_code(chapter.derivation.summary()) == 0


def book_files(problems: list[Chapter], wish: NotesWish) -> Iterator[tuple[str, str | bytes]]:
    """The book in all formats but HTML, which is the site."""
    document = book(problems, wish.language, wish.detail, plots=wish.plots)
    for name in wish.formats:
        if name != "html":
            yield from files(document, name, STEM, wish.engine).items()


def site_files(problems: list[Chapter], wish: NotesWish, kept: KeptDerivations) -> dict[str, str | bytes]:
    """The index page, and a page for each problem and course."""
    courses: list[tuple[Card, str]] = []
    for entry in (entry for entry in shelf() if entry.kind == "course"):
        document = course_notes(
            derive_course(load_course(entry.path), derived=kept.derivation),
            wish.language,
            wish.detail,
            plots=wish.plots,
        )
        courses.append((card(entry, wish.language), page(document)))
    levels = {entry.name: entry.level(wish.language) for entry in shelf()}
    cards = [problem_card(chapter, wish.language, levels[chapter.name]) for chapter in problems]
    whole = f"{STEM}.pdf" if "pdf" in wish.formats else ""
    terms = occurring(problems, wish.language)
    index = index_page([c for c, _ in courses], cards, wish.language, whole, terms)
    found: dict[str, str | bytes] = {"index.html": index}
    found |= {f"{card.name}.html": content for card, content in courses}
    for number, chapter in enumerate(problems):
        document = notes(chapter.derivation, wish.language, wish.detail, plots=wish.plots)
        found[f"{chapter.name}.html"] = page(document, around(problems, number, wish.language))
    return found


def card(entry: Entry, language: str) -> Card:
    """A course on the index page."""
    return Card(entry.name, entry.title(language), "", entry.source)
