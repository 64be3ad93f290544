"""A system that can't be meant gets a sentence, a cure and a line: when it is read, or when its motion is worked out."""

from __future__ import annotations

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.study import Study
from rbpsym.statement import load_text
from tests.statement.wrong_systems import BALL, IMPACT, ROWS, WHEEL, Wrong


def worked_out(text: str) -> int:
    """The number of phases of a statement."""
    problem = load_text(text, file="wrong.toml")
    Study(problem).dynamics  # worked out when asked for
    return len(stages(problem))


def test_the_sound_statements_are_sound() -> None:
    assert [worked_out(text) for text in (BALL, IMPACT, WHEEL)] == [2, 2, 1]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.name)
def test_sentence(row: Wrong) -> None:
    with pytest.raises(RbpsymError) as found:
        worked_out(row.text)
    error = found.value
    assert row.says in error.what
    assert row.cure in error.instead
    assert error.exit_code == 2
    assert error.place is not None and error.place.line > 0


def test_every_row_is_another_fault() -> None:
    assert len({row.name for row in ROWS}) == len({row.text for row in ROWS}) == len(ROWS) >= 60
