"""The later phases of a motion as sections: how each begins, and what then happens."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from rbpsym.derivation.step import Derivation, DerivedPhase, Step
from rbpsym.document.chapters import chapter_sections
from rbpsym.document.model import Block, Paragraph, Section
from rbpsym.document.telling import Teller, by_kind
from rbpsym.document.words import Words

CHAPTERS = ("kinematics", "motion", "energy", "contact", "oscillations")  # of a later phase: what is new in it
NEW: dict[str, Callable[[Step], bool]] = {
    "kinematics": lambda step: step.rule in ("constraint", "no_slip", "taut", "tied"),
    "energy": lambda step: step.rule in ("conservation", "first_integral"),
}
Speaker = Callable[[Derivation, str], Words]


def phase_sections(derivation: Derivation, said: Words, level: int, speaker: Speaker) -> Iterator[Section]:
    """A section for each later phase with those of its chapters below it.

    `speaker` gives the words for the derivation of a phase whose labels have a prefix.
    """
    for number, phase in enumerate(derivation.phases, 2):
        prefix = f"{said.prefix}phase{number}."
        own = speaker(phase.derivation, prefix)
        begins = _begins(phase, begin_words(phase, said, prefix))
        title = said.say("phases.title", number=number, name=said.named(phase.name))
        yield Section(title, tuple(begins), prefix + "section", level)
        yield from chapter_sections(phase.derivation, own, level + 1, CHAPTERS)


def begin_words(phase: DerivedPhase, said: Words, prefix: str) -> Words:
    """How the steps by which a phase begins are spoken of."""
    return replace(said, prefix=prefix, shown=frozenset(step.id for step in phase.begins), same={})


def phase_results(derivation: Derivation, said: Words, speaker: Speaker) -> Iterator[tuple[Words, tuple[Step, ...]]]:
    """The steps of the later phases, with the words that know their labels."""
    for number, phase in enumerate(derivation.phases, 2):
        prefix = f"{said.prefix}phase{number}."
        yield begin_words(phase, said, prefix), phase.begins
        yield speaker(phase.derivation, prefix), phase.derivation.steps


def _begins(phase: DerivedPhase, own: Words) -> Iterator[Block]:
    """From the end of the phase before to the state in which this one begins."""
    teller = Teller(own)
    if own.has(f"phases.event.{phase.event.replace(' ', '_')}"):
        yield Paragraph(own.say(f"phases.event.{phase.event.replace(' ', '_')}"))
    others, impulses = by_kind(phase.begins, ("phases.impulse",))
    before = [step for step in others if phase.begins.index(step) < _first(phase, impulses)]
    yield from teller.steps(before)
    if impulses:
        yield Paragraph(own.say("phases.impulses", count=len(impulses)))
    yield from teller.steps(impulses)
    yield from teller.steps(step for step in others if step not in before)


def _first(phase: DerivedPhase, impulses: list[Step]) -> int:
    return phase.begins.index(impulses[0]) if impulses else len(phase.begins)


def new_steps(derivation: Derivation, shown: frozenset[str]) -> frozenset[str]:
    """The steps of a later phase that are not a repetition of the first one's."""
    kept = (s for s in derivation.steps if s.id in shown and s.chapter in CHAPTERS)
    return frozenset(step.id for step in kept if NEW.get(step.chapter, lambda step: True)(step))
