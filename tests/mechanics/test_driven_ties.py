"""A linkage that is driven: where the time alone puts a coordinate, it is a function of the time."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.decide.equal import equal
from rbpsym.expr.infix import read_infix
from rbpsym.statement.loader import load_text

CRANK = """
[parameters]
r = "length"
L = "length > r"
m = "mass"
Omega = "angular speed"
[coordinates.phi]
range = ["-pi/2", "pi/2"]
[bodies.crank]
shape = "rod"
mass = "m"
length = "r"
start = "O"
angle = "Omega*t"
[bodies.rod]
shape = "rod"
mass = "m"
length = "L"
start = "crank.end"
angle = "-phi"
[constraints.F]
type = "pivot"
point = "crank.start"
[constraints.C]
type = "prescribed-angle"
body = "crank"
angle = "Omega*t"
[constraints.A]
type = "pin"
points = ["crank.end", "rod.start"]
[constraints.N]
type = "guide"
point = "rod.end"
line = "y = 0"
"""
NAMES = ("r", "L", "m", "Omega", "t")
ASKED = {
    "phi where t = pi/(6*Omega)": "asin(r/(2*L))",
    "x component of velocity of rod.end where t = pi/(2*Omega)": "-r*Omega",
    "x component of acceleration of rod.end where t = pi/(2*Omega)": "r^2*Omega^2/sqrt(L^2 - r^2)",
    "angular acceleration of rod where t = pi/(2*Omega)": "r*Omega^2/sqrt(L^2 - r^2)",
    "x component of position of rod.end as a function of t": "r*cos(Omega*t) + sqrt(L^2 - r^2*sin(Omega*t)^2)",
    "angular velocity of rod at the start": "-r*Omega/L",
}


@pytest.mark.parametrize("question", ASKED)
def test_a_driven_crank_puts_its_rod_where_the_range_allows(question: str) -> None:
    [found] = ask(load_text(CRANK), question)
    assert found.verdict.is_proved, found.verdict
    assert not found.valid and equal(*(read_infix(text, NAMES) for text in (found.text, ASKED[question]))).is_proved


DRIVEN = """
[parameters]
m = "mass"
c = "acceleration"
tau = "time"
[coordinates.x]
dimension = "length"
[coordinates.y]
dimension = "length"
start = "0"
speed = "0"
[bodies.cart]
shape = "particle"
mass = "m"
center = ["x", "y"]
[interactions.F]
type = "force"
on = "cart.center"
force = ["0", "m*c"]
[constraints.D]
type = "prescribed"
point = "cart.center"
along = ["1", "0"]
distance = "c*t**3/tau"
"""


def test_what_follows_from_the_time_is_not_moved_on_uniformly() -> None:
    """With x = c t³/τ given, x after the time t is that, not ½ ẍ t²."""
    [found] = ask(load_text(DRIVEN), "x where t = tau")
    assert equal(*(read_infix(text, ("c", "tau")) for text in (found.text, "c*tau^2"))).is_proved
