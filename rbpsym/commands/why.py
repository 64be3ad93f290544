"""`rbpsym derive NAME --why STEP`: what a verdict rests on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from time import perf_counter

import click

from rbpsym.document.model import Display, Document, numbered, parts
from rbpsym.document.notes import notation_of
from rbpsym.document.writers.terminal import MARKS
from rbpsym.errors import ReadError
from rbpsym.expr.glyphs import Notation
from rbpsym.proof.step import Derivation, Step
from rbpsym.statement.source import did_you_mean
from rbpsym.typeset.text import to_text

# how the id of a fact begins -> what it says
FACTS: Mapping[str, str] = {
    "law.motion": "Newton's and Euler's equations of all bodies, with the conditions of the constraints",
    "law.force.": "Newton's second law for {}",
    "law.torque.": "Euler's equation for {} about its centre of mass",
    "law.blow.": "how the blow changes the momentum and the spin of {}",
    "law.parting.": "how fast what meets parts along {}",
    "law.tied": "what ties the speeds just after",
    "start.": "value and speed of {} at the start, as stated",
    "range.": "the declared range of {}",
    "shape.": "how the mass of {} is spread",
    "def.": "what {} stands for",
}


def why(derivation: Derivation, wanted: str, document: Document, language: str) -> Iterator[str]:
    """The lines that trace a step, by its id or by its number in the document: formula, verdict, checks, premises."""
    marks = marks_of(document)
    id = next((id for id, mark in marks.items() if mark.strip("()") == wanted.strip("()")), wanted)
    for part, prefix, steps in readings(derivation):
        if id.removeprefix(prefix) in steps:
            own = {name.removeprefix(prefix): mark for name, mark in marks.items()}
            yield from traced(part, steps, steps[id.removeprefix(prefix)], own, notation_of(part, language))
            return
    known = [prefix + name for _, prefix, steps in readings(derivation) for name in steps]
    instead = did_you_mean(wanted, known, "steps")
    raise ReadError(f"“{wanted}” is neither a number nor a step of this derivation", instead=instead)


def readings(derivation: Derivation) -> Iterator[tuple[Derivation, str, Mapping[str, Step]]]:
    """The first phase and each later one: its derivation, what stands before the ids of its steps, its steps by id."""
    yield derivation, "", {step.id: step for step in derivation.steps}
    for number, phase in enumerate(derivation.phases, 2):
        steps = (*phase.begins, *phase.derivation.steps)
        yield phase.derivation, f"phase{number}.", {step.id: step for step in steps}


def marks_of(document: Document) -> dict[str, str]:
    """Printed numbers by the id of the step."""
    blocks = (block for section in numbered(document).sections for block in parts(section.blocks))
    return {block.label: block.mark for block in blocks if isinstance(block, Display) and block.mark}


def traced(
    derivation: Derivation, steps: Mapping[str, Step], step: Step, marks: Mapping[str, str], notation: Notation
) -> Iterator[str]:
    """The lines for one step."""
    verdict, checks = step.certificate.verdict, step.certificate.checks
    sign, colour = MARKS[verdict.kind]
    yield f"{click.style(step.id, bold=True)} {marks.get(step.id, '')}"
    yield f"  {one_line(step, notation)}"
    reason = f": {verdict.reason}" if verdict.reason else ""
    yield f"  {click.style(sign, fg=colour)} {verdict.kind}{reason}, by the rule “{step.rule}”{anew(derivation, step)}"
    yield f"  checks: {', '.join(checks)}"
    for title, ids in (("premises", step.premises), ("told beside them", step.cites)):
        yield from [f"  {title}", *(f"    {premise(steps, id, marks, notation)}" for id in ids)] if ids else ()
    for duty in verdict.obligations:
        holds = f"which holds: {duty.why}" if duty.is_discharged else "a condition that is printed"
        yield f"  needs {to_text(duty.relation, notation)}, {holds}"


def anew(derivation: Derivation, step: Step) -> str:
    """How long its checks take with all letters known; nothing for a step between two phases."""
    from rbpsym.proof.rules import certify

    if derivation.letters.steps.get(step.id) is not step:
        return ""
    began = perf_counter()
    certify(derivation.letters, step)
    return f" in {1000 * (perf_counter() - began):.1f} ms"


def premise(steps: Mapping[str, Step], id: str, marks: Mapping[str, str], notation: Notation) -> str:
    """A premise: a step with its formula, or a fact with what it says."""
    if id in steps:
        return f"{id} {marks.get(id, '')}  {one_line(steps[id], notation)}"
    begins = next(begin for begin in FACTS if id.startswith(begin))
    return f"{id}  {FACTS[begins].format(id.removeprefix(begins))}"


def one_line(step: Step, notation: Notation) -> str:
    """What a step asserts; several rows one behind the other."""
    return "; ".join(row.strip() for row in to_text(step.statement, notation).splitlines())
