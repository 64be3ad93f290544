"""Unknown forces have a value wherever the system can be: none is divided by a sine that may vanish."""

from rbpsym.field.calculus import substitute
from rbpsym.field.normal import is_zero
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text
from tests.mechanics.textbook import read

CUT = """
[parameters]
M = "mass"
ell = "length"
h = "length"
g = "acceleration"
[coordinates.phi]
start = "0"
[coordinates.theta]
start = "0"
[bodies.rod]
shape = "rod"
mass = "M"
length = "ell"
start = ["h*sin(phi)", "-h*cos(phi)"]
angle = "-theta"
[interactions.W]
type = "gravity"
[constraints.T]
type = "string"
path = ["O", "rod.start"]
length = "h"
"""


def test_the_tension_of_an_upright_string():
    study = Study(load_text(CUT))
    tension = substitute(study.dynamics.reactions["T"], study.system.scope.start)
    assert is_zero(tension - read(CUT, "M*g/4"))
