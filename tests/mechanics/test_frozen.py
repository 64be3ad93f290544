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
    with pytest.raises(StatementError, match="contradicts the constraints"):
        _ = Study(load_text(LEANING.replace('start = "ell*cos(beta_0)"', 'start = "ell"'))).system


def test_what_holds_at_the_start_is_held_there():
    """A ladder that leans at rest is a problem of statics."""
    study = Study(load_text(LEANING))
    assert study.system.independent == ()
    assert study.dynamics.reactions.keys() == {"N_w", "N_f", "f_N_f"}
