"""What tips does not slip before, what slides has begun to; and what is found in one case of a motion says in which."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.statement.loader import load_text
from rbpsym.typeset.text import to_text

STANDING = """
[parameters]
m = "mass: crate"
M = "mass: truck"
b = "length: half the width of the crate"
h = "length: height of the crate"
A = "acceleration: of the truck"
mu = "number: static friction"
w = "length: width of the truck"
q = "length: height of the truck"
g = "acceleration: gravity"
[coordinates.X]
meaning = "place of the truck"
dimension = "length"
start = "0"
[coordinates.x]
meaning = "place of the crate"
dimension = "length"
start = "0"
[bodies.truck]
shape = "rectangle"
mass = "M"
width = "w"
height = "q"
center = ["X", "-q/2"]
angle = "0"
[bodies.crate]
shape = "rectangle"
mass = "m"
width = "2*b"
height = "h"
center = ["x", "h/2"]
angle = "0"
[interactions.W]
type = "gravity"
[constraints.P]
type = "slider"
point = "truck.bottom"
line = "y = -q"
[constraints.D]
type = "prescribed"
point = "truck.center"
distance = "A*t**2/2"
along = ["1", "0"]
[constraints.N_R]
type = "contact"
point = "crate.bottom_right"
line = "y = q/2"
of = "truck"
[constraints.N_L]
type = "sticking"
point = "crate.bottom_left"
line = "y = q/2"
of = "truck"
friction = "f"
limit = "mu"
beside = "N_R"
"""
SLIDING = """
[parameters]
m = "mass: crate"
b = "length: half the width"
h = "length: height"
c = "length < h: height of the push"
P = "force: push"
mu = "number: kinetic friction"
d = "length: way"
g = "acceleration: gravity"
[coordinates.x]
meaning = "place of the centre"
dimension = "length"
start = "0"
[bodies.crate]
shape = "rectangle"
mass = "m"
width = "2*b"
height = "h"
center = ["x", "h/2"]
angle = "0"
points = { push = ["-b", "c - h/2"] }
[interactions.W]
type = "gravity"
[interactions.Q]
type = "force"
on = "crate.push"
force = ["P", "0"]
[constraints.N_A]
type = "contact"
point = "crate.bottom_left"
line = "y = 0"
coefficient = "mu"
slip = "forward"
[constraints.N_B]
type = "contact"
point = "crate.bottom_right"
line = "y = 0"
coefficient = "mu"
slip = "forward"
"""
ROLLING = """
[parameters]
m = "mass: ball"
R = "length: radius"
v_0 = "speed: at the start"
w_0 = "angular speed: topspin"
mu = "number: kinetic friction"
g = "acceleration: gravity"
[coordinates.x]
meaning = "place"
dimension = "length"
start = "0"
speed = "v_0"
[coordinates.phi]
meaning = "turn, clockwise"
start = "0"
speed = "w_0"
[bodies.ball]
shape = "ball"
mass = "m"
radius = "R"
center = ["x", "R"]
angle = "-phi"
[interactions.W]
type = "gravity"
[constraints.N]
type = "touch"
body = "ball"
line = "y = 0"
coefficient = "mu"
friction = "f"
[[phases]]
name = "rolling"
event = "no slip"
of = "N"
constraints = { N = { type = "rolling" } }
"""
SPOOL = """
[parameters]
m = "mass: spool"
gamma = "number: its moment of inertia over m R^2"
R = "length: outer radius"
r = "length < R: inner radius"
F = "force: pull"
alpha = "angle, acute: of the string"
mu = "number: static friction"
g = "acceleration: gravity"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.phi]
meaning = "turn, clockwise"
[bodies.spool]
shape = "given"
mass = "m"
moment = "gamma*m*R**2"
center = ["x", "R"]
angle = "-phi"
[interactions.W]
type = "gravity"
[interactions.P]
type = "force"
on = "spool.center"
force = ["F*cos(alpha)", "F*sin(alpha)"]
[interactions.C]
type = "couple"
on = "spool"
couple = "F*r"
[constraints.N]
type = "rolling"
body = "spool"
rim = "R"
line = "y = 0"
friction = "f"
limit = "mu"
"""
ASKED = (
    (STANDING, "smallest A for which it tips", ["μh − 2b ≥ 0"]),
    (STANDING, "smallest h for which it tips", ["μg − A ≥ 0"]),
    (STANDING, "does it tip", ["μg − A ≥ 0", "2gb − Ah ≥ 0"]),
    (SLIDING, "smallest c for which it tips", ["P − μmg > 0"]),
    (STANDING, "A for which N_R >= m*g/4", ["μh − b ≥ 0"]),
    (SLIDING, "largest c for which N_A stays positive until x = d", ["P − μmg > 0"]),
    (ROLLING, "mu for which time until rolling = v_0/g", ["v₀ − Rw₀ > 0"]),
    (SPOOL, "largest F for which it does not slip", []),
    (SPOOL, "smallest mu for which it does not slip", ["mg − F sin α > 0"]),
    (SPOOL, "F for which N <= m*g/2", ["μR(1 + γ) sin α − r − γR cos α > 0"]),
)


@pytest.mark.parametrize(("text", "question", "told"), ASKED, ids=lambda value: str(value)[-30:])
def test_the_case_is_told(text: str, question: str, told: list[str]) -> None:
    [found] = ask(load_text(text), question)
    said = [to_text(node) for node in found.valid]
    assert found.verdict.is_proved and set(told) <= set(said) and len(said) == len(set(said))
    assert "lost" not in found.says and "not decided" not in found.says
