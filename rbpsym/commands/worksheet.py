"""`rbpsym worksheet`: worksheets with keys, a variant for each student, on paper or for a learning platform."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rbpsym.commands.arguments import FILE, FOLDER, ShelfName, formats_option, shelf
from rbpsym.commands.progress import Progress

if TYPE_CHECKING:
    from rbpsym.teaching.batch import Order
    from rbpsym.teaching.executor import Crew
    from rbpsym.teaching.model import Student

PAPERS = ("pdf", "tex", "typ", "html")  # a file for each student
PLATFORMS = ("moodle", "qti", "canvas", "prairielearn", "gift")  # all students together
ENGINES = ("typst", "pdflatex")
MOST = 100_000


@click.command("worksheet")
@click.argument("name", metavar="[WORKSHEET|PROBLEM|FILE]", type=ShelfName("worksheet", "problem"), required=False)
@click.option("-o", "--output", metavar="DIR", type=FOLDER, default=".", show_default=True, help="Folder of the files.")
@click.option("--students", metavar="CSV", type=FILE, help="The class: a column id and, if you like, name.")
@click.option("--variants", metavar="N", type=click.IntRange(1, MOST), help="N different forms, for nobody by name.")
@click.option(
    "--from-code", "code", metavar="CODE", help="The form with this code (it stands at the foot of each paper)."
)
@click.option(
    "--seed", "secret", metavar="S", default="", help="A secret: with it, and only with it, the same forms come again."
)
@click.option("--key", is_flag=True, help="Write keys too.")
@click.option("--solution", is_flag=True, help="Write keys, and solutions with the whole derivation.")
@click.option("--lang", "language", metavar="LANGUAGE", default="", help="Its code, as en; else that of the worksheet.")
@formats_option((*PAPERS, *PLATFORMS), "pdf")
@click.option("--engine", type=click.Choice(ENGINES), default="typst", show_default=True, help="What makes the PDF.")
@click.option("--studio", metavar="ADDRESS", default="", help="A QR code on PDF and LaTeX papers leads to its tutor.")
@click.option("--jobs", type=click.IntRange(min=0), default=0, help="Processes (0: one a core).")
@click.option(
    "--executor", metavar="WHERE", default="", help="Who makes pdf, tex and html: local, or dask://HOST:PORT."
)
def command(
    name: str | None, output: Path, students: Path | None, variants: int | None, code: str | None, jobs: int,
    executor: str, **wish: Any,
) -> int:  # fmt: skip
    """Make a worksheet from a worksheet file or straight from any problem, with keys that are proved.

    \b
    Examples:
      rbpsym worksheet sliding-ladder --key
      rbpsym worksheet my-worksheet.toml --students class.csv --seed autumn --key -o papers
      rbpsym worksheet my-worksheet.toml --variants 30 --format pdf,moodle
      rbpsym worksheet --from-code my-worksheet.en.7K3F-9QTM-2CAB-4D --seed autumn --key

    Without a worksheet file a sensible worksheet is made for the problem. Each student's numbers and
    choices come from the seed, the worksheet and the student alone. An interrupted run goes on when the same
    command is given again.
    """
    from rbpsym.teaching.batch import Order, known_plan, remember
    from rbpsym.teaching.executor import crew

    who = crew(executor, jobs)
    _check_choice(name, students, variants, code)
    order = Order(name or "", folder=str(output), **wish)
    if code is not None:
        return _from_code(order, code)
    people = _people(students, variants)
    _tell_names(order, people)
    lines = _papers(order, people, who) + _platforms(order, people)
    remember(output, known_plan(order.source), order.secret, order.language, people)
    for line in lines:
        click.echo(line)
    return 0


def _check_choice(name: str | None, students: Path | None, variants: int | None, code: str | None) -> None:
    if sum(option is not None for option in (students, variants, code)) > 1:
        raise click.UsageError("give one of --students, --variants and --from-code.")
    if name is None and code is None:
        raise click.UsageError(_what_there_is())


def _what_there_is() -> str:
    """What a worksheet can be made of."""

    ready = "\n".join(f"  {entry.name:<34}{entry.title()}" for entry in shelf() if entry.kind == "worksheet")
    return (
        f"say which worksheet or problem: its name or its file. Ready worksheets:\n{ready}\n"
        "Of every problem a worksheet is made too; rbpsym list shows them all."
    )


def _people(students: Path | None, variants: int | None) -> tuple[Student | None, ...]:
    """The students of a roster, so many nameless ones, or nobody."""
    from rbpsym.teaching.model import Student
    from rbpsym.teaching.spreadsheets import load_roster

    if students is not None:
        return load_roster(students)
    if variants is None:
        return (None,)
    width = max(2, len(str(variants)))
    return tuple(Student(f"{k:0{width}d}") for k in range(1, variants + 1))


def _tell_names(order: Order, people: tuple[Student | None, ...]) -> None:
    """Say whose names the fonts of the papers have no letters for."""
    from rbpsym.teaching.papers.layout import without_letters

    engines = {"pdf": order.engine, "tex": "pdflatex"}
    named = [person for person in people if person is not None]
    for engine in sorted({engines[name] for name in order.formats if name in engines}):
        for student in without_letters(named, engine):
            text = f"the fonts of {engine} have not all letters of “{student.name}”: the key {student.id} stands on the paper"
            click.echo(text, err=True)


def _papers(order: Order, people: tuple[Student | None, ...], who: Crew) -> list[str]:
    """The formats with a file a student; a line for each file, or one for all if there are many."""

    from rbpsym.teaching.batch import papers

    own = replace(order, formats=tuple(f for f in order.formats if f in PAPERS))
    if not own.formats:
        return []
    with Progress("worksheets") as bar:
        found = papers(own, people, who, partial(bar.counted, "worksheets"))
    paths = [path for row in found for path in row]
    return paths if len(paths) <= 12 else [f"{len(paths)} files for {len(people)} students in {order.folder}"]


def _platforms(order: Order, people: tuple[Student | None, ...]) -> list[str]:
    """The formats of learning platforms: all students together; what they can't carry is told."""
    from rbpsym.document.files import write_all
    from rbpsym.teaching.batch import known_plan
    from rbpsym.teaching.formats import exporter

    wanted = [f for f in order.formats if f in PLATFORMS]
    if not wanted:
        return []
    plan = known_plan(order.source)
    worksheets = tuple(plan.worksheet(student, order.secret, order.language) for student in people)
    made = {name: exporter(name)(worksheets, order.options(plan)) for name in wanted}
    files = {path: content for exported in made.values() for path, content in exported.files.items()}
    left_out = [sentence for exported in made.values() for sentence in exported.left_out]
    if left_out:
        click.echo("\n".join(left_out), err=True)
        files["left-out.txt"] = "\n".join(left_out) + "\n"
    paths = [str(path) for path in write_all(Path(order.folder), files)]
    return paths if len(paths) <= 12 else [f"{len(paths)} files in {order.folder}"]


def _from_code(order: Order, code: str) -> int:
    """The form of a code, and its key if asked for; the worksheet is found by the name in the code."""

    from rbpsym.teaching.batch import known_plan, written
    from rbpsym.teaching.codes import name_in

    worksheet, _ = name_in(code)
    beside = f"{worksheet}.toml"
    source = order.source or (beside if Path(beside).is_file() else worksheet)
    order = replace(order, source=source, formats=tuple(f for f in order.formats if f in PAPERS))
    with Progress("the form"):
        plan = known_plan(order.source)
        paths = written(order.files(plan.from_code(code, order.secret), plan), order.folder)
    for path in paths:
        click.echo(path)
    return 0
