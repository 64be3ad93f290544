"""`rbpsym new`: a commented problem or course file to start from."""

from __future__ import annotations

from pathlib import Path

import click

from rbpsym.commands.arguments import ShelfName, found, output_option
from rbpsym.errors import ReadError


@click.command("new")
@click.argument("name")
@click.option(
    "--template", metavar="PROBLEM", type=ShelfName(), help="Begin from a problem that ships; without: a pendulum."
)
@click.option("--course", "is_course", is_flag=True, help="A course: theory, problems and comparisons in their order.")
@output_option(".", "Folder of the new file.")
def command(name: str, template: str | None, is_course: bool, output: Path) -> None:
    """Write NAME.toml, a commented problem file to start from.

    The file is a complete problem that works at once; its comments list every shape,
    interaction and constraint. Change it, and look at what rbpsym makes of it. A file that is
    there already is never overwritten.

    \b
    Examples:
      rbpsym new my-problem
      rbpsym new my-ladder --template sliding-ladder -o problems
      rbpsym derive my-problem.toml
      rbpsym new week-5 --course
    """
    from rbpsym.document.files import write_whole

    if is_course and template:
        raise click.UsageError("--template gives a problem to begin from; a course has none.")
    name = name.removesuffix(".toml")
    text = course_text(name) if is_course else problem_text(name, template)
    path = output / f"{name}.toml"
    if path.exists() or path.is_symlink():
        raise ReadError(f"{path} is there already", instead="choose another name, or remove the file first.")
    click.echo(f"{write_whole(path, text)} is written. Now: rbpsym {'notes' if is_course else 'derive'} {path}")


def course_text(name: str) -> str:
    """The text of a new course file; what it names is taught in the first course that ships."""
    from rbpsym.document.files import data_folder
    from rbpsym.statement.course import load_course
    from rbpsym.statement.library import course_files
    from rbpsym.statement.starter import title_of

    parts = load_course(next(iter(course_files().values()))).parts
    first = {part.kind: part for part in reversed(parts)}
    text = (data_folder("templates") / "course.toml").read_text(encoding="utf-8")
    problem, pair = first["problem"], first["comparison"]
    return text.format(
        name=name, title=title_of(name), problem=problem.name, first=pair.first, second=pair.second, limit=pair.limit
    )


def problem_text(name: str, template: str | None) -> str:
    """The text of the new file, from the starter or from a problem that ships."""
    from rbpsym.statement.starter import starter_text

    text = starter_text(name)  # also refuses a name that can't be
    if template is None:
        return text
    _, path = found(template, ("problem",))
    return f"# {name}: begun from {path.stem}.\n" + path.read_text(encoding="utf-8")
