"""How the phase of an answer begins: the steps on which the value rests, through all phases before, and what they ask for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from rbpsym.ask.asked import Asked
from rbpsym.ask.found import Found
from rbpsym.chapters.impulses import hand_over
from rbpsym.field import names_in
from rbpsym.proof.step import Derivation, Step, StepRef

# what a phase begins with, by the ids of the steps that say so: the first of each row that was made
BEGINS = (("moment", "place"), ("state.place",), ("after.speeds", "state.speed"))


def before(asked: Asked, place: int, found: Found) -> tuple[tuple[str, ...], tuple[Step, ...], list[Derivation]]:
    """The steps by which the phases up to this one begin, as far as the value rests on them or they ask for something; the
    ids of those that say with what this one begins; and the steps with their letters. An id says which phase begins."""
    begun: tuple[str, ...] = ()
    each: list[Derivation] = []
    steps: list[Step] = []
    for k, phase in enumerate(asked.problem.phases[:place], 1):
        draft = hand_over(k, phase, asked.stage(k - 1), asked.stage(k))
        made = {step.id: step for step in draft.steps}
        said = [next((id for id in row if id in made), "") for row in BEGINS]
        ends = [*filter(None, said if k < place else _used(found, said))]
        kept = needed([*made.values()], *ends, *(id for id, step in made.items() if step.obligations))
        names = {id: f"phase{k + 1}.{id}" for id in made}
        each.append(Derivation(draft.study, kept, letters=draft.context))
        steps += [resting_on(begun, _renamed(step, names)) for step in kept]
        begun = tuple(names[id] for id in ends)
    return begun, tuple(steps), each


def resting_on(begun: tuple[str, ...], step: Step) -> Step:
    """The step with the steps that say how its phase begins, if it is about this."""
    is_about = step.id == "answer" or any(id.startswith("start.") for id in step.premises) or step.rule == "end_state"
    return replace(step, cites=(*step.cites, *begun)) if is_about else step


def _renamed(step: Step, names: Mapping[str, str]) -> Step:
    premises, cites = (tuple(names.get(id, id) for id in ids) for ids in (step.premises, step.cites))
    slots = {slot: _mentioned(value, names) for slot, value in step.slots.items()}
    return replace(step, id=names[step.id], premises=premises, cites=cites, slots=slots)


def _mentioned(value: Any, names: Mapping[str, str]) -> Any:
    """What a slot of a phrase holds, with the new names of the steps that it mentions."""
    if isinstance(value, list):
        return [_mentioned(one, names) for one in value]
    return StepRef(names.get(value.id, value.id)) if isinstance(value, StepRef) else value


def _used(found: Found, said: Sequence[str]) -> list[str]:
    """Of what is said of the time, the places and the speeds with which a phase begins, that on which the value rests."""
    if found.moment is None or found.moment.how != "start" or found.study.at_start or found.works or found.told:
        return [*said]
    system = found.study.system
    names = {name for value in found.named for name in names_in(found.study.on_motion(value))}
    kinds = ({"t"}, {*system.coordinates}, {f"{name}_dot" for name in system.coordinates})
    return [id for id, kind in zip(said, kinds, strict=True) if names & kind]


def needed(steps: list[Step], *ends: str) -> tuple[Step, ...]:
    """The steps from which those of these ids follow, with them, in their order."""
    known, wanted = {step.id: step for step in steps}, [*ends]
    found: set[str] = set()
    while wanted:
        id = wanted.pop()
        if id in known and id not in found:
            found.add(id)
            wanted += known[id].reasons
    return tuple(step for step in steps if step.id in found)
