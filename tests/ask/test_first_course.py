"""Questions of a first course that fresh users asked, with their answers by hand."""

import math

import pytest

from rbpsym.ask.asking import ask
from rbpsym.ask.numbers import read_numbers
from rbpsym.ask.telling import record
from rbpsym.decide.equal import equal
from rbpsym.expr.infix import read_infix
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text
from rbpsym.typeset.machine import to_machine

PLATE = """
[parameters]
m = "mass: plate"
a = "length: width"
b = "length: height"
g = "acceleration: gravity"
[coordinates.theta]
start = "0"
range = ["-pi", "pi"]
[bodies.plate]
shape = "rectangle"
mass = "m"
width = "a"
height = "b"
top_left = "O"
angle = "theta"
[interactions.W]
type = "gravity"
[constraints.F]
type = "pivot"
point = "plate.top_left"
"""
SPOOL = """
[parameters]
M = "mass: spool"
I = "moment of inertia: about its axis"
R = "length: rim"
r = "length < R: drum"
F = "force: pull"
mu = "number: friction"
g = "acceleration: gravity"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.phi]
[bodies.spool]
shape = "given"
mass = "M"
moment = "I"
cm = ["x", "R"]
angle = "-phi"
[interactions.W]
type = "gravity"
[interactions.P]
type = "force"
on = "spool.cm"
force = ["F", "0"]
[interactions.C]
type = "couple"
on = "spool"
couple = "-F*r"
[constraints.N]
type = "rolling"
body = "spool"
rim = "R"
line = "y = 0"
friction = "f"
limit = "mu"
"""
CABINET = """
[parameters]
m = "mass: cabinet"
c = "length: half its width"
h = "length: height of its centre of mass"
y_p = "length < 2*h: height of the push"
P = "force: push"
g = "acceleration: gravity"
[coordinates.x]
dimension = "length"
start = "0"
[bodies.cabinet]
shape = "rectangle"
mass = "m"
width = "2*c"
height = "2*h"
center = ["x", "h"]
angle = "0"
points = { push = ["-c", "y_p - h"] }
[interactions.W]
type = "gravity"
[interactions.Q]
type = "force"
on = "cabinet.push"
force = ["P", "0"]
[constraints.N_L]
type = "contact"
point = "cabinet.bottom_left"
line = "y = 0"
[constraints.N_R]
type = "contact"
point = "cabinet.bottom_right"
line = "y = 0"
"""
BRAKED = """
[parameters]
M = "mass: wheel"
R = "length: radius"
P = "force: of the shoe"
mu = "number: friction"
omega_0 = "angular speed: at the start"
[coordinates.phi]
start = "0"
speed = "omega_0"
[bodies.wheel]
shape = "disk"
mass = "M"
radius = "R"
center = "O"
angle = "phi"
[interactions.B]
type = "resisting-couple"
between = ["ground", "wheel"]
size = "mu*P*R"
[constraints.F]
type = "pivot"
point = "wheel.center"
"""
LADDER = """
[parameters]
m = "mass: ladder"
L = "length: ladder"
u = "speed: of the foot"
[coordinates.theta]
start = "theta_0"
range = ["0", "pi/2"]
[bodies.ladder]
shape = "rod"
mass = "m"
length = "L"
start = ["L*cos(theta)", "0"]
angle = "pi - theta"
[constraints.D]
type = "prescribed"
point = "ladder.start"
distance = "L*cos(theta_0) + u*t"
[constraints.N_f]
type = "guide"
point = "ladder.start"
line = "y = 0"
[constraints.N_w]
type = "guide"
point = "ladder.end"
line = "x = 0"
"""
ROOF = """
[parameters]
M = "mass: ball"
R = "length: radius"
beta = "angle, acute: slope of the roof"
d = "length: way along the roof"
h = "length: height"
g = "acceleration: gravity"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.y]
dimension = "length"
start = "R/cos(beta)"
[coordinates.phi]
start = "0"
[bodies.ball]
shape = "ball"
mass = "M"
radius = "R"
center = ["x", "y"]
angle = "-phi"
[interactions.W]
type = "gravity"
[constraints.N]
type = "rolling"
body = "ball"
line = "y = -x*tan(beta)"
friction = "f"
[[phases]]
name = "flight"
event = "reaches"
of = "x"
at = "d*cos(beta)"
without = ["N"]
"""
ASKED = (
    # a place that a coordinate tells is told so in its own phase: on the roof x and y are tied, in flight they are not
    (ROOF, "speed of ball after ball has fallen h in phase flight", "sqrt(2*g*h + 10*g*d*sin(beta)/7)", []),
    (ROOF, "time in phase flight until ball has fallen h",  # from the beginning of that phase, as a work
     "(sqrt(10*g*d*sin(beta)^3/7 + 2*g*h) - sqrt(10*g*d*sin(beta)^3/7))/g", []),
    (ROOF, "speed of ball after ball has fallen h", "sqrt(10*g*h/7)", ["d*sin(beta) - h >= 0"]),
    (PLATE, "largest angular speed of plate", "sqrt(3*g*(sqrt(a^2 + b^2) - b)/(a^2 + b^2))", []),
    (PLATE, "theta where theta comes to rest", "-2*atan(a/b)", []),
    (PLATE, "largest speed of plate.cm", "sqrt(3*g*(sqrt(a^2 + b^2) - b))/2", []),
    (SPOOL, "friction coefficient needed at N", "F*sqrt((M*R*r - I)^2)/(M*g*(I + M*R^2))", []),
    (CABINET, "largest y_p for which it does not tip", "h + m*g*c/P", ["P*h - m*g*c > 0"]),
    (CABINET, "smallest y_p for which it does not tip", "h - m*g*c/P", ["P*h - m*g*c > 0"]),
    (BRAKED, "P for which phi where phi comes to rest = 20*pi", "M*R*omega_0^2/(80*pi*mu)", []),
    (LADDER, "time until theta = theta_0/2", "(L/u)*(cos(theta_0/2) - cos(theta_0))", []),
    (LADDER, "time until theta = pi/3", "(L/(2*u))*(1 - 2*cos(theta_0))", ["3*theta_0 - pi > 0"]),
    (LADDER, "angular velocity of ladder where theta = pi/3", "2*u/(sqrt(3)*L)", ["3*theta_0 - pi > 0"]),
    (LADDER, "speed of ladder.end where theta = theta_0/2", "u/tan(theta_0/2)", []),
)


@pytest.mark.parametrize(("text", "question", "value", "conditions"), ASKED, ids=[question for _, question, *_ in ASKED])
def test_answers_are_those_by_hand(text: str, question: str, value: str, conditions: list[str]) -> None:
    problem = load_text(text)
    [found] = ask(problem, question)
    names = [quantity.name for quantity in problem.parameters]
    told = found.text.partition(" = ")[2] or found.text
    both = (read_infix(one, names) for one in (told, value))
    assert found.verdict.is_proved and equal(*both, Study(problem).assumptions).is_proved
    assert [to_machine(node) for node in found.valid] == conditions


def test_a_ladder_that_is_pulled_comes_there_at_the_time_that_is_told() -> None:
    """θ' = -u/(L sin θ), integrated in small steps from 1.2 to 0.6."""
    theta, time, step = 1.2, 0.0, 1e-5
    while theta > 0.6:
        half = theta - step / (2 * math.sin(theta))
        theta, time = theta - step / math.sin(half), time + step
    problem = load_text(LADDER)
    [found] = ask(problem, "time until theta = theta_0/2")
    numbers = read_numbers("L = 1 m, u = 1 m/s, theta_0 = 1.2 rad", problem)
    assert record(found, numbers)["value"] == pytest.approx(time, rel=1e-3)
