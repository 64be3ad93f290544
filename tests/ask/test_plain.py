"""What is answered of motions holds in the simulation at seeded parameter sets that meet what is told, and needs all of that."""

from __future__ import annotations

from functools import cache
from importlib import import_module

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.frozen import replace
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
from tests.ask import plain
from tests.ask.test_law import ASKING
from tests.ask.test_unseen import asked as unseen

COURSES = "unseen bounds_of_motions fresh third_course fourth_course fifth_course sixth_course seventh_course meant".split()
ANSWERS = [row for course in COURSES for row in import_module(f"tests.ask.test_{course}").ANSWERS]

# a place, a parameter by an equation, a bound, an extreme, a moment after a blow
SOME = (
    ("loop-slide", ("theta where N vanishes", "largest N", "smallest v_0 for which theta reaches pi")),
    ("loop-slide", ("v_0 for which N at the start = 6*m*g",)),
    ("cut", ("F_y right after cut",)),
)


@pytest.mark.parametrize(("name", "questions"), SOME, ids=lambda value: value if isinstance(value, str) else "")
def test_what_is_answered_is_what_the_simulation_shows(name: str, questions: tuple[str, ...]) -> None:
    for text in questions:
        found = plain.judged(unseen(name), text, 1)
        assert found.compared, (text, found.why)
        assert not found.wrong


def test_an_answer_without_its_conditions_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = plain.answered
    monkeypatch.setattr(plain, "answered", lambda one, text: replace(honest(one, text), valid=()))
    assert plain.judged(unseen("loop-slide"), "N where theta = 2*pi/3", 3).wrong


def test_what_is_lost_at_once_is_not_said_to_be_kept() -> None:
    """With v_0² > g R the puck leaves the dome where it is pushed."""
    assert plain.answered(unseen("puck-on-dome"), "does N vanish").says == "yes where this is met"


@pytest.mark.thorough
@pytest.mark.parametrize("name", sorted({name for name, *_ in ANSWERS}))
def test_what_is_answered_is_what_the_simulation_shows_at_many_sets(name: str) -> None:
    assert not [wrong for one, text, _ in ANSWERS if one == name for wrong in plain.judged(unseen(name), text, 20).wrong]


@cache
def library(name: str) -> Asked:
    return Asked(load_problem(find_problem(name)))


@pytest.mark.thorough
@pytest.mark.parametrize("name", ASKING)
def test_what_a_problem_of_the_library_asks_is_what_the_simulation_shows(name: str) -> None:
    assert not [wrong for text in library(name).problem.questions for wrong in plain.judged(library(name), text, 20).wrong]
