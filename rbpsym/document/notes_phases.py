"""The later phases of a motion as sections: how each begins, and what then happens."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from itertools import chain, groupby
from typing import Any

from rbpsym.chapters.endings import begun
from rbpsym.document.chapters import chapter_blocks, chapter_sections, solved_together
from rbpsym.document.model import Block, Paragraph, Ref, Section, words
from rbpsym.document.needless import is_struck, owed_by, unsaid
from rbpsym.document.telling import Teller
from rbpsym.document.used import used_to_begin
from rbpsym.document.words import Words, capital
from rbpsym.expr import tree as t
from rbpsym.proof.step import STANDARD, Derivation, DerivedPhase, Step, StepRef
from rbpsym.statement.model import Phase

# of a later phase: what is new in it
CHAPTERS = ("kinematics", "inertia", "instant", "motion", "reactions", "energy", "contact", "oscillations", "course")
NEW: Mapping[str, Collection[str]] = {
    "kinematics": ("constraint", "no_slip", "taut", "tied"),
    "inertia": (),
    "energy": ("conservation", "first_integral"),
}
LASTING = ("conservation", "substitution", "linearization")  # left out one by one where they say the same as before
BLOWS = ("jump", "impulse")
Speaker = Callable[[Derivation, str], Words]


def phase_sections(derivation: Derivation, said: Words, level: int, speaker: Speaker) -> Iterator[Section]:
    """A section for each later phase; in full notes with those of its chapters below it.

    `speaker` gives the words for the derivation of a phase whose labels have a prefix.
    """
    stated_phases, struck = derivation.study.problem.phases, is_struck(derivation.study)
    told = zip(derivation.phases, stated_phases, phase_words(derivation, said, speaker), strict=False)
    for number, (phase, stated, (first, own)) in enumerate(told, 2 - struck):
        inertia = chapter_blocks("inertia", phase.derivation, own) if _is_blow(phase, first) else iter(())
        gone = [step.id for step in phase.derivation.chapter("inertia") if _is_blow(phase, first)]
        own = replace(own, shown=own.shown.difference(gone))
        begins = (*_event(stated, first), *_begins(phase, first, inertia), *_motion_again(phase.derivation, own))
        is_alone, name = struck and len(stated_phases) == 1, said.named(phase.name)
        title = capital(words(name)) if is_alone else said.say("phases.title", number=number, name=name)
        below = tuple(chapter_sections(phase.derivation, own, level + 1))
        blocks = () if own.is_full else tuple(chain.from_iterable(section.blocks for section in below))
        yield Section(title, (*begins, *_clock(phase, own), *blocks), first.prefix + "section", level)
        yield from below if own.is_full else ()


def phase_words(derivation: Derivation, said: Words, speaker: Speaker) -> Iterator[tuple[Words, Words]]:
    """How each later phase is spoken of: its beginning, and what is new in it after the phases before."""
    before = [(derivation, said)]
    for number, phase in enumerate(derivation.phases, 2):
        prefix = f"{said.prefix}phase{number}."
        own = replace(speaker(phase.derivation, prefix), locate=said.locate)  # ends are called as the figure shows them
        own = without_repetition(phase.derivation, own, before)
        before.append((phase.derivation, own))
        begins, given = begin_words(phase, derivation, said, prefix), phase.derivation.study.assumptions
        told = list(chain.from_iterable(begins.owed.values()))
        yield begins, replace(own, owed={id: unsaid(nodes, told, given) for id, nodes in own.owed.items()})


def without_repetition(derivation: Derivation, own: Words, before: list[tuple[Derivation, Words]]) -> Words:
    """The words that refer to an earlier phase where a chapter would only repeat it, formula for formula."""
    earlier = {
        (step.chapter, step.statement): mark
        for found, said in before
        for step in found.steps
        for mark in said.step(step.id)[:1]
        if isinstance(mark, Ref)
    }
    marks = {s.id: earlier[s.chapter, s.statement] for s in derivation.steps if (s.chapter, s.statement) in earlier}
    shown = [step for step in derivation.steps if step.id in own.shown]
    new = {step.chapter for step in shown if step.id not in marks}
    again = {step.id for step in shown if step.id in marks and (step.chapter not in new or step.rule in LASTING)}
    return replace(own, shown=own.shown - again, elsewhere={id: marks[id] for id in again})


def _event(stated: Phase, own: Words) -> Iterator[Block]:
    """What ends the phase before."""
    key = f"phases.event.{begun(stated).replace(' ', '_')}"
    if own.has(key):
        letters: dict[str, Any] = {name: t.Sym(stated.subject) for name in ("force", "coordinate") if stated.subject}
        yield Paragraph(own.say(key, value=stated.value, **letters))


def _motion_again(derivation: Derivation, own: Words) -> Iterator[Block]:
    """That the equations of motion of an earlier phase hold again."""
    found = [step for step in derivation.chapter("motion") if step.rule == "solution" and step.id in own.elsewhere]
    if found:
        count = len(solved_together(found))
        yield Paragraph(own.say("phases.same_motion", equations=[StepRef(step.id) for step in found], count=count))


def _clock(phase: DerivedPhase, own: Words) -> Iterator[Block]:
    """From when the time is counted, where a formula of the phase holds it."""
    if any("t" in t.names(step.statement) for step in phase.derivation.steps if step.id in own.shown):
        yield Paragraph(own.say("phases.clock", time=t.Sym("t")))


def begin_words(phase: DerivedPhase, whole: Derivation, said: Words, prefix: str) -> Words:
    """How the steps by which a phase begins are spoken of."""
    shown = frozenset(step.id for step in phase.begins if step.level <= max(said.level, STANDARD))
    shown = shown if said.is_full else shown & used_to_begin(phase, whole)
    return replace(said, prefix=prefix, shown=shown, same={}, owed=owed_by(phase.begins, shown, whole.study.assumptions))


def phase_results(derivation: Derivation, said: Words, speaker: Speaker) -> Iterator[tuple[Words, tuple[Step, ...]]]:
    """The steps of the later phases, with the words that know their labels."""
    for phase, (first, own) in zip(derivation.phases, phase_words(derivation, said, speaker), strict=True):
        yield first, phase.begins
        yield own, phase.derivation.steps


def _begins(phase: DerivedPhase, own: Words, inertia: Iterator[Block]) -> Iterator[Block]:
    """From the end of the phase before to the state in which this one begins; of a blow the moments of inertia that it asks for,
    and what it keeps before what it changes."""
    teller, shown = Teller(own), [step for step in phase.begins if step.id in own.shown]
    is_kept = any(step.rule == "jump" for step in shown)
    leads = dict(zip(BLOWS, ("phases.blow", "phases.impulses_then" if is_kept else "phases.impulses"), strict=True))
    for rule, group in groupby(shown, key=lambda step: step.rule):
        steps = list(group)
        if rule in leads:
            yield from inertia  # once
            yield Paragraph(own.say(leads[rule], count=len(phase.derivation.study.system.bodies)))
        yield from teller.steps(steps)


def _is_blow(phase: DerivedPhase, own: Words) -> bool:
    """Does the page tell of a blow by which it begins?"""
    return any(step.rule in BLOWS and step.id in own.shown for step in phase.begins)


def new_steps(phase: Derivation, shown: frozenset[str], told: frozenset[str], chapters: Collection[str]) -> frozenset[str]:
    """The steps of a later phase that are not a repetition of the first one's, of which these were `told`."""
    kept = (step for step in phase.steps if step.id in shown and (step.chapter in chapters or _is_nothing(step)))
    again = CHAPTERS if chapters == CHAPTERS else ("inertia",)
    return frozenset(s.id for s in kept if s.rule in NEW.get(s.chapter, (s.rule,)) or (s.id not in told and s.chapter in again))


def _is_nothing(step: Step) -> bool:
    """Does a step say that a force is zero from now on?"""
    said = step.statement
    return step.chapter == "contact" and isinstance(said, t.Chain) and {*said.ops} == {"="} and said.items[-1] == t.ZERO
