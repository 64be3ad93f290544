"""Under which conditions a phase begins as it is told: a root that sample numbers chose, a slip, a restitution."""

import pytest

from rbpsym.commands.derive import lines
from rbpsym.derive import derive
from rbpsym.solve import solve
from rbpsym.statement import load_text

PUCKS = """
title = "Pucks"
[parameters]
m = "mass"
v = "speed, real"
a = "acceleration, real"
d = "length"
e = "number"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v"
[coordinates.X]
dimension = "length"
start = "d"
[bodies.p]
shape  = "particle"
mass   = "m"
center = ["x", "0"]
[bodies.q]
shape  = "particle"
mass   = "m"
center = ["X", "0"]
FORCE
[constraints.N]
type  = "guide"
point = "p.center"
line  = "y = 0"
[constraints.P]
type  = "guide"
point = "q.center"
line  = "y = 0"
[[phases]]
name  = "after"
event = "reaches"
of    = "x"
at    = "d"
[phases.impulses.J]
type        = "collision"
points      = ["p.center", "q.center"]
along       = ["1", "0"]
restitution = "e"
"""
FORCE = '[interactions.Q]\ntype = "force"\non = "p.center"\nforce = ["m*a", "0"]'


@pytest.mark.parametrize(("force", "asked"), [("", ["v > 0"]), (FORCE, ["a > 0"])])
def test_the_root_that_is_taken_is_the_first_only_under_a_condition(force, asked):
    [phase] = solve(load_text(PUCKS.replace("FORCE", force)), simulation=False)["phases"]
    assert phase["valid_where"] == asked and phase["start_valid_where"] == ["1 - e >= 0"]


def test_a_page_tells_under_which_conditions_a_phase_begins():
    page = "\n".join(lines(derive(load_text(PUCKS.replace("FORCE", "")), simulation=False), "standard", "all", "en"))
    assert "as long as v > 0" in page and "as long as 1 − e ≥ 0" in page and "v ≠ 0" not in page


LAUNCHED = """
[parameters]
m    = "mass"
k    = "stiffness"
L    = "length"
d    = "length < L"
beta = "angle, acute"
g    = "acceleration"
[coordinates.s]
dimension = "length"
start = "d"
range = ["0", ""]
[bodies.p]
shape  = "particle"
mass   = "m"
center = ["s*cos(beta)", "s*sin(beta)"]
[interactions.W]
type = "gravity"
[interactions.S]
type           = "spring"
between        = ["O", "p.center"]
stiffness      = "k"
natural_length = "L"
[constraints.N]
type  = "contact"
point = "p.center"
line  = "y = x*tan(beta)"
side  = "positive"
[[phases]]
name  = "free"
event = "reaches"
of    = "s"
at    = "L"
"""


def test_sample_numbers_at_which_a_phase_is_not_reached_refuse_nothing():
    [phase] = solve(load_text(LAUNCHED), simulation=False)["phases"]
    assert phase["valid_where"] == ["k*(L - d) - 2*m*g*sin(beta) > 0"]


FALLEN = """
[parameters]
m = "mass"
h = "length"
g = "acceleration"
[coordinates.y]
dimension = "length"
start = "h"
[bodies.p]
shape  = "particle"
mass   = "m"
center = ["0", "y"]
[interactions.W]
type = "gravity"
[constraints.N]
type  = "guide"
point = "p.center"
line  = "x = 0"
[[phases]]
name  = "held"
event = "reaches"
of    = "y"
at    = "0"
without = ["N"]
constraints = { P = { type = "pivot", point = "p.center", at = ["0", "0"] } }
"""


def test_squares_of_roots_are_carried_out_in_the_place_of_an_event():
    [phase] = solve(load_text(FALLEN), simulation=False)["phases"]
    assert phase["at"] == {"y": "0"}
