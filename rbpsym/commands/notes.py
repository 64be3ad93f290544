"""`rbpsym notes`: lecture notes of a problem, a course or the whole library, in one or several formats."""

from __future__ import annotations

from typing import Any

import click

from rbpsym.commands.arguments import ShelfName, detail_option, formats_option, found, output_option

FORMATS = ("pdf", "html", "tex", "beamer", "ipynb", "md", "docx", "typ")
ENGINES = ("typst", "pdflatex")


@click.command("notes")
@click.argument("name", metavar="NAME|FILE", type=ShelfName(), required=False)
@click.option("--all", "is_all", is_flag=True, help="The whole library: a book and a site.")
@formats_option(FORMATS, "pdf,html,tex")
@click.option("--engine", type=click.Choice(ENGINES), default="typst", show_default=True, help="What makes the PDF.")
@click.option("--lang", "language", metavar="LANGUAGE", default="en", show_default=True, help="Language of the notes.")
@detail_option
@click.option("--plots/--no-plots", default=True, show_default=True, help="Works, energies, speeds, forces, motion.")
@click.option("--studio", metavar="ADDRESS", default="", help="Of a studio: a QR code leads to each problem there.")
@click.option("--simulation/--no-simulation", default=None, help="Run the numerical oracle too (not by --watch).")
@click.option("--watch", "is_watched", is_flag=True, help="Write again at each change, until Ctrl-C.")
@output_option(".", "Folder of the files.")
def command(name: str | None, is_all: bool, simulation: bool | None, is_watched: bool, **told: Any) -> int:
    """Write lecture notes of a problem or a course: every step derived, with its reason.

    \b
    Examples:
      rbpsym notes paper
      rbpsym notes sliding-ladder --format pdf -o build
      rbpsym notes my-problem.toml --format tex,html --detail full
      rbpsym notes paper --engine pdflatex
      rbpsym notes sliding-ladder --format beamer,ipynb,docx
      rbpsym notes my-problem.toml --watch
      rbpsym notes --all -o library

    The files are called as the problem or course, slides NAME-slides; the drawings of Markdown lie
    beside it. All of them are written whole or not at all. Word needs pip install 'rbpsym[docx]',
    --studio (of a problem or a course) 'rbpsym[qr]'.
    With --all, each format but HTML is one book, and HTML a site that begins at index.html.
    """
    from rbpsym.commands.written import NotesWish, library, once, watched

    wish = NotesWish(simulation=not is_watched if simulation is None else simulation, **told)
    if is_all:
        return library(name, is_watched, wish)
    if name is None:
        raise click.UsageError("say which problem or course: rbpsym notes NAME; “rbpsym list” names them.")
    kind, path = found(name)
    return watched(kind, path, wish) if is_watched else once(kind, path, wish)
