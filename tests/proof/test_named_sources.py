"""Where words say from which equations a result is solved, it follows from these: none is missing, none too many."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rbpsym.proof.step import Derivation, Step, StepRef
from tests.ask.test_unseen import HERE
from tests.library.derived import FOLLOWED, derived, derived_from

UNSEEN = ("string-pair.toml", "rod-strikes-puck.toml")  # θ̈ = 0 from three equations together; two motions in one phase
LOOP = "law.motion"  # of a system with conditions that stay equations


def solved(derivation: Derivation) -> Iterator[Step]:
    for phase in (derivation, *(phase.derivation for phase in derivation.phases)):
        yield from (step for step in phase.steps if step.phrase.startswith("torque.solved"))


@pytest.mark.parametrize("name", [*FOLLOWED, *UNSEEN])
def test_what_is_solved_follows_from_the_equations_that_are_named(name: str) -> None:
    for step in solved(derived_from(HERE / name) if name in UNSEEN else derived(name)):
        named = {ref.id for ref in step.slots["sources"] if isinstance(ref, StepRef)}
        assert {*step.premises} == named or {*step.premises} - named == {LOOP}, step.id
