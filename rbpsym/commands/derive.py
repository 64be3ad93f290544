"""`rbpsym derive`: a derivation, readable in the terminal."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import click

from rbpsym.commands.arguments import detail_option, found, name_argument, stated
from rbpsym.commands.certify import lines as told
from rbpsym.commands.certify import report_on
from rbpsym.commands.solve import exit_code, verdict_line

if TYPE_CHECKING:
    from rbpsym.decide.verdict import Verdict
    from rbpsym.document.model import Document
    from rbpsym.kernel.coqc import Report
    from rbpsym.proof.step import Derivation
    from rbpsym.statement.model import Problem

METHODS = ("all", "torque", "newton-euler", "work-energy", "energy")
CHAPTERS = {
    "torque": ("kinematics", "inertia", "momentum", "forces", "motion"),
    "newton-euler": ("kinematics", "inertia", "forces", "reactions"),
    "work-energy": ("kinematics", "inertia", "forces", "work"),
    "energy": ("kinematics", "inertia", "energy"),
}


@click.command("derive")
@name_argument
@detail_option
@click.option("--method", type=click.Choice(METHODS), default="all", show_default=True, help="Only one road.")
@click.option("--lang", metavar="LANGUAGE", default="en", show_default=True, help="Language of the sentences.")
@click.option("--simulation/--no-simulation", default=False, show_default=True, help="Run the numerical oracle too.")
@click.option("--why", metavar="STEP", help="Only what the verdict of one step, (10) or motion.theta say, rests on.")
@click.option("--roads", is_flag=True, help="Only the roads that one may take, with the lines that each needs.")
@click.option("--certified", is_flag=True, help="Mark with ✓ only what Rocq certifies too (takes a while).")
def command(
    name: str, detail: str, method: str, lang: str, simulation: bool, why: str | None, roads: bool, certified: bool
) -> int:
    """Show the derivation of a problem, step by step, each with its verdict.

    \b
    Examples:
      rbpsym derive sliding-ladder
      rbpsym derive rod-and-disk-free --method torque
      rbpsym derive my-problem.toml --detail full
      rbpsym derive sliding-ladder --why 10
      rbpsym derive sliding-ladder --roads

    The mark before a formula says what became of its check: ✓ proved, ✗ refuted, ? undecided; with --certified
    ○ proved, and not certified by Rocq.
    """
    from rbpsym.commands.progress import Progress
    from rbpsym.derive import derive

    _, path = found(name, ("problem",))
    if roads:
        click.echo("\n".join(roads_of(stated(path), lang)))
        return 0
    with Progress(f"deriving {name}"):
        derivation = derive(stated(path), simulation=simulation)
    if why:
        from rbpsym.commands.why import why as traced

        click.echo("\n".join(traced(derivation, why, document_of(derivation, detail, method, lang), lang)))
    else:
        report = report_on(path) if certified else None
        click.echo("\n".join(lines(derivation, detail, method, lang, report)))
    return exit_code(derivation.summary())


def roads_of(problem: Problem, language: str) -> list[str]:
    """The table of roads as lines."""
    from rbpsym.chapters.methods.balances import roads
    from rbpsym.document.model import Document, Paragraph, Section, words
    from rbpsym.document.notes_checks import roads_table
    from rbpsym.document.words import Words
    from rbpsym.document.writers.terminal import terminal_lines
    from rbpsym.mechanics.at_start import study_of

    said, study = Words(language, problem), study_of(problem)
    found = [] if study.at_start or problem.is_at_rest else roads(study)
    block = roads_table(found, said) if found else Paragraph(said.say("roads.nowhere"))
    section = Section(said.say("roads.title"), (block,), "roads", 1)
    document = Document(words(said.title(problem.title)), (section,), language=language, notation=said.notation)
    return list(terminal_lines(document, {}))


def lines(derivation: Derivation, detail: str, method: str, language: str, report: Report | None = None) -> Iterator[str]:
    """The chapters with their steps, then what was proved, and what Rocq says, if it was asked."""
    from rbpsym.document.writers.terminal import terminal_lines

    document = document_of(derivation, detail, method, language)
    found = verdicts(derivation)
    doubtful = [] if report is None else [id for id in found if not report.is_certified(id)]
    yield from terminal_lines(document, found, doubtful)
    yield ""
    yield from reasons(derivation, method, language)
    yield verdict_line(derivation.summary())
    yield from () if report is None else told(report)


def verdicts(derivation: Derivation) -> dict[str, Verdict]:
    """What became of the checks of each step, by the label of its formula."""
    from rbpsym.commands.why import readings

    return {prefix + id: step.certificate.verdict for _, prefix, steps in readings(derivation) for id, step in steps.items()}


def document_of(derivation: Derivation, detail: str, method: str, language: str) -> Document:
    """The chapters of one road, or of all of them, as a document."""
    from rbpsym.document.chapters import chapter_sections
    from rbpsym.document.model import Document, words
    from rbpsym.document.notes import DETAILS, notation_of, phase_words, shown_steps, words_of
    from rbpsym.document.notes_phases import phase_sections

    problem = derivation.study.problem
    said = words_of(derivation, road(derivation, shown_steps(derivation, detail), method), language)
    said = replace(said, level=DETAILS[detail])
    later = phase_sections(derivation, said, 1, phase_words(derivation, detail, language)) if method == "all" else ()
    sections = (*chapter_sections(derivation, said, 1), *later)
    return Document(words(said.title(problem.title)), sections, language=language, notation=notation_of(derivation, language))


def road(derivation: Derivation, shown: frozenset[str], method: str) -> frozenset[str]:
    """Of the shown steps those of one method, up to the equation of motion that it finds."""
    if method == "all":
        return shown
    from rbpsym.document.used import led_to

    own = [step for step in derivation.steps if step.chapter in CHAPTERS[method]]
    ends = led_to(own, [step.id for step in own if step.id.startswith("motion.from_")])
    foreign = {step.id for step in own if method == "energy" and step.id.startswith("split.")}
    return frozenset(({step.id for step in own} & shown | ends) - foreign)


def reasons(derivation: Derivation, method: str, language: str) -> Iterator[str]:
    """Why a method does not apply."""
    from rbpsym.document.notes import notation_of
    from rbpsym.document.notes_checks import left_out
    from rbpsym.document.words import Words
    from rbpsym.document.writers.page import plain_text

    said, notation = Words(language, derivation.study.problem), notation_of(derivation, language)
    for skipped in derivation.skipped:
        if method in ("all", skipped.method):
            yield plain_text(left_out(skipped, said), notation, language)
