"""`rbpsym grade`: the answers of a class in, marks and feedback out."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import click

from rbpsym.commands.arguments import FILE, FOLDER, ShelfName


@click.command("grade")
@click.argument("worksheet", metavar="WORKSHEET", type=ShelfName())
@click.argument("answers", metavar="ANSWERS.CSV", type=FILE)
@click.option("-o", "--output", type=FILE, default="marks.csv", show_default=True, help="File of the marks.")
@click.option("--feedback", metavar="DIR", type=FOLDER, help="Folder of a page of feedback for each student.")
@click.option(
    "--students",
    "roster",
    metavar="CSV",
    type=FILE,
    help="The class list: names in the marks; who is missing or unknown is told.",
)
@click.option("--seed", "secret", metavar="S", default="", help="The --seed with which the papers were made.")
@click.option("--papers", metavar="DIR", type=FOLDER, help="Folder of the papers, if it is not near the answers.")
@click.option(
    "--lang", "language", metavar="LANGUAGE", default="", help="Language of the papers, if not that of the worksheet."
)
@click.option("--executor", metavar="WHERE", default="", help="local, or dask://HOST:PORT.")
@click.option(
    "--jobs", "processes", type=click.IntRange(min=0), default=0, help="Processes on this machine (0: one a core)."
)
def command(worksheet: str, answers: Path, output: Path, feedback: Path | None, **wish: Any) -> int:
    """Grade the answers of a class: formulas, numbers with units, choices, orders, signs.

    \b
    Examples:
      rbpsym grade my-worksheet.toml answers.csv --seed autumn --students class.csv -o marks.csv
      rbpsym grade sliding-ladder answers.csv --feedback feedback
      rbpsym grade my-worksheet.toml answers.csv --executor dask://10.0.0.5:8786

    ANSWERS.CSV has a column “student” (or “code”, the form code on the paper) and one column an item:
    1, 2, 3, blanks as 3.1, 3.2. Open answers, and what could not be decided, are left to you and named in
    the column “teacher”. A run that was interrupted goes on when the same command is given again.
    """
    from rbpsym.commands.progress import Progress
    from rbpsym.teaching.grading.marking import grade, write_graded

    journal = output.with_name(f".{output.name}.journal")
    with Progress("grading") as bar:
        told = partial(bar.counted, "students")
        graded = grade(worksheet, answers, pages=feedback is not None, journal=journal, told=told, **wish)
    written = write_graded(graded, output, feedback)
    journal.unlink(missing_ok=True)
    for sentence in graded.told:
        click.echo(sentence, err=True)
    click.echo(f"{graded.students} students, {graded.answers} answers; {graded.for_teacher} for you to look at.")
    click.echo(f"{output}" + (f", {len(written) - 1} pages in {feedback}" if feedback else ""))
    return 0
