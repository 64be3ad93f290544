"""Under which conditions a phase begins as it is told: a root that sample numbers chose, a slip, a restitution."""

from dataclasses import replace

import pytest

from rbpsym.chapters.impulses import hand_overs
from rbpsym.commands.derive import lines
from rbpsym.derive import derive
from rbpsym.proof.rules import certify
from rbpsym.solve import solve, text
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
    assert "as long as v > 0" in page and "as long as e ≤ 1" in page and "v ≠ 0" not in page


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


SWUNG = """
[parameters]
m = "mass"
l = "length"
g = "acceleration"
omega = "angular speed"
[coordinates.theta]
start = "START"
speed = "omega"
range = ["-2*pi", "2*pi"]
[bodies.b]
shape = "particle"
mass = "m"
center = ["l*sin(theta)", "-l*cos(theta)"]
[interactions.W]
type = "gravity"
[constraints.S]
type = "guide"
point = "b.center"
circle = "O"
radius = "l"
[[phases]]
name = "after"
event = "reaches"
of = "theta"
at = "PLACE"
"""


@pytest.mark.parametrize(
    ("start", "place", "asked"),
    [
        ("0", "pi/2", ["l*omega**2 - 2*g > 0"]),
        ("0", "3*pi/2", ["l*omega**2 - 4*g > 0"]),  # it has to get over the top
        ("pi/2", "3*pi/2", ["l*omega**2 - 2*g > 0"]),
        ("-pi/2", "pi/2", []),
    ],
)
def test_the_motion_comes_to_a_place_where_it_halts_nowhere_before(start, place, asked):
    problem = load_text(SWUNG.replace("START", start).replace("PLACE", place))
    [(_, stage, draft)] = hand_overs(problem)
    [step] = [step for step in draft.steps if step.rule == "event_place"]
    assert [f"{text(demand.value)} {demand.op} 0" for demand in stage.began.before.valid] == asked
    assert step.certificate.verdict.is_proved
    without = certify(draft.context, replace(step, obligations=()))
    assert without.verdict.is_proved is not bool(asked)
