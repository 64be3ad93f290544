"""`rbpsym check`: derivations, claims and papers decided, formula by formula."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rbpsym.commands.arguments import FILE, FOLDER, ShelfName
from rbpsym.commands.progress import Progress
from rbpsym.frozen import Frozen, field

if TYPE_CHECKING:
    from rbpsym.claims.model import Link, Result
    from rbpsym.claims.run import Certificates
    from rbpsym.decide.verdict import Verdict
    from rbpsym.kernel.claimed import Notary
    from rbpsym.proof.step import Derivation

FINE, DOUBTFUL, BAD_INPUT = 0, 1, 2
Names = tuple[str, ...]


class CheckRun(Frozen):
    """What a run found: results in order, and remarks on labels of a text."""

    results: list[Result] = field(default_factory=list)
    remarks: list[tuple[str, int, str]] = field(default_factory=list)

    @property
    def exit_code(self) -> int:
        """2 if something could not be read, 1 if a verdict is not as expected or nothing was decided, else 0."""
        if any(str(result.outcome) == "COULD NOT BE READ" and not result.known for result in self.results):
            return BAD_INPUT
        return FINE if self.is_decided and all(result.expected for result in self.results) else DOUBTFUL

    @property
    def is_decided(self) -> bool:
        """Was anything decided, or does each claim say that nothing can be?"""
        idle = [result for result in self.results if str(result.outcome) == "NOT A FORMULA WE COMPUTE"]
        return len(idle) < len(self.results) or (bool(idle) and all(result.declared[0] for result in idle))


@click.command("check")
@click.argument("names", metavar="[NAME|FILE]...", nargs=-1, type=ShelfName())
@click.option(
    "--problems",
    metavar="FILE",
    multiple=True,
    type=ShelfName(),
    help="Claims or problems that bind a paper's symbols.",
)
@click.option("--all", "every", is_flag=True, help="Judge a paper's formulas that nobody claimed too.")
@click.option("--init", is_flag=True, help="Print a first draft of a paper's comments, as a diff.")
@click.option("--fix", metavar="FILE", type=FILE, help="Write a diff that repairs the formulas whose one fault is known.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON, for programs.")
@click.option("--junit", metavar="FILE", type=FILE, help="Write a JUnit report.")
@click.option("--html", metavar="FILE", type=FILE, help="Write a page for people.")
@click.option("--sarif", metavar="FILE", type=FILE, help="Write SARIF 2.1.0, for programs that show findings.")
@click.option("--baseline", metavar="FILE", type=FILE, help="Findings that are known, and no fault of this run.")
@click.option("--write-baseline", "anew", is_flag=True, help="Write what is found now to the file of --baseline.")
@click.option("--compare", metavar="OLD NEW", type=FILE, nargs=2, help="Tell what differs in two baselines or --json files.")
@click.option("--github", is_flag=True, help="Print annotations for GitHub's pages too.")
@click.option("--only", metavar="WORD", default="", help="Only formulas whose id, number, label or erratum is this.")
@click.option("--failures", is_flag=True, help="Show only what is not as expected.")
@click.option("--cache", metavar="FOLDER", type=FOLDER, help="Where certificates are kept.")
@click.option("--no-cache", is_flag=True, help="Decide everything anew.")
@click.option("--certify", is_flag=True, help="Have Rocq prove what is proved once more, where coqc is installed.")
@click.option("--simulation/--no-simulation", default=False, help="Run the numerical oracle of derivations too.")
def command(
    names: Names, init: bool, baseline: Path | None, anew: bool, compare: tuple[Path, Path] | None, cache: Path | None,
    no_cache: bool, **how: Any,
) -> int:  # fmt: skip
    """Decide formulas: PROVED, REFUTED with a witness, UNDECIDED, or not a formula we compute.

    \b
    Examples:
      rbpsym check                                    all that ships
      rbpsym check my-problem.toml my-claims.toml     problems and claims of your own
      rbpsym check book.tex notes.md lab.ipynb        papers with claims in comments (% rbpsym: claim)
      rbpsym check --init book.tex                    a first draft of these comments
      rbpsym check book.tex --fix repairs.patch       what would make refuted formulas true
      rbpsym check --compare old.json new.json        what differs between two runs, or two versions
      rbpsym check PAPER.tex --problems claims.toml   a paper, with its symbols bound by claims
      rbpsym check PAPER.tex --problems claims.toml --html report.html --junit report.xml --github

    A problem is derived, and every step must be proved. A claims file says what the printed
    symbols mean, and so do comments in a paper (LaTeX, Markdown, RST, HTML, notebooks), which is
    walked in order. Where a formula is refuted, the change that would make it true is told if it
    is a small one. With --certify each formula that is proved is told to be certified by Rocq,
    from the laws, the start and the ranges alone, or why it is not (as each step of a derivation).

    \b
    Exit codes: 0 all as expected, 1 a verdict differs or nothing was decided,
    2 something could not be read.
    """
    from rbpsym.claims.run import default_folder
    from rbpsym.commands import findings, patches

    if anew and not baseline:
        raise click.UsageError("--write-baseline belongs to --baseline FILE.")
    if compare:
        told, worse = findings.compared(*compare)
        click.echo(told, nl=False)
        return DOUBTFUL if worse else FINE
    if init:
        click.echo("".join(patches.draft_of(Path(name)) for name in names), nl=False)
        return FINE
    found = decided(names, None if no_cache else cache or default_folder(), **how)
    if baseline:
        found = findings.without_known(found, baseline, anew)
    tell(found, **how)
    return found.exit_code


def decided(
    names: Names, folder: Path | None, *, problems: Names, every: bool, only: str, certify: bool, simulation: bool,
    html: Path | None, **how: Any,
) -> CheckRun:  # fmt: skip
    """What all arguments give, as far as it is asked for; with what Rocq says of it, if that is asked."""
    from rbpsym.claims.run import Certificates
    from rbpsym.kernel.claimed import Notary

    notary = Notary(folder) if certify else None
    certificates = Certificates.opened(folder, draws=html is not None, notary=notary)
    with Progress("check") as progress:
        found = everything(names, problems, certificates, simulation, progress, every)
    certificates.store()
    found = selected(found, only)
    if notary is None:
        return found
    with Progress("coqc"):
        return certified(found, notary)


def tell(
    found: CheckRun, *, failures: bool, as_json: bool, fix: Path | None, junit: Path | None, html: Path | None,
    sarif: Path | None, github: bool, **how: Any,
) -> None:  # fmt: skip
    """Print what was found, and write the reports that are asked for, each whole."""
    from rbpsym.commands import findings, patches, reports
    from rbpsym.document.files import write_whole

    click.echo((reports.as_json if as_json else reports.as_table)(found, failures), nl=False)
    writers = (
        (fix, lambda run: patches.repairs(run.results)), (junit, reports.as_junit), (html, reports.as_html),
        (sarif, findings.as_sarif),
    )  # fmt: skip
    for path, write in writers:
        if path:
            write_whole(path, write(found))
    if github:
        click.echo(reports.as_annotations(found), nl=False)


def certified(found: CheckRun, notary: Notary) -> CheckRun:
    """The results with what Rocq says of those that are proved."""
    from rbpsym.claims.model import Outcome
    from rbpsym.commands.certify import certified as report_on
    from rbpsym.kernel.claimed import judged

    each = [
        replace(one, rocq=judged(report_on(Path(one.file), None, notary.folder)))
        if one.kind == "derivation" and one.outcome is Outcome.PROVED else one
        for one in found.results
    ]  # fmt: skip
    return CheckRun(notary.settled(each), found.remarks)


def selected(found: CheckRun, word: str) -> CheckRun:
    """Only the results of one id, number or label."""
    if not word:
        return found
    kept = [result for result in found.results if word in (result.id, result.number, result.label, result.erratum)]
    if not kept:
        raise click.UsageError(f"nothing here is called “{word}”.")
    return CheckRun(kept, found.remarks)


def everything(
    names: Names, problems: Names, certificates: Certificates, simulation: bool, progress: Progress, every: bool = False
) -> CheckRun:
    """What all arguments give; without arguments, all that ships."""
    from rbpsym.claims.papers.formats import TEXTS
    from rbpsym.statement.library import problem_files

    texts = [name for name in names if Path(name).suffix.lower() in TEXTS]
    if problems and not texts:
        raise click.UsageError("--problems belongs to a paper: rbpsym check PAPER.tex --problems FILE")
    found = CheckRun()
    for name in texts:
        progress.step(name)
        one = paper(Path(name), problems, certificates, every)
        found.results.extend(one.results)
        found.remarks.extend(one.remarks)
    given = [name for name in names if name not in texts]
    paths = [path for name in given for path in files_of(name)]
    for path in paths if given or texts else (*problem_files().values(), *claims_files()):
        progress.step(path.stem)
        found.results.extend(of_file(path, certificates, simulation))
    return found


def claims_files() -> list[Path]:
    """The claims files that ship."""
    from rbpsym.statement.library import library_folder

    return sorted((library_folder() / "claims").glob("*.toml"))


def of_file(path: Path, certificates: Certificates, simulation: bool) -> Iterator[Result]:
    """The results of a claims file, or of a problem's derivation."""
    from rbpsym.claims.loader import is_claims, load_claims
    from rbpsym.claims.run import check_claims

    if is_claims(path):
        yield from check_claims(load_claims(path), certificates)
    else:
        yield derivation(path, certificates, simulation)


def files_of(name: str) -> list[Path]:
    """The file of this path, or the problem and the claims of this name in the library. Raises ReadError."""
    from rbpsym.statement.library import find_problem, problem_files

    path = Path(name)
    if path.is_file():
        return [path]
    claims = [one for one in claims_files() if one.stem == name]
    if not claims:
        return [find_problem(name)]
    return [*([problem_files()[name]] if name in problem_files() else []), *claims]


def paper(path: Path, problems: Names, certificates: Certificates, every: bool = False) -> CheckRun:
    """A paper, its symbols bound by its comments, by claims files or, without any, by the names of problems."""
    from rbpsym.claims.loader import is_claims, load_claims
    from rbpsym.claims.run import check_paper, names_of_problem

    paths = [one for name in problems for one in files_of(name)[-1:]]
    files = [load_claims(one, binds=True) if is_claims(one) else names_of_problem(one) for one in paths]
    results, remarks = check_paper(path, files, certificates, everything=every)
    if not (problems or results):
        what = f"{path.name} claims nothing: write “% rbpsym: problem = NAME” and “% rbpsym: claim” into it, or add --problems."
        raise click.UsageError(what)
    return CheckRun(results, remarks)


def derivation(path: Path, certificates: Certificates, simulation: bool) -> Result:
    """A problem derived: PROVED if every step is, and all methods and Lagrange's equations agree."""
    from rbpsym.claims.run import digest

    key = digest(certificates.engine, "derivation", str(simulation), path.read_bytes()) if certificates.folder else ""
    known = certificates.get(key)
    if known is not None:
        return known
    found = derived(path, simulation)
    certificates.put(key, found)
    return found


def derived(path: Path, simulation: bool) -> Result:
    """The result of a derivation that is made now."""
    import time

    from rbpsym.claims.model import Outcome, Result, worst
    from rbpsym.derive import derive
    from rbpsym.statement.loader import load_problem

    begun = time.perf_counter()
    made = derive(load_problem(path), simulation=simulation)
    outcomes = [Outcome(str(verdict.kind)) for verdict in verdicts(made)]
    summary = made.summary()
    outcome = worst(outcomes)
    detail = f"{summary['proved']} of {summary['steps']} steps proved; Lagrange: {summary['lagrange']}"
    return Result(
        f"derivation: {made.study.problem.name}",
        "",
        "",
        0,
        str(path),
        "",
        outcome,
        outcome is Outcome.PROVED,
        links=tuple(doubtful(made)),
        detail=detail,
        says=made.study.problem.title.get("en", ""),
        seconds=time.perf_counter() - begun,
        kind="derivation",
        declared=(str(path), 1),
    )


def verdicts(made: Derivation) -> list[Verdict]:
    """The verdicts on all steps and on the independent roads, in every phase."""
    parts = (made, *(phase.derivation for phase in made.phases))
    roads = [road for part in parts for road in (*part.agreement.values(), part.lagrange) if road is not None]
    return [*(step.certificate.verdict for step in made.all_steps), *roads]


def doubtful(made: Derivation) -> Iterator[Link]:
    """The steps that are not proved, as links."""
    from rbpsym.claims.model import Link, Outcome
    from rbpsym.typeset.text import to_text

    for step in made.all_steps:
        verdict = step.certificate.verdict
        if not verdict.is_proved:
            yield Link(to_text(step.statement), Outcome(str(verdict.kind)), detail=f"{step.id}: {verdict}")
