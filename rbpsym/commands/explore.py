"""`rbpsym explore`: a page in which a problem, or two side by side, can be set in motion."""

from __future__ import annotations

from pathlib import Path

import click

from rbpsym.commands.arguments import ShelfName, found, name_argument, output_option


@click.command("explore")
@name_argument
@click.argument("other", metavar="[OTHER]", type=ShelfName(), required=False)
@click.option("--lang", metavar="LANGUAGE", default="en", show_default=True, help="Language of the page.")
@output_option(".", "Folder of the file.")
def command(name: str, other: str | None, lang: str, output: Path) -> int:
    """Write a page in which the system moves: its forces, their works, its energies and momenta.

    \b
    Examples:
      rbpsym explore sliding-ladder
      rbpsym explore rod-and-disk-fixed rod-and-disk-free -o build

    One HTML file without a network: the motion is computed in the browser from the derived
    accelerations and forces. OTHER is a second problem, started together with the first.
    """
    from rbpsym.commands.progress import Progress
    from rbpsym.document.files import write_whole
    from rbpsym.explorer.page import explorer
    from rbpsym.statement.loader import load_problem

    paths = [found(wanted, ("problem",))[1] for wanted in (name, other) if wanted]
    with Progress("deriving " + " and ".join(path.stem for path in paths)):
        page = explorer(tuple(map(load_problem, paths)), lang)
    click.echo(str(write_whole(output / f"{'-and-'.join(path.stem for path in paths)}-explorer.html", page)))
    return 0
