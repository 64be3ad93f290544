"""`rbpsym certify`: the steps of a problem written for the prover Rocq, and what its compiler says of them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rbpsym.commands.arguments import FOLDER, ShelfName, found
from rbpsym.commands.progress import Progress

if TYPE_CHECKING:
    from rbpsym.ask.found import Answer
    from rbpsym.kernel.coqc import Report

USUAL = Path("build", "rocq")
THEORY = "theory"


@click.command("certify")
@click.argument("names", metavar="[NAME|FILE]...", type=ShelfName("problem"), nargs=-1)
@click.option("--all", "every", is_flag=True, help="Every problem that ships.")
@click.option("--output", "-o", type=FOLDER, help="Folder of the files (build/rocq).")
@click.option("--coqchk", "check", is_flag=True, help="Have coqchk check what coqc compiled (takes longer).")
@click.option("--no-cache", is_flag=True, help="Compile everything anew.")
def command(names: tuple[str, ...], every: bool, output: Path | None, check: bool, no_cache: bool) -> int:
    """Write each step of problems as a lemma for Rocq, from its listed premises alone; coqc, if it is there, checks them.

    \b
    Examples:
      rbpsym certify sliding-ladder
      rbpsym certify my-problem.toml -o rocq
      rbpsym certify theory
      rbpsym certify --all

    Prelude.v is written, and a file for each phase, named after the problem (coqc needs Coquelicot as well). A step that
    can't be stated or proved is told by name, never assumed. What coqc said of the same text before is kept. “theory” is
    the general theory of plane motion, for any body; Particles.v shows that what is assumed of a body holds for some.

    \b
    Exit codes: 0 every step is certified (of several problems: coqc accepts all that is
    written), 1 not.
    """
    from rbpsym.claims.run import default_folder
    from rbpsym.statement.library import problem_files

    if every == bool(names):
        raise click.UsageError("name a problem, or write --all for every problem that ships.")
    paths = list(problem_files().values()) if every else [found(name, ("problem",))[1] for name in names if name != THEORY]
    folder, each, many = None if no_cache else default_folder(), [], every or len(names) > 1
    for path in paths:
        each.append(certified(path, output if many else output or USUAL, folder, check=check))
        click.echo("\n".join(lines(each[-1], f"{path.stem}: " if many else "")))
    if THEORY in names:
        each.append(_theory(output if many else output or USUAL, folder, check=check))
        click.echo("\n".join(lines(each[-1], f"{THEORY}: " if many else "")))
    is_whole = all(report.is_sound for report in each) and (many or not each[0].refused)
    return 0 if is_whole else 1


def _theory(output: Path | None, folder: Path | None, *, check: bool) -> Report:
    """The report on the general theory."""
    from rbpsym.chapters.theory import plane_motion
    from rbpsym.document.files import write_all
    from rbpsym.kernel.coqc import BODY, MODEL, PRELUDE, compiled
    from rbpsym.kernel.theory import Theory

    with Progress("deriving the theory"):
        done = Theory(plane_motion())
    texts = {path.name: path.read_text(encoding="utf-8") for path in (PRELUDE, BODY, MODEL)}
    for file in write_all(output, {**texts, "theory.v": done.text()}) if output is not None else ():
        click.echo(str(file))
    with Progress("coqc"):
        return compiled(done, folder, check=check)


def report_on(path: Path) -> Report:
    """The report on a problem, kept where others are."""
    from rbpsym.claims.run import default_folder

    return certified(path, None, default_folder())


def report_on_answer(found: Answer) -> Report:
    """The report on the steps of an answer; one that stands in none of its derivations, as what is concluded, has no lemma."""
    from rbpsym.claims.run import default_folder
    from rbpsym.frozen import replace
    from rbpsym.kernel.certify import written
    from rbpsym.kernel.coqc import compiled, together

    told = together(("", compiled(written(own), default_folder())) for own in found.derivations)
    stated = {step.statement for own in found.derivations for step in own.steps}
    steps = (*found.steps, *([] if found.conclusion is None else [found.conclusion]))
    refused = {step.id: "what is concluded has no words yet" for step in steps if step.statement not in stated}
    return replace(told, steps=told.steps + len(refused), refused=told.refused | refused)


def certified(path: Path, output: Path | None, folder: Path | None, *, check: bool = False) -> Report:
    """The report on a problem; its files are written if there is an `output`. What was found before stands in `folder`."""
    from rbpsym.claims.run import digest, engine
    from rbpsym.derive import derive
    from rbpsym.document.files import write_all
    from rbpsym.kernel.begins import parts
    from rbpsym.kernel.certify import text, written
    from rbpsym.kernel.coqc import PRELUDE, compiled, reported, together
    from rbpsym.kernel.rocq import identifier
    from rbpsym.statement.loader import load_problem

    def found() -> Report:
        with Progress(f"deriving {path.stem}"):
            derivation = derive(load_problem(path), simulation=False)
            each = [(part, word, written(own)) for part, word, own in parts(derivation)]
        stem = identifier(path.stem).replace(chr(39), "_")
        texts = {f"{stem}{word}.v": text(done) for _, word, done in each}
        prelude = {PRELUDE.name: PRELUDE.read_text(encoding="utf-8")}
        for file in write_all(output, {**prelude, **texts}) if output is not None else ():
            click.echo(str(file))
        with Progress("coqc"):
            return together((part, compiled(done, folder, check=check)) for part, _, done in each)

    if output is not None:
        return found()
    return reported(folder, digest(engine(), PRELUDE.read_bytes(), path.read_bytes(), str(check)), found)


def lines(report: Report, name: str = "") -> Iterator[str]:
    """How many steps are certified, and why the others are not."""
    for id, why in report.refused.items():
        yield f"  {id}: {why}"
    count = f"{name}{report.steps - len(report.refused)} of {report.steps} steps"
    if report.axioms is None:
        yield f"{count} written as {report.lemmas} lemmas; nothing is certified: there is no coqc (apt: coq libcoq-coquelicot)"
    else:
        told = {None: "", True: "; coqchk agrees", False: "; coqchk does not agree"}[report.checked]
        axioms = ", ".join(report.axioms)
        yield f"{count} certified by coqc, {report.lemmas} lemmas in {report.seconds:.0f} s; axioms: {axioms}{told}"
