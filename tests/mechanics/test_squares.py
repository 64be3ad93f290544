"""Squares of speeds where several coordinates move: the last one from the energy integral."""

from rbpsym.field.normal import is_zero
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text
from tests.mechanics.textbook import read

STICK = """
[parameters]
M = "mass"
ell = "length"
g = "acceleration"
[coordinates.theta]
start = "0"
[coordinates.x]
dimension = "length"
start = "0"
speed = "{speed}"
[bodies.stick]
shape = "rod"
mass = "M"
length = "ell"
center = ["x", "ell/2*cos(theta)"]
angle = "pi/2 - theta"
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "stick.start"
line = "y = 0"
"""


def test_energy_gives_the_last_square():
    for speed in ("0", "v_0"):
        text = STICK.format(speed=speed)
        squares = Study(load_text(text)).squares
        assert is_zero(squares["x"] - read(text, f"{speed}**2"))
        assert is_zero(squares["theta"] - read(text, "12*g/ell*(1 - cos(theta))/(1 + 3*sin(theta)**2)"))
