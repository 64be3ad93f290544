"""What the statement says of later phases: what begins each, what strikes then, what holds from then on, and what no more."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rbpsym.chapters.endings import begun
from rbpsym.document.model import Inlines
from rbpsym.document.notes_sentences import sentences_of, touched
from rbpsym.document.words import Words, small
from rbpsym.expr import tree as t
from rbpsym.pictures.pose import DrawnPose
from rbpsym.statement.model import Element, Phase, Problem


def phase_sentences(pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    """What is stated of each later phase, as sentences."""
    before = pose.study.problem
    for phase in before.phases:
        yield _begins(phase, before, pose, said)
        for element in phase.impulses:
            yield from sentences_of(element, pose, said)
        yield from _changes(phase.problem, before, pose, said)
        before = phase.problem


def _begins(phase: Phase, before: Problem, pose: DrawnPose, said: Words) -> Inlines:
    """At which event."""
    subject = next((e for e in (phase.gap, *before.constraints) if e is not None and e.name == phase.subject), None)
    slots: dict[str, Any] = {} if subject is None else touched(subject, pose, said)
    if phase.subject:
        slots |= {"force": _letter(subject) if subject else (), "coordinate": t.Sym(phase.subject)}
    name = said.say("statement.phase", name=said.named(phase.name))
    return said.say(f"statement.event.{begun(phase).replace(' ', '_')}", phase=name, value=phase.value, **slots)


def _changes(problem: Problem, before: Problem, pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    """What is new since the phase before, and what has gone."""
    new, old = ([*each.constraints, *each.interactions] for each in (problem, before))
    known, kept = [_stated(e) for e in old], {e.name for e in new}
    told = [sentence for e in new if _stated(e) not in known for sentence in sentences_of(e, pose, said)]
    if gone := [_letter(e) for e in old if e.name not in kept]:
        told.append(said.say("statement.gone", letters=gone, count=len(gone)))
    if told:
        yield said.say("statement.from_then", sentence=small(told[0]))
        yield from told[1:]


def _stated(element: Element) -> Element:
    """The element but for the sense of a slip, which is that of the motion."""
    return element.with_values(slip=None, side=None)


def _letter(element: Element) -> t.Node:
    return (t.Sym if element.kind in ("string", "link") else t.Vec)(element.name)
