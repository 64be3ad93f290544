"""`rbpsym plot`: the formulas of a problem as curves, each figure a file of its own."""

from __future__ import annotations

from pathlib import Path

import click

from rbpsym.commands.arguments import ShelfName, formats_option, output_option

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
    from rbpsym.commands.shelf import found
    from rbpsym.derive import derive
    from rbpsym.document.files import write_all
    from rbpsym.document.moving import REASONS
    from rbpsym.document.notes import notation_of
    from rbpsym.document.notes_plots import plot_figures
    from rbpsym.document.pictures import RESOLUTION, drawings
    from rbpsym.document.plots.motion import motion
    from rbpsym.document.words import Words
    from rbpsym.errors import NotApplicable, StatementError
    from rbpsym.statement.loader import load_problem

    _, path = found(name, ("problem",))
    derivation = derive(load_problem(path), simulation=False)
    try:
        figures = list(plot_figures(motion(derivation), Words(lang, derivation.study.problem)))
    except NotApplicable as error:
        raise StatementError(
            f"the motion of “{path.stem}” can't be drawn: {error}",
            instead=""
            if str(error) == REASONS["statics"]
            else "say where each coordinate starts, and give all numbers under [example].",
        ) from None
    notation = notation_of(derivation, lang)
    groups = [(figure.scenes, notation) for figure in figures]
    names = [figure.label.rpartition(".")[2] for figure in figures]
    made = {
        f"{path.stem}-{part}.{kind}": content
        for kind in formats
        for part, content in zip(names, drawings(groups, kind, RESOLUTION), strict=True)
    }
    for file in write_all(output, made):
        click.echo(str(file))
    return 0
