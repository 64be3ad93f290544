"""A system that can't be meant gets a sentence, a cure and a line: when it is read, or when its motion is worked out."""

from __future__ import annotations

import pytest

from rbpsym.derive import derive
from rbpsym.errors import LimitError, RbpsymError
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


STRUNG = """
[parameters]
M = "mass"
ell = "length"
h = "length"
a = "length < ell/2"
g = "acceleration"
[points]
A = ["-a-ell/2", "0"]
B = ["a+ell/2", "0"]
[coordinates.x]
dimension = "length"
[coordinates.y]
dimension = "length"
[coordinates.theta]
meaning = "angle"
[bodies.rod]
shape = "rod"
mass = "M"
length = "ell"
center = ["x", "y"]
angle = "theta"
[interactions.W]
type = "gravity"
[constraints.T_1]
type = "string"
path = ["A", "rod.start"]
length = "h"
[constraints.T_2]
type = "string"
path = ["B", "rod.end"]
length = "h"
"""


def test_what_grows_too_long_is_refused_at_once_with_its_place_and_a_cure() -> None:
    with pytest.raises(LimitError) as found:
        derive(load_text(STRUNG, file="strung.toml"))
    assert "“T_1” and “T_2” tie coordinates" in found.value.what
    assert "coordinates in which the constraint holds" in found.value.instead and found.value.place.line > 0
