"""How a phase ends and the next begins, as claims: a letter of that moment is what it stands for, wherever the event holds."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from rbpsym.expr import tree as t
from rbpsym.field import Scalar, symbol
from rbpsym.mechanics.arrivals import of_coordinate
from rbpsym.mechanics.endings import LAWS
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import Derivation, Step


def parts(derivation: Derivation) -> Iterator[tuple[str, str, Derivation]]:
    """What is certified one by one: the first phase, and each later one with the steps by which it begins; by what stands
    before the ids of its steps, and a word for its file."""
    yield "", "", derivation
    study = derivation.study
    for number, phase in enumerate(derivation.phases, 2):
        if phase.begins:
            yield f"phase{number}.", f"_begin{number}", Derivation(study, phase.begins, letters=phase.letters)
        yield f"phase{number}.", f"_phase{number}", phase.derivation
        study = phase.derivation.study


def letters_then(derivation: Derivation) -> dict[str, Scalar]:
    """What the letters of the end of a phase stand for at that moment: the time, coordinates, speeds."""
    found: dict[str, Scalar] = {}
    for step in derivation.steps:
        found |= LETTERS[step.rule](derivation.study, step) if step.rule in LETTERS else {}
    return found


def _letter(step: Step) -> str:
    return str(getattr(next(t.relations(step.statement))[0], "name", ""))


def _stated(study: Study, step: Step) -> dict[str, Scalar]:
    place = ("place", "speed").index(step.data["what"])
    return {letter: of_coordinate(study, name)[place] for letter, name in step.data["letters"].items()}


LETTERS: Mapping[str, Callable[[Study, Step], dict[str, Scalar]]] = {
    "event_time": lambda study, step: {_letter(step): symbol("t")},
    "event_place": lambda study, step: {_letter(step): of_coordinate(study, step.data["name"])[0]},
    "end_state": _stated,
}


def event(derivation: Derivation) -> Scalar | None:
    """What vanishes at the end of a phase; None where there is no end, or no words for it."""
    phase = next((step.data["ending"].phase for step in derivation.steps if "ending" in step.data), None)
    gap = None if phase is None else LAWS[phase.event].gap
    return None if phase is None or gap is None else gap(derivation.study, phase)
