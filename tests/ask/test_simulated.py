"""What is answered about the problems of the library is what the simulation shows, at seeded parameter sets."""

from __future__ import annotations

import pytest

from tests.ask.simulated import compared
from tests.ask.test_answers import asked
from tests.library.derived import FOLLOWED
from tests.oracles.conftest import SETS

# problems whose motion is not declared in full, or is not followed: nothing can be compared
UNCOMPARED: set[str] = set()


@pytest.mark.heavy(of=10)
@pytest.mark.parametrize("name", FOLLOWED)
def test_answers_are_what_the_simulation_shows(name: str, record_property) -> None:
    found = compared(asked(name), 1)
    record_property(SETS, found.sets)
    assert not found.wrong
    assert found.compared or name in UNCOMPARED


@pytest.mark.thorough
@pytest.mark.parametrize("name", FOLLOWED)
def test_answers_are_what_the_simulation_shows_at_many_sets(name: str) -> None:
    assert not compared(asked(name), 20).wrong
