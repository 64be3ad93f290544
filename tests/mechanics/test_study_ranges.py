"""What a statement implies for its parameters without saying it: a slope is below a right angle, what rolls inside is smaller."""

import pytest

from rbpsym.field.scalar import NOTHING, PI, symbol
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text

SLOPE = """
[parameters]
m = "mass"
g = "acceleration"
beta = "angle{sign}"
[coordinates.s]
dimension = "length"
[bodies.b]
shape = "particle"
mass = "m"
center = ["s*cos(beta)", "-s*sin(beta)"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "b.center"
line = "y = -x*tan(beta)"
side = "positive"
"""
BOWL = """
[parameters]
m = "mass"
g = "acceleration"
R = "length"
r = "length"
[coordinates.theta]
meaning = "angle"
[coordinates.phi]
meaning = "angle"
[bodies.b]
shape = "disk"
mass = "m"
radius = "r"
center = ["(R - r)*sin(theta)", "-(R - r)*cos(theta)"]
angle = "-phi"
[interactions.W]
type = "gravity"
[constraints.N]
type = "rolling"
body = "b"
circle = "O"
radius = "R"
side = "inside"
"""


@pytest.mark.parametrize(("sign", "lower"), [("", NOTHING), (", real", -PI / 2)])
def test_a_slope_lies_below_a_right_angle(sign, lower):
    study = Study(load_text(SLOPE.replace("{sign}", sign)))
    assert study.assumptions.ranges["beta"] == (lower, PI / 2)


def test_what_rolls_inside_a_circle_is_smaller():
    assert Study(load_text(BOWL)).assumptions.ranges["r"] == (NOTHING, symbol("R"))


def test_factors_stand_in_the_order_of_a_textbook():
    """Coefficients, masses, stiffnesses, g, lengths, and then the rest."""
    spring = '[interactions.S]\ntype = "spring"\nbetween = ["O", "b.center"]\nstiffness = "k"\n'
    text = BOWL.replace('r = "length"', 'r = "length"\nk = "stiffness"').replace("[constraints.N]", spring + "[constraints.N]")
    rank = {name: place[0] for name, place in Study(load_text(text)).style.rank.items()}
    assert rank["m"] < rank["k"] < rank["R"] == rank["r"] and rank["m"] < rank["g"] < rank["R"]
