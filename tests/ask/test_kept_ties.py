"""What is tied to a coordinate that a kept momentum gives: its speed at a place is checked by both."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.decide.equal import equal
from rbpsym.expr.infix import read_infix
from rbpsym.statement.loader import load_text

IN_A_PIPE = """
[parameters]
m = "mass: cylinder"
M = "mass: pipe"
r = "length < R: cylinder"
R = "length: pipe"
g = "acceleration: gravity"
[coordinates.theta]
start = "theta_0"
range = ["-pi/2","pi/2"]
meaning = "angle of the line of centres from the downward vertical"
[coordinates.psi]
start = "0"
meaning = "angle of the pipe"
[coordinates.phi]
meaning = "angle of the cylinder"
[bodies.pipe]
shape = "hoop"
mass = "M"
radius = "R"
center = "O"
angle = "psi"
[bodies.cyl]
shape = "cylinder"
mass = "m"
radius = "r"
center = ["(R-r)*sin(theta)","-(R-r)*cos(theta)"]
angle = "phi"
[interactions.W]
type = "gravity"
[constraints.A]
type = "pivot"
point = "pipe.center"
[constraints.N]
type = "rolling"
body = "cyl"
circle = "pipe.center"
side = "inside"
friction = "f"
"""
NAMES = ("m", "M", "r", "R", "g", "theta_0")
ASKED = {
    "N where theta = 0": "m*g*(1 + 2*(1 - cos(theta_0))*(2*M + m)/(3*M + m))",
    "kinetic energy of the system where theta = 0": "m*g*(R - r)*(1 - cos(theta_0))",
}


@pytest.mark.parametrize("question", ASKED)
def test_a_rolling_cylinder_in_a_free_pipe(question: str) -> None:
    [found] = ask(load_text(IN_A_PIPE), question)
    assert found.verdict.is_proved and equal(*(read_infix(text, NAMES) for text in (found.text, ASKED[question]))).is_proved
