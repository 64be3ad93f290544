"""`rbpsym certify`: the steps of a problem written for the prover Rocq, and what its compiler says of them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rbpsym.commands.arguments import name_argument, output_option

if TYPE_CHECKING:
    from rbpsym.kernel.certify import Report


@click.command("certify")
@name_argument
@output_option(".", "Folder of the Rocq files.")
def command(name: str, output: Path) -> int:
    """Write each step of a problem as a lemma for Rocq, from its listed premises alone; coqc, if it is there, checks them.

    \b
    Examples:
      rbpsym certify sliding-ladder
      rbpsym certify my-problem.toml -o rocq

    Two files are written: Prelude.v and one named after the problem (coqc needs Coquelicot as well). A step that
    can't be stated or proved is told by name, never assumed.
    """
    from rbpsym.commands.progress import Progress
    from rbpsym.commands.shelf import found
    from rbpsym.derive import derive
    from rbpsym.document.files import write_all
    from rbpsym.kernel.certify import PRELUDE, compiled, text, written
    from rbpsym.kernel.rocq import identifier
    from rbpsym.statement.loader import load_problem

    _, path = found(name, ("problem",))
    with Progress(f"deriving {name}"):
        derivation = derive(load_problem(path), simulation=False)
        done = written(derivation)
    files = {PRELUDE.name: PRELUDE.read_text(encoding="utf-8"), f"{identifier(path.stem).replace(chr(39), '_')}.v": text(done)}
    for file in write_all(output, files):
        click.echo(str(file))
    with Progress("coqc"):
        report = compiled(done)
    later = len(derivation.all_steps) - len(derivation.steps)
    click.echo("\n".join(lines(report, later)))
    return 1 if report.refused or later else 0


def lines(report: Report, later: int) -> Iterator[str]:
    """How many steps are certified, and why the others are not."""
    for id, why in report.refused.items():
        yield f"  {id}: {why}"
    if later:
        yield f"  {later} steps of later phases: not written yet"
    count = f"{report.steps - len(report.refused)} of {report.steps + later} steps"
    if report.axioms is None:
        yield f"{count} written as {report.lemmas} lemmas; nothing is certified: there is no coqc (apt: coq libcoq-coquelicot)"
    else:
        yield f"{count} certified by coqc, {report.lemmas} lemmas in {report.seconds:.0f} s; axioms: {', '.join(report.axioms)}"
