"""What is told of coordinates as functions of the time solves their equations, starts as stated, and lasts as long as it says."""

import pytest

from rbpsym.decide.equal import scalars_equal
from rbpsym.field import NOTHING, Scalar, derivative, substitute, symbol
from rbpsym.frozen import replace
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.solutions import InTime, courses, given
from rbpsym.mechanics.study import Study
from rbpsym.solve import _course, solve
from rbpsym.statement.loader import load_text
from tests.library.derived import NAMES, problem, unsimulated


def gaps(study: Study, name: str, one: InTime) -> list[Scalar]:
    """What must vanish: by its equation of motion, and at the start."""
    at = dict([one.where] if one.where else [])
    gain, start = study.dynamics.accelerations[f"{name}_ddot"], study.system.scope.start
    place = substitute(one.whole, at)
    speed = derivative(place, "t")
    force = substitute(gain, {name: place, f"{name}_dot": speed} | at)
    first = [(place, start[name]), (speed, start.get(f"{name}_dot", NOTHING))]
    return [derivative(speed, "t") - force, *(substitute(a, {"t": NOTHING}) - substitute(b, at) for a, b in first)]


def refuted(study: Study) -> list[str]:
    found = ((n, one) for n in study.system.independent if (known := given(study, n)) is not None for one in courses(known))
    pairs = ((name, gap) for name, one in found for gap in gaps(study, name, one))
    return [name for name, gap in pairs if scalars_equal(gap, NOTHING, study.assumptions).is_refuted]


@pytest.mark.parametrize("name", NAMES)
def test_none_is_refuted(name: str) -> None:
    study = unsimulated(name).study
    assert study.at_start or not refuted(study)


PUSHED = """
[parameters]
m = "mass"
M = "mass"
A = "force"
k = "stiffness"
Omega = "angular speed"
d = "length"
[coordinates.x]
dimension = "length"
start = "-d"
[coordinates.z]
dimension = "length"
[bodies.a]
shape = "particle"
mass = "m"
center = ["x", "0"]
[bodies.b]
shape = "rectangle"
mass = "M"
width = "d"
height = "d"
angle = "0"
left = ["z", "0"]
[constraints.N]
type = "contact"
point = "a.center"
line = "x = -d/2"
of = "b"
[constraints.G]
type = "guide"
point = "a.center"
line = "y = 0"
[constraints.H]
type = "slider"
point = "b.bottom"
line = "y = -d/2"
[interactions.P]
type = "force"
on = "a.center"
"""


@pytest.mark.parametrize(("force", "lasts"), [("A*cos(Omega*t)", "cos(Omega*t) >= 0"), ("-k*x", "-x >= 0")])
def test_it_lasts_as_long_as_the_contact(force: str, lasts: str) -> None:
    letters = {"A": ("k",), "-": ("A", "Omega")}[force[0]]
    text = "\n".join(line for line in PUSHED.splitlines() if line.split(" ")[0] not in letters)
    problem = load_text(f'title = "Pushed"\n{text}\nforce = ["{force}", "0"]\n')
    [told] = solve(problem, simulation=False)["solutions"]["x"]
    assert told["place"] != "0" and lasts in told["valid_where"]


def test_a_course_whose_conditions_exclude_each_other_is_none() -> None:
    """All of its conditions were kept, and it was told."""
    known = study_of(problem("boat-coasting"))
    item = given(known, "x")
    assert item is not None
    [one] = courses(item)
    apart = symbol("v_0") - symbol("c")
    assert list(_course(one, known)) and not list(_course(replace(one, valid=(Demand(apart), Demand(-apart))), known))
