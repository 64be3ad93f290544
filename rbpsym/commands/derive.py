"""`rbpsym derive`: a derivation, readable in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

import click

from rbpsym.commands.arguments import detail_option, name_argument

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
def command(name: str, detail: str, method: str, lang: str, simulation: bool) -> int:
    """Show the derivation of a problem, step by step, each with its verdict.

    \b
    Examples:
      rbpsym derive sliding-ladder
      rbpsym derive rod-and-disk-free --method torque
      rbpsym derive my-problem.toml --detail full

    The mark before a formula says what became of its check: ✓ proved, ✗ refuted, ? undecided.
    """
    from rbpsym.commands.progress import Progress
    from rbpsym.commands.shelf import found
    from rbpsym.derive import derive
    from rbpsym.statement.loader import load_problem

    _, path = found(name, ("problem",))
    with Progress(f"deriving {name}"):
        derivation = derive(load_problem(path), simulation=simulation)
    click.echo("\n".join(lines(derivation, detail, method, lang)))
    from rbpsym.commands.solve import exit_code

    return exit_code(derivation.summary())


MARKS = {"PROVED": ("✓", "green"), "REFUTED": ("✗", "red"), "UNDECIDED": ("?", "yellow")}


def lines(derivation, detail: str, method: str, language: str) -> Iterator[str]:
    """The chapters with their steps, then what was proved."""
    from rbpsym.commands.solve import verdict_line
    from rbpsym.document.chapters import ORDER
    from rbpsym.document.notes import notation_of, shown_steps
    from rbpsym.document.words import Words

    said = Words(language, derivation.study.problem, "", shown_steps(derivation, detail))
    notation, numbers = notation_of(derivation), {}
    yield click.style(said.title(derivation.study.problem.title), bold=True)
    for chapter in ORDER:
        steps = [s for s in derivation.chapter(chapter) if s.id in said.shown]
        if steps and (method == "all" or chapter in CHAPTERS[method]):
            yield ""
            yield click.style(_plain(said.say(f"section.{chapter}"), notation, numbers), bold=True, underline=True)
            for step in steps:
                yield from step_lines(step, said, notation, numbers)
    yield ""
    yield from (_plain(said.say(s.phrase, **s.slots), notation, numbers) for s in derivation.skipped)
    yield verdict_line(derivation.summary())


def step_lines(step, said, notation, numbers: dict[str, int]) -> Iterator[str]:
    """The sentence of a step, then its formula with verdict and number."""
    from rbpsym.document.chapters import known_key
    from rbpsym.notation.text import to_text

    numbers[step.id] = len(numbers) + 1
    key = known_key(step.phrase, said)
    sentence = _plain(said.say(key, **step.slots), notation, numbers).strip() if key else ""
    if sentence:
        yield f"  {sentence}"
    mark, color = MARKS[str(step.certificate.verdict.kind)]
    for row in to_text(step.statement, notation).splitlines():
        yield f"    {click.style(mark, fg=color)} {click.style(row.strip(), bold=step.is_result)}  ({numbers[step.id]})"
        mark = " "
    if step.certificate.verdict.reason or step.certificate.verdict.witness:
        yield f"      {step.certificate.verdict.reason or step.certificate.verdict.witness}"


def _plain(inlines, notation, numbers: dict[str, int]) -> str:
    """The inlines as text; references by number."""
    from rbpsym.document.model import Ref
    from rbpsym.document.writers.plain_text import plain_text

    return "".join(
        f"({numbers.get(i.label, '…')})" if isinstance(i, Ref) else plain_text((i,), notation) for i in inlines
    )
