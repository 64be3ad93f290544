"""Notes written: the documents of a problem or a course, once or at each change, and the whole library."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import click

from rbpsym.ask.question import read_question
from rbpsym.commands.arguments import shelf, stated
from rbpsym.commands.list import place
from rbpsym.commands.progress import Progress
from rbpsym.commands.solve import exit_code
from rbpsym.courses import derive_course, sources
from rbpsym.derive import derive, physics_of
from rbpsym.document.book import Card, Chapter, around, book, index_page, occurring, page, problem_card
from rbpsym.document.files import write_all
from rbpsym.document.model import Document
from rbpsym.document.notes import course_notes, notes
from rbpsym.document.twin import with_twins
from rbpsym.document.writers import files
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.assemble import assemble
from rbpsym.mechanics.at_start import StartStudy
from rbpsym.mechanics.instant import has_start
from rbpsym.proof.step import Derivation
from rbpsym.statement.course import load_course
from rbpsym.statement.model import Problem

# --- files that are watched: something is done again each time one of them has changed


PAUSE = 0.08  # seconds between two looks

Stamp = tuple[int, int]


def stamps(paths: Iterable[Path]) -> dict[Path, Stamp | None]:
    """When each file was written and its size; None if it is not there."""
    return {path: stamp(path) for path in paths}


def stamp(path: Path) -> Stamp | None:
    """Time of writing and size."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


def watch(write: Callable[[], list[Path]], sources: Callable[[], list[Path]], until: Callable[[], bool]) -> int:
    """Writes, then again after each change of the sources, until told to stop (Ctrl-C stops it too).

    Returns 0. An error of the input is told, and the next change waited for.
    """
    click.echo("watching; Ctrl-C ends it.", err=True)
    try:
        while True:
            seen = stamps(sources())
            told(write)
            while stamps(sources()) == seen:
                if until():
                    return 0
                time.sleep(PAUSE)
    except KeyboardInterrupt:
        click.echo("ended.", err=True)
        return 0


def told(write: Callable[[], list[Path]]) -> None:
    """Write once; tell which files and how long it took, or what is wrong."""
    begun = time.perf_counter()
    try:
        files = write()
    except RbpsymError as error:
        click.echo(str(error), err=True)
        return
    names = ", ".join(path.name for path in files)
    click.echo(f"{time.strftime('%H:%M:%S')}  {names}  ({time.perf_counter() - begun:.2f} s)")


# --- derivations that are kept while a process watches files: only what an edit changes is derived anew


class KeptDerivations(Frozen):
    """The derivations of files, by path; `whole`: also of what no question asks for."""

    simulation: bool
    whole: bool = True
    found: dict[Path, Derivation] = field(default_factory=dict)

    def derivation(self, path: Path) -> Derivation:
        """The derivation of a problem file as it is now. Raises what loading and deriving raise."""
        problem, before = stated(path), self.found.get(path)
        if before is not None and physics_of(before.study.problem) == physics_of(problem):
            self.found[path] = replace(before, study=before.study.under(problem))
        else:
            study = StartStudy(problem) if not self.whole and _asks_of_release(problem) else None
            self.found[path] = derive(problem, simulation=self.simulation, study=study)
        return self.found[path]


def _asks_of_release(problem: Problem) -> bool:
    """Is all that is asked asked of the moment at which several coordinates are let go? No speed counts there."""
    asked = [when for text in problem.questions if (when := read_question(text).when) and when.kind == "start"]
    still = all(c.speed == t.ZERO for c in problem.coordinates) and has_start(problem) and not problem.phases
    return still and len(asked) == len(problem.questions) > 0 and len(assemble(problem).independent) > 1


# --- the notes of a problem or a course


class NotesWish(Frozen):
    """What is to be written: formats, language, level of detail, whether plots and the simulation are wanted."""

    formats: tuple[str, ...]
    engine: str
    language: str
    detail: str
    simulation: bool
    plots: bool
    studio: str
    output: Path


def once(kind: str, path: Path, wish: NotesWish) -> int:
    """Write, tell the files; 1 if not all is proved."""
    document, fine = DOCUMENTS[kind](path, wish, KeptDerivations(wish.simulation, wish.detail == "full"))
    for file in _written(document, path.stem, wish):
        click.echo(str(file))
    return 0 if fine else 1


def watched(kind: str, path: Path, wish: NotesWish) -> int:
    """Write again at each change."""
    kept = KeptDerivations(wish.simulation, wish.detail == "full")
    return watch(
        lambda: _written(DOCUMENTS[kind](path, wish, kept)[0], path.stem, wish),
        lambda: _sources(kind, path),
        lambda: False,
    )


def _sources(kind: str, path: Path) -> list[Path]:
    """The files that the notes are made of; the file alone while it can't be read."""
    try:
        return [path, *sources(load_course(path))] if kind == "course" else [path]
    except (RbpsymError, OSError):
        return [path]


def _problem(path: Path, wish: NotesWish, kept: KeptDerivations) -> tuple[Document, bool]:
    """The document of a problem, and whether all of it is proved."""
    with Progress(f"deriving {path.stem}"):
        derivation = kept.derivation(path)
        return notes(derivation, wish.language, wish.detail, plots=wish.plots), exit_code(derivation.summary()) == 0


def _course(path: Path, wish: NotesWish, kept: KeptDerivations) -> tuple[Document, bool]:
    """The document of a course, and whether all of it is proved."""
    course = load_course(path)
    with Progress(f"deriving {path.stem}", len(course.parts)) as progress:
        derived = derive_course(course, progress=progress.step, derived=kept.derivation)
        document = course_notes(derived, wish.language, wish.detail, plots=wish.plots)
    steps = [step for lesson in derived.lessons.values() for step in lesson.steps]
    fine = all(step.certificate.verdict.is_proved for step in steps)
    return document, fine and all(exit_code(d.summary()) == 0 for d in derived.derivations.values())


DOCUMENTS = {"problem": _problem, "course": _course}


def library(name: str | None, is_watched: bool, wish: NotesWish) -> int:
    """The book and the site; tells the files. 1 if a problem can't be derived or not all of it is proved."""
    if name is not None or is_watched:
        raise click.UsageError("--all writes the whole library: it takes no name and no --watch.")
    kept = KeptDerivations(wish.simulation, wish.detail == "full")
    problems, failed = derived(wish, kept)
    made = dict(book_files(problems, wish))
    if "html" in wish.formats:
        made |= site_files(problems, wish, kept)
    for file in write_all(wish.output, made):
        click.echo(str(file))
    for error in failed:
        click.echo(error, err=True)
    return 0 if not failed and all(exit_code(chapter.derivation.summary()) == 0 for chapter in problems) else 1


def _written(document: Document, stem: str, wish: NotesWish) -> list[Path]:
    """All formats are made before the first file is written."""
    document = with_twins(document, wish.studio) if wish.studio else document
    made = {name: content for f in wish.formats for name, content in files(document, f, stem, wish.engine).items()}
    return write_all(wish.output, made)


# --- the whole library: a book in each format, and a site with a page for each problem and course


STEM = "library"


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
        courses.append((Card(entry.name, entry.title(wish.language), "", entry.source), page(document)))
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
