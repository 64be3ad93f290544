"""Places where forces balance, and what the linear equations cannot tell of them."""

import pytest

from rbpsym.derive import derive
from rbpsym.mechanics.study import Study
from rbpsym.statement import load_text

BEAD = """
[parameters]
m = "mass"
R = "length"
k = "stiffness"
L = "length"
g = "acceleration"
[coordinates.phi]
start = "phi_0"
range = ["-pi", "pi"]
[bodies.bead]
shape  = "particle"
mass   = "m"
center = ["R*sin(phi)", "-R*cos(phi)"]
[points]
A = ["0", "R"]
[interactions.W]
type = "gravity"
[interactions.S]
type           = "spring"
between        = ["A", "bead.center"]
stiffness      = "k"
natural_length = "L"
[constraints.N]
type   = "guide"
point  = "bead.center"
circle = "O"
radius = "R"
"""
ACROSS = """
[parameters]
m = "mass"
k = "stiffness"
b = "length"
[coordinates.y]
dimension = "length"
start = "y_0"
[bodies.bead]
shape  = "particle"
mass   = "m"
center = ["0", "y"]
[points]
A = ["-b", "0"]
B = ["b", "0"]
[interactions.S]
type           = "spring"
between        = ["A", "bead.center"]
stiffness      = "k"
natural_length = "b"
[interactions.T]
type           = "spring"
between        = ["B", "bead.center"]
stiffness      = "k"
natural_length = "b"
[constraints.N]
type  = "guide"
point = "bead.center"
line  = "x = 0"
"""
HUNG = """
[parameters]
m = "mass"
M = "mass"
R = "length"
k = "stiffness"
L = "length"
H = "length"
g = "acceleration"
[coordinates.y]
dimension = "length"
start = "y_0"
range = ["0", "H"]
[coordinates.phi]
[bodies.wheel]
shape  = "disk"
mass   = "M"
radius = "R"
center = ["0", "H"]
angle  = "phi"
[bodies.bob]
shape  = "particle"
mass   = "m"
center = ["R", "H - y"]
[points]
floor = ["R", "0"]
[interactions.W]
type = "gravity"
[interactions.K]
type           = "spring"
between        = ["floor", "bob.center"]
stiffness      = "k"
natural_length = "L"
[constraints.F]
type  = "pivot"
point = "wheel.center"
[constraints.S]
type = "string"
path = [{ around = "wheel", radius = "R", sense = "cw" }, "bob.center"]
"""


@pytest.mark.parametrize(
    ("text", "places", "why"),
    [(BEAD, 1, "no slope"), (HUNG, 0, "about to let go")],
    ids=["a spring of no length", "a string without tension"],
)
def test_where_the_linear_equations_tell_nothing_no_frequency_is_told(text, places, why):
    study = Study(load_text(text))
    assert len(study.equilibria) == places and study.rest.complete is None and why in study.rest.reason


def test_a_stiffness_that_vanishes_is_no_condition():
    study = Study(load_text(ACROSS))
    [place] = study.equilibria
    assert place.where is None and place.stable is None and study.rest.complete  # b √(b² + y²) = b² + y² at y = 0 alone


def test_an_equation_is_freed_of_a_factor_that_vanishes_elsewhere():
    """What is left tells places where the forces balance, if not all."""
    assert all(step.certificate.verdict.is_proved for step in derive(load_text(BEAD), simulation=False).steps)
