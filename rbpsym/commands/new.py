"""`rbpsym new`: a commented problem file to start from."""

from __future__ import annotations

from pathlib import Path

import click

from rbpsym.commands.arguments import ShelfName, output_option
from rbpsym.errors import ReadError


@click.command("new")
@click.argument("name")
@click.option(
    "--template", metavar="PROBLEM", type=ShelfName(), help="Begin from a problem that ships; without: a pendulum."
)
@output_option(".", "Folder of the new file.")
def command(name: str, template: str | None, output: Path) -> None:
    """Write NAME.toml, a commented problem file to start from.

    The file is a complete problem that works at once; its comments list every shape,
    interaction and constraint. Change it, and look at what rbpsym makes of it. A file that is
    there already is never overwritten.

    \b
    Examples:
      rbpsym new my-problem
      rbpsym new my-ladder --template sliding-ladder -o problems
      rbpsym derive my-problem.toml
    """
    name = name.removesuffix(".toml")
    text = problem_text(name, template)
    path = written(output / f"{name}.toml", text)
    click.echo(f"{path} is written. Now: rbpsym derive {path}")


def problem_text(name: str, template: str | None) -> str:
    """The text of the new file, from the starter or from a problem that ships."""
    from rbpsym.commands.shelf import found
    from rbpsym.statement.starter import starter_text

    text = starter_text(name)  # also refuses a name that can't be
    if template is None:
        return text
    _, path = found(template, ("problem",))
    return f"# {name}: begun from {path.stem}.\n" + path.read_text(encoding="utf-8")


def written(path: Path, text: str) -> Path:
    """Write a file that must not be there yet."""
    from rbpsym.document.files import write_whole

    if path.exists() or path.is_symlink():
        raise ReadError(f"{path} is there already", instead="choose another name, or remove the file first.")
    return write_whole(path, text)
