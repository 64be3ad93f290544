"""A question has a bound of work; one that is given up leaves nothing behind that a later one would take for an answer."""

from __future__ import annotations

import pytest

from rbpsym.ask import asking
from rbpsym.ask.asked import Asked
from rbpsym.errors import WorkSpent
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem

QUESTIONS = (
    ("ball-in-a-loop", "smallest v_0 for which theta reaches pi"),
    ("sliding-ladder", "N_f where N_w vanishes"),
    ("inverted-pendulum-on-torsion-spring", "frequency of theta about theta = 0"),
    ("ball-with-backspin", "speed of x when rolling begins"),
)


@pytest.mark.parametrize(("name", "text"), QUESTIONS)
def test_what_is_given_up_can_be_asked_again(name: str, text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Given up at the place where so many products are made, wherever this is, then asked of the same study."""
    problem = load_problem(find_problem(name))
    fresh, asked = asking.answered(Asked(problem), text), Asked(problem)
    whole = asking.MOST_PRODUCTS
    for products in (0, 30, 300, 1000, 3000, 10_000, 30_000):
        monkeypatch.setattr(asking, "MOST_PRODUCTS", products)
        try:
            told = asking.answered(asked, text)
        except WorkSpent as error:
            assert text in error.what and error.instead
            told = None
        assert told is None or (told.values, told.says, told.verdict.kind) == (fresh.values, fresh.says, fresh.verdict.kind)
        assert told is None or products
    monkeypatch.setattr(asking, "MOST_PRODUCTS", whole)
    again = asking.answered(asked, text)
    assert (again.values, again.says, again.verdict.kind) == (fresh.values, fresh.says, fresh.verdict.kind)
