"""What a pose says and no force does is told with the bodies of which one lacks it."""

import pytest

from rbpsym.errors import StatementError
from rbpsym.mechanics.study import Study
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_text

TRUCK = """
title = "A box that slides on a truck whose weight nothing bears"
[parameters]
m = "mass: mass of either"
mu = "number: coefficient of friction"
d = "length: length of the bed"
a = "acceleration: braking"
g = "acceleration: gravity"
[coordinates.s]
meaning = "way of the box along the bed"
dimension = "length"
start = "0"
[bodies.truck]
shape = "rectangle"
mass = "m"
width = "d"
height = "d"
center = ["-a*t**2/2", "-d/2"]
angle = "0"
[bodies.box]
shape = "particle"
mass = "m"
center = ["s - a*t**2/2", "0"]
[interactions.W]
type = "gravity"
bodies = ["box"]
[constraints]
N = { type = "contact", point = "box.center", of = "truck", line = "y = d/2", coefficient = "mu", slip = "forward" }
D = { type = "prescribed", point = "truck.center", distance = "-a*t**2/2" }
"""


def test_a_body_that_nothing_holds_is_named() -> None:
    with pytest.raises(StatementError, match="the pose of the body “truck” or “box” says more than its constraints hold"):
        assert Study(load_text(TRUCK)).dynamics


def test_held_by_a_slider_it_moves() -> None:
    held = TRUCK + 'H = { type = "slider", point = "truck.center", line = "y = -d/2" }\n'
    assert Study(load_text(held)).dynamics.accelerations.keys() == {"s_ddot"}


def test_beside_a_string_the_body_is_named() -> None:
    """A weight that hangs aside of its pulley, on a slanting rope: it is the weight that nothing keeps there, not the rope."""
    aside = problem_files()["movable-pulley"].read_text().replace('center = ["R", "z"]', 'center = ["R/3", "z"]')
    with pytest.raises(StatementError, match="the pose of the body “weight” says more than its constraints hold"):
        assert Study(load_text(aside)).dynamics


HOOP = """
title = "A bead that nothing holds to a hoop which rolls"
[parameters]
M = "mass: mass of the hoop"
m = "mass: mass of the bead"
r = "length: radius"
g = "acceleration: gravity"
[coordinates.phi]
meaning = "angle through which the hoop rolls"
[coordinates.theta]
meaning = "angle of the bead from the lowest point"
[bodies.hoop]
shape = "hoop"
mass = "M"
radius = "r"
center = ["r*phi", "r"]
[bodies.bead]
shape = "particle"
mass = "m"
center = ["r*phi + r*sin(theta)", "r - r*cos(theta)"]
[interactions]
W = { type = "gravity" }
[constraints]
N = { type = "rolling", body = "hoop", line = "y = 0" }
"""


def test_not_a_constraint_that_only_finds_an_angle() -> None:
    """The rolling asks for the angle of the hoop, and all is well with it."""
    with pytest.raises(StatementError, match="the pose of the body “bead” says more than its constraints hold"):
        assert Study(load_text(HOOP)).dynamics
    held = HOOP + 'Q = { type = "guide", point = "bead.center", circle = "hoop.center", radius = "r" }\n'
    assert Study(load_text(held)).dynamics.accelerations.keys() == {"phi_ddot", "theta_ddot"}


def test_on_a_slanting_string_both_weights_are_named() -> None:
    """Each lacks what keeps it upright below; without either one, the other still does."""
    text = """
title = "Two weights on a rope over a peg that is between them"
[parameters]
m = "mass: mass of each"
h = "length: distance"
g = "acceleration: gravity"
[points]
Q = ["0", "5*h"]
[coordinates.y]
dimension = "length"
start = "h"
[coordinates.z]
dimension = "length"
start = "0"
[bodies.one]
shape = "particle"
mass = "m"
center = ["-h", "z"]
[bodies.two]
shape = "particle"
mass = "2*m"
center = ["h", "y"]
[interactions]
W = { type = "gravity" }
[constraints]
T = { type = "string", path = ["one.center", { around = "Q" }, "two.center"] }
"""
    with pytest.raises(StatementError, match="the pose of the body “one” or “two” says more than its constraints hold"):
        assert Study(load_text(text)).dynamics
