"""A statement that leaves nothing to move is told so; it does not keep the computer busy for ever."""

import pytest

from rbpsym.errors import StatementError
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text

LEANING = """
[parameters]
M = "mass"
ell = "length"
g = "acceleration"
[coordinates.beta]
start = "beta_0"
range = ["0", "pi/2"]
[coordinates.x]
dimension = "length"
start = "ell*cos(beta_0)"
[bodies.ladder]
shape = "rod"
mass = "M"
length = "ell"
start = ["x", "0"]
angle = "pi - beta"
[interactions.W]
type = "gravity"
[constraints.N_w]
type = "contact"
point = "ladder.end"
line = "x = 0"
[constraints.N_f]
type = "sticking"
point = "ladder.start"
line = "y = 0"
"""


def test_a_rate_without_a_closed_place_is_integrated_once():
    with pytest.raises(StatementError, match="cos"):
        _ = Study(load_text(LEANING)).system
