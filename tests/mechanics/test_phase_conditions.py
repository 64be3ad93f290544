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
