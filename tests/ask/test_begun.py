"""Which phase is meant, what it begins with, and that it can begin: and how far the motion goes on."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.decide.equal import equal
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Sym, walk
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.typeset.machine import to_machine

STRIKING = """
[parameters]
m = "mass: rod"
M = "mass: block"
b = "length: half the rod"
e = { dimension = "number", range = ["0","1"] }
mu = "number: friction"
g = "acceleration: gravity"
[coordinates.theta]
meaning = "angle from downward vertical"
start = "-pi/2"
[coordinates.x]
dimension = "length"
start = "0"
[bodies.rod]
shape = "rod"
mass = "m"
length = "2*b"
start = "O"
angle = "theta - pi/2"
[bodies.block]
shape = "particle"
mass = "M"
center = ["x","-2*b"]
[interactions.W]
type = "gravity"
[constraints.F]
type = "pivot"
point = "rod.start"
[constraints.N]
type = "contact"
point = "block.center"
line = "y = -2*b"
side = "positive"
[[phases]]
name = "after"
event = "reaches"
of = "theta"
at = "0"
constraints = { N = { coefficient = "mu", slip = "forward", friction = "f" } }
[phases.impulses.J]
type = "collision"
points = ["rod.end","block.center"]
along = ["1","0"]
restitution = "e"
"""
STRUCK = """
[parameters]
m = "mass: struck"
M = "mass: other"
ell = "length: rod"
J = "momentum: blow"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.y]
dimension = "length"
start = "0"
[coordinates.phi]
start = "0"
[bodies.one]
shape = "particle"
mass = "m"
center = ["x","y"]
[bodies.two]
shape = "particle"
mass = "M"
center = ["x + ell*cos(phi)","y + ell*sin(phi)"]
[constraints.T]
type = "link"
points = ["one.center","two.center"]
[[phases]]
name = "struck"
event = "at once"
[phases.impulses.B]
type = "blow"
on = "one.center"
impulse = ["0","-J"]
"""
PULLING_WALL = """
[parameters]
m = "mass: each ball"
L = "length: length"
g = "acceleration: gravity"
[coordinates.x]
dimension = "length"
meaning = "place of middle"
[coordinates.y]
dimension = "length"
meaning = "height of the middle"
[coordinates.theta]
meaning = "angle from the vertical"
start = "theta_0"
range = ["0","pi/2"]
[bodies.dumbbell]
shape = "composite"
origin = ["x", "y"]
angle = "-theta"
parts = [ {shape="particle", mass="m", at=["0","L/2"]}, {shape="particle", mass="m", at=["0","-L/2"]} ]
points = { top = ["0","L/2"], bottom = ["0","-L/2"] }
[interactions.W]
type = "gravity"
[constraints.A]
type = "contact"
point = "dumbbell.top"
line = "x = 0"
side = "positive"
[constraints.B]
type = "contact"
point = "dumbbell.bottom"
line = "y = 0"
[[phases]]
name = "free"
event = "lost"
of = "A"
without = ["A"]
"""
UPHILL = """
[parameters]
m = "mass: ball"
R = "length: radius"
beta = "angle, acute: slope"
mu = "number > 2*tan(beta)/7: friction"
v_0 = "speed: start"
g = "acceleration: gravity"
[coordinates.s]
meaning = "way up"
dimension = "length"
start = "0"
speed = "v_0"
[coordinates.phi]
meaning = "angle clockwise"
start = "0"
[bodies.ball]
shape = "ball"
mass = "m"
radius = "R"
center = ["s*cos(beta) - R*sin(beta)", "s*sin(beta) + R*cos(beta)"]
angle = "-phi"
[interactions.W]
type = "gravity"
[constraints.N]
type = "touch"
body = "ball"
line = "y = x*tan(beta)"
coefficient = "mu"
friction = "f"
[[phases]]
name = "rolling"
event = "no slip"
of = "N"
constraints = { N = { type = "rolling" } }
[[phases]]
name = "back"
event = "rests"
of = "s"
"""
CUE = """
[parameters]
m = "mass: mass"
R = "length: radius"
h = "length < 7*R/5: height at which the cue strikes"
J = "momentum: impulse of the cue"
mu = "number: friction"
g = "acceleration: gravity"
[coordinates.x]
dimension = "length"
meaning = "way"
start = "0"
[coordinates.phi]
meaning = "angle turned clockwise"
start = "0"
[bodies.ball]
shape = "ball"
mass = "m"
radius = "R"
center = ["x","R"]
angle = "-phi"
points = { hit = ["0", "h - R"] }
[interactions.W]
type = "gravity"
[constraints.N]
type = "touch"
body = "ball"
line = "y = 0"
coefficient = "mu"
slip = "forward"
friction = "f"
[[phases]]
name = "slipping"
event = "at once"
[phases.impulses.B]
type = "blow"
on = "ball.hit"
impulse = ["J", "0"]
[[phases]]
name = "rolling"
event = "no slip"
of = "N"
constraints = { N = { type = "rolling" } }
"""
NAMES = ("h", "R", "beta", "v_0", "m", "M", "b", "e", "mu", "g", "ell", "J", "t")
ASKED = (
    (STRIKING, "impulse of J when after begins", "m*M*(1 + e)*sqrt(6*g*b)/(m + 3*M)"),
    (STRUCK, "phi as a function of t", "J*t/(m*ell)"),
    (STRUCK, "T", "M*J^2/(m*ell*(m + M))"),
    (STRUCK, "time until phi = 2*pi", "2*pi*m*ell/J"),
    (STRUCK, "T at the start", "0"),
    (CUE, "x_dot when rolling begins", "5*J*h/(7*m*R)"),
    (UPHILL, "largest s", "v_0^2*(2 + 5*mu*cos(beta)/sin(beta))/(2*g*(2*sin(beta) + 7*mu*cos(beta)))"),
)


@pytest.mark.parametrize(("text", "question", "told"), ASKED, ids=lambda value: str(value)[-24:])
def test_a_phase_that_ends_at_once_is_not_meant_and_a_value_is_no_name_of_its_own(text: str, question: str, told: str) -> None:
    [found] = ask(load_text(text), question)
    assert found.verdict.is_proved and equal(*(read_infix(one, NAMES) for one in (found.text, told))).is_proved
    [node] = found.nodes
    assert {part.name for part in walk(node) if isinstance(part, Sym)} <= set(NAMES) | {"pi"}, to_machine(node)


def test_a_motion_that_cannot_begin_is_refused_before_it_is_asked() -> None:
    with pytest.raises(StatementError, match="would have to pull at the start"):
        ask(load_text(PULLING_WALL), "A at the start")


CURB = """
[parameters]
m = "mass"
R = "length"
h = "length < R"
v_0 = "speed"
g = "acceleration"
[points]
P = ["0", "h"]
[coordinates.x]
dimension = "length"
start = "-sqrt(2*R*h - h**2)"
speed = "v_0"
[coordinates.y]
dimension = "length"
start = "R"
[coordinates.phi]
start = "0"
speed = "v_0/R"
[bodies.cyl]
shape = "cylinder"
mass = "m"
radius = "R"
center = ["x", "y"]
angle = "-phi"
[interactions.W]
type = "gravity"
[[phases]]
name = "climb"
event = "at once"
constraints = { N = { type = "rolling", body = "cyl", circle = "P", radius = "0", friction = "f" } }
"""


def test_what_is_tied_without_a_formula_is_told() -> None:
    with pytest.raises(StatementError, match="no function of y that is known"):
        ask(load_text(CURB), "smallest v_0 for which x reaches 0")


def test_before_its_blow_a_motion_is_not_taken_for_the_one_after() -> None:
    """Its first phase ends at once: that the cylinder would go on with v_0/R there is no answer."""
    with pytest.raises(StatementError):
        ask(load_text(CURB), "speed of phi where x = 0")


END_OF_SLIP = "v_0^2*(2*sin(beta) + 12*mu*cos(beta))/(g*(2*sin(beta) + 7*mu*cos(beta))^2)"


def test_what_is_asked_of_one_phase_goes_no_farther_than_that() -> None:
    [found] = ask(load_text(UPHILL), "largest s in phase first")
    assert equal(*(read_infix(one, NAMES) for one in (found.text, END_OF_SLIP))).is_proved


def test_whether_it_turns_round_before_a_phase_begins_is_not_guessed() -> None:
    text = UPHILL.replace("[coordinates.phi]", '[coordinates.phi]\nspeed = "-omega_0"')
    text = text.replace('v_0 = "speed: start"', 'v_0 = "speed: start"\nomega_0 = "angular speed"')
    with pytest.raises(StatementError, match="turns round before “rolling” begins depends on the parameters"):
        ask(load_text(text), "largest s")


BOTH = """
[parameters]
m = "mass: each"
R = "length: radius"
v_0 = "speed: of the first"
mu = "number: friction"
g = "acceleration: gravity"
[coordinates.x]
dimension = "length"
start = "-2*R"
speed = "v_0"
[coordinates.z]
dimension = "length"
start = "0"
[coordinates.phi]
start = "0"
speed = "v_0/R"
meaning = "clockwise"
[coordinates.psi]
start = "0"
meaning = "clockwise"
[bodies.one]
shape = "ball"
mass = "m"
radius = "R"
center = ["x","R"]
angle = "-phi"
[bodies.two]
shape = "ball"
mass = "m"
radius = "R"
center = ["z","R"]
angle = "-psi"
[interactions.W]
type = "gravity"
[constraints.A]
type = "touch"
body = "one"
line = "y = 0"
[constraints.B]
type = "touch"
body = "two"
line = "y = 0"
[[phases]]
name = "hit"
event = "at once"
[phases.constraints]
A = { coefficient = "mu", slip = "backward", friction = "f_A" }
B = { coefficient = "mu", slip = "forward", friction = "f_B" }
[phases.impulses.J]
type = "collision"
points = ["one.center","two.center"]
along = ["1","0"]
[[phases]]
name = "rolling"
event = "no slip"
of = "A"
constraints = { A = { type = "rolling" } }
[[phases]]
name = "both"
event = "no slip"
of = "B"
constraints = { B = { type = "rolling" } }
"""


def test_what_grips_together_is_told_and_no_phase_that_ends_at_once_answers_for_it() -> None:
    with pytest.raises(StatementError, match="“B” stops slipping, and it does not slip any more before"):
        ask(load_text(BOTH), "velocity of one.center")


def test_an_answer_that_a_later_phase_gives_says_so() -> None:
    [found] = ask(load_text(UPHILL), "friction coefficient needed at N")
    assert found.says == "in the phase “rolling”, the first in which it is known"


def test_what_a_blow_asks_for_goes_with_all_that_is_told_of_it() -> None:
    """Friction must be able to hold the end of the rod: for its impulse and the energy that is lost as for the speeds."""
    problem = load_problem(find_problem("rod-dropped-on-rough-floor"))
    texts = ("speed of theta when hit begins", "impulse of J", "energy lost when hit begins")
    asked = [answer.valid for answer in ask(problem, *texts)]
    assert asked[0] and asked == asked[:1] * 3
