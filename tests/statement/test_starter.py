"""The file that `rbpsym new` writes is a sound problem and names every kind."""

from __future__ import annotations

import pytest

from rbpsym.errors import StatementError
from rbpsym.statement import CONSTRAINTS, INTERACTIONS, SHAPES, load_text, starter_text


def test_it_is_a_sound_problem() -> None:
    problem = load_text(starter_text("my-pendulum"), name="my-pendulum")
    assert problem.title == {"en": "My pendulum"}
    assert problem.body_names == ("rod",)


@pytest.mark.parametrize("kind", [*SHAPES, *INTERACTIONS, *CONSTRAINTS])
def test_it_names_every_kind(kind: str) -> None:
    assert f"#   {kind}:" in starter_text("p")


@pytest.mark.parametrize("name", ["", "../x", "a b", "1", "ä"])
def test_names_that_cannot_be(name: str) -> None:
    with pytest.raises(StatementError):
        starter_text(name)
