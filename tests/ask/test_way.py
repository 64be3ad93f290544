"""What is told of the way to a place holds in the simulation, at seeded parameter sets inside and outside of its conditions."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rbpsym.ask.asking import answered
from rbpsym.mechanics.events import pushes
from tests.ask import way
from tests.ask.test_answers import asked
from tests.library.derived import FOLLOWED, problem

WHOLE = [name for name in FOLLOWED if not problem(name).phases]
TOUCHING = [name for name in WHOLE if any(pushes(element) for element in problem(name).constraints)]
SOME = sorted({*TOUCHING[::5], *WHOLE[::9]})


@pytest.mark.heavy(of=20)
@pytest.mark.parametrize("name", SOME)
def test_what_is_told_of_the_way_is_what_the_simulation_shows(name: str) -> None:
    assert not way.told_of_the_way(asked(name), 3).wrong


@pytest.mark.thorough
@pytest.mark.parametrize("name", FOLLOWED)
def test_what_is_told_of_the_way_is_what_the_simulation_shows_at_many_sets(name: str) -> None:
    assert not way.told_of_the_way(asked(name), 12).wrong


def test_an_answer_without_its_conditions_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(way, "answered", lambda one, text: replace(answered(one, text), valid=()))
    found = way.told_of_the_way(asked("breaking-chimney"), 3)
    assert found.compared > 5 and found.wrong
