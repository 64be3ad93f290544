"""The chapters of a derivation as sections: a sentence that says why, then the formula."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import groupby

from rbpsym.derivation.step import Derivation, Step
from rbpsym.document.model import Block, Display, Paragraph, Section, Text
from rbpsym.document.tables import forces_table, works_blocks
from rbpsym.document.words import Words
from rbpsym.notation import tree as t

ORDER = ("kinematics", "inertia", "momentum", "forces", "motion", "reactions", "work", "energy", "contact", "oscillations")


def chapter_sections(derivation: Derivation, said: Words, level: int) -> Iterator[Section]:
    """One section a chapter, in the order of a lecture; chapters without shown steps are left out."""
    for name in ORDER:
        steps = [step for step in derivation.chapter(name) if step.id in said.shown]
        if steps:
            blocks = [*_intro(name, steps, derivation, said), *BLOCKS.get(name, _by_steps)(steps, derivation, said)]
            yield Section(said.say(f"section.{_title(name, derivation)}"), tuple(blocks), f"{said.prefix}section.{name}", level)


def _title(name: str, derivation: Derivation) -> str:
    """The chapter on contacts is about forces along the motion where none is lost."""
    return "along" if name == "contact" and not derivation.study.losses else name


def _intro(name: str, steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    key = {"motion": "torque", "reactions": "newton_euler"}.get(name, name)
    if said.has(f"{key}.intro") and name not in ("forces", "work"):
        points = [t.Sym(label) for label in derivation.study.origins]
        yield Paragraph(said.say(f"{key}.intro", point=points, points=points))


def _by_steps(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """Sentence and formula in turn; neighbours of the same kind share a sentence if there is one for many."""
    ordered = _gathered(steps) if steps[0].chapter in ("kinematics", "reactions") else [[s] for s in steps]
    for group in ordered:
        yield from _group(group, said)


def _gathered(steps: list[Step]) -> list[list[Step]]:
    """Steps of the same kind brought together, in the order of their first appearance."""
    kinds = list(dict.fromkeys(_kind(step) for step in steps))
    return [[step for step in steps if _kind(step) == kind] for kind in kinds]


def _kind(step: Step) -> str:
    """The kind of a step: its phrase, the three ways to say how a body turns taken together."""
    return "kinematics.turning" if step.phrase.startswith("kinematics.turning") else step.phrase


PLURAL = {
    "kinematics.position": "kinematics.positions", "kinematics.velocity": "kinematics.velocities",
    "kinematics.speed": "kinematics.speeds", "kinematics.turning": "kinematics.turning.many",
    "newton_euler.reaction": "newton_euler.reactions",
}


def _group(group: list[Step], said: Words) -> Iterator[Block]:
    plural = PLURAL.get(_kind(group[0]))
    if len(group) > 1 and plural:
        yield Paragraph(said.say(plural))
        for step in group:
            yield display(step, said)
        return
    for step in group:
        yield from said_step(step, said)


def said_step(step: Step, said: Words) -> Iterator[Block]:
    """The sentence of a step and its formula."""
    key = known_key(step.phrase, said)
    if key is not None:
        text = said.say(key, **step.slots)
        if any(not isinstance(i, Text) or i.text.strip() for i in text):
            yield Paragraph(text)
    yield display(step, said)


def known_key(key: str, said: Words) -> str | None:
    """The key, or that of “other” of its kind; None where nothing is said."""
    if said.has(key):
        return key
    other = key.rsplit(".", 1)[0] + ".other"
    return other if said.has(other) else None


def display(step: Step, said: Words) -> Display:
    """The formula of a step, numbered, boxed if it is a result."""
    return Display(step.statement, said.prefix + step.id, True, step.is_result)


def _forces(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    points = [t.Sym(label) for label in derivation.study.origins]
    yield Paragraph(said.say("forces.intro", points=points))
    yield forces_table(steps, derivation, said)


def _work(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    yield from works_blocks(steps, said, said_step)


def _oscillations(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """An unstable place is told in a sentence; its formulas follow only in full detail."""
    for _, group in groupby(steps, key=lambda s: s.id.split(".")[1]):
        items = list(group)
        for step in items:
            yield from said_step(step, said)


BLOCKS: Mapping[str, Callable[[list[Step], Derivation, Words], Iterator[Block]]] = {
    "forces": _forces, "work": _work, "oscillations": _oscillations,
}
