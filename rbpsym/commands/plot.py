"""`rbpsym plot`: the formulas of a problem as curves, each figure a file of its own."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from rbpsym.commands.arguments import ShelfName, formats_option, found, output_option

if TYPE_CHECKING:
    from rbpsym.expr.glyphs import Notation
    from rbpsym.pictures.figures.scene import Scene

FORMATS = ("svg", "png", "pdf")


@click.command("plot")
@click.argument("name", metavar="NAME|FILE", type=ShelfName())
@formats_option(FORMATS, "svg")
@click.option("--lang", metavar="LANGUAGE", default="en", show_default=True, help="Language of the words in them.")
@output_option(".", "Folder of the files.")
def command(name: str, formats: tuple[str, ...], lang: str, output: Path) -> int:
    """Draw works, energies, speeds, forces and the motion of a problem from its derived formulas.

    \b
    Examples:
      rbpsym plot sliding-ladder -o figures
      rbpsym plot my-problem.toml --format pdf,png

    Numbers have units where the file has an [example], else they are in units made of the problem's own
    quantities. The files are called NAME-works, NAME-energies, NAME-forces;
    where there are more, also NAME-speeds, NAME-positions.
    """
    from rbpsym.document.files import write_all
    from rbpsym.document.pictures import RESOLUTION, drawings

    _, path = found(name, ("problem",))
    drawn = figures_of(path, lang)
    each = ((kind, zip(drawn, drawings(list(drawn.values()), kind, RESOLUTION), strict=True)) for kind in formats)
    for file in write_all(output, {f"{path.stem}-{part}.{kind}": made for kind, parts in each for part, made in parts}):
        click.echo(str(file))
    return 0


def figures_of(path: Path, language: str) -> dict[str, tuple[tuple[Scene, ...], Notation]]:
    """The figures by what they show, as pictures are made of them. Raises StatementError for a motion that can't be drawn."""
    from rbpsym.derive import derive
    from rbpsym.document.notes import notation_of
    from rbpsym.document.notes_plots import plot_figures
    from rbpsym.document.words import Words
    from rbpsym.errors import NotApplicable, StatementError
    from rbpsym.pictures.plots.following import motion
    from rbpsym.pictures.pose import REASONS
    from rbpsym.statement.loader import load_problem

    derivation = derive(load_problem(path), simulation=False)
    notation = notation_of(derivation, language)
    try:
        figures = list(plot_figures(motion(derivation), Words(language, derivation.study.problem)))
    except NotApplicable as error:
        cure = "say where each coordinate starts, and give all numbers under [example]."
        what = f"the motion of “{path.stem}” can't be drawn: {error}"
        raise StatementError(what, instead="" if str(error) == REASONS["statics"] else cure) from None
    return {figure.label.rpartition(".")[2]: (figure.scenes, notation) for figure in figures}
