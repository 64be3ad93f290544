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

    Prelude.v is written, and a file for each phase, named after the problem (coqc needs Coquelicot as well). A step that
    can't be stated or proved is told by name, never assumed.
    """
    from rbpsym.commands.progress import Progress
    from rbpsym.commands.shelf import found
    from rbpsym.derive import derive
    from rbpsym.document.files import write_all
    from rbpsym.kernel.begins import parts
    from rbpsym.kernel.certify import PRELUDE, compiled, text, together, written
    from rbpsym.kernel.rocq import identifier
    from rbpsym.statement.loader import load_problem

    _, path = found(name, ("problem",))
    with Progress(f"deriving {name}"):
        derivation = derive(load_problem(path), simulation=False)
        each = [(part, word, written(own)) for part, word, own in parts(derivation)]
    stem = identifier(path.stem).replace(chr(39), "_")
    texts = {f"{stem}{word}.v": text(done) for _, word, done in each}
    for file in write_all(output, {PRELUDE.name: PRELUDE.read_text(encoding="utf-8"), **texts}):
        click.echo(str(file))
    with Progress("coqc"):
        report = together((part, compiled(done)) for part, _, done in each)
    click.echo("\n".join(lines(report)))
    return 1 if report.refused else 0


def lines(report: Report) -> Iterator[str]:
    """How many steps are certified, and why the others are not."""
    for id, why in report.refused.items():
        yield f"  {id}: {why}"
    count = f"{report.steps - len(report.refused)} of {report.steps} steps"
    if report.axioms is None:
        yield f"{count} written as {report.lemmas} lemmas; nothing is certified: there is no coqc (apt: coq libcoq-coquelicot)"
    else:
        yield f"{count} certified by coqc, {report.lemmas} lemmas in {report.seconds:.0f} s; axioms: {', '.join(report.axioms)}"
