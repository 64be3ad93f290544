"""E is K + U: what else is kept has a letter of its own, and what is light no weight."""

from __future__ import annotations

from pathlib import Path

import pytest

from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_problem
from tests.library.derived import derived

LIFT = Path(__file__).parents[1] / "ask" / "unseen" / "lift-with-drum.toml"


@pytest.mark.parametrize(("name", "letter"), [("rod-in-accelerating-truck", "E_rel"), ("sliding-ladder", "E")])
def test_what_is_kept_has_a_letter_of_its_own(name: str, letter: str) -> None:
    assert derived(name).step("energy").statement.items[0].name == letter


def test_what_is_light_has_no_weight() -> None:
    assert {force.on for force in Study(load_problem(LIFT)).system.named("W")} == {"cabin", "counter"}
