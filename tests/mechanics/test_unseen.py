"""Problems that were stated from the documentation alone, and what their first statements brought to light."""

from __future__ import annotations

import re

import pytest

from rbpsym.derive import derive
from rbpsym.errors import StatementError
from rbpsym.field import symbol
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.study import Study
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem, load_text
from tests.mechanics.textbook import Textbook, complaints, differences

BALL = """
[parameters]
m = "mass"
ell = "length"
Omega = "angular speed"
g = "acceleration"
[coordinates.theta]
start = "theta_0"
range = ["0", "pi/2"]
[bodies.bob]
shape = "particle"
mass = "m"
center = ["ell*sin(theta)", "-ell*cos(theta)"]
[interactions.W]
type = "gravity"
[interactions.Z]
type = "force"
on = "bob.center"
force = ["m*Omega**2*ell*sin(theta)", "0"]
[constraints.S]
type = "link"
points = ["O", "bob.center"]
"""

WHEELS = """
[parameters]
M_1 = "mass"
M_2 = "mass"
R_1 = "length"
R_2 = "length"
omega_0 = "angular speed"
P = "force"
mu = "number"
[coordinates.phi]
start = "0"
speed = "omega_0"
[coordinates.psi]
start = "0"
[coordinates.x]
dimension = "length"
[bodies.first]
shape = "disk"
mass = "M_1"
radius = "R_1"
center = "O"
angle = "phi"
[bodies.second]
shape = "disk"
mass = "M_2"
radius = "R_2"
center = ["x", "0"]
angle = "psi"
[interactions.Q]
type = "force"
on = "second.center"
force = ["-P", "0"]
[constraints.A]
type = "pivot"
point = "first.center"
[constraints.B]
type = "guide"
point = "second.center"
line = "y = 0"
[constraints.N]
type = "touch"
body = "second"
circle = "first.center"
coefficient = "mu"
[[phases]]
name = "rolling"
event = "no slip"
of = "N"
constraints = { N = { type = "rolling" } }
"""

SPRINGS = """
[parameters]
M = "mass"
a = "length"
k = "stiffness"
d = "length"
g = "acceleration"
[coordinates.y]
dimension = "length"
start = "y_0"
[coordinates.theta]
start = "theta_0"
[bodies.rod]
shape = "rod"
mass = "M"
length = "2*a"
center = ["0", "y"]
angle = "theta"
[points]
A = ["-a", "0"]
B = ["a", "0"]
[interactions.W]
type = "gravity"
[interactions.S_1]
type = "spring"
between = ["A", "rod.start"]
stiffness = "k"
natural_length = "d"
[interactions.S_2]
type = "spring"
between = ["B", "rod.end"]
stiffness = "k"
natural_length = "d"
"""

WALKER = """
[parameters]
M = "mass"
R = "length"
m = "mass"
u = "speed"
[coordinates.phi]
start = "0"
[coordinates.psi]
[bodies.roundabout]
shape = "disk"
mass = "M"
radius = "R"
center = "O"
angle = "phi"
[bodies.man]
shape = "composite"
origin = "O"
angle = "psi"
parts = [{ shape = "particle", mass = "m", at = ["R", "0"] }]
[constraints.F]
type = "pivot"
point = "roundabout.center"
[constraints.G]
type = "pin"
points = ["roundabout.center", "man.origin"]
[constraints.C]
type = "prescribed-angle"
body = "man"
of = "roundabout"
angle = "u*t/R"
"""

GOVERNOR = Textbook(
    "governor",
    BALL,
    {
        "accelerations/theta": "(Omega**2*cos(theta) - g/ell)*sin(theta)",
        "equilibria/0/at/theta": "acos(g/(ell*Omega**2))",
    },
    stable=(True,),
)
ROUNDABOUT = Textbook(
    "roundabout",
    WALKER,
    {"accelerations/phi": "0", "reactions/C": "0"},
)


@pytest.mark.parametrize("system", [GOVERNOR, ROUNDABOUT], ids=lambda system: system.name)
def test_results(system: Textbook) -> None:
    assert differences(system) == []
    assert complaints(system.text) == []


def test_the_governor_without_a_range_has_four_places_each_with_its_condition() -> None:
    found = Study(load_text(BALL.replace('range = ["0", "pi/2"]\n', ""))).equilibria
    assert [len(item.valid) for item in found] == [0, 0, 1, 1]
    assert [item.stable for item in found] == [None, False, True, True]


def test_two_wheels_that_rub_touch_from_outside_and_share_their_momentum() -> None:
    rubbing, rolling = stages(load_text(WHEELS))
    assert str(rubbing.study.dynamics.reactions["N"]) == "Scalar(P)"
    wanted = load_text(WHEELS.replace('speed = "omega_0"', 'speed = "M_1*omega_0/(M_1 + M_2)"'))
    assert is_zero(rolling.began.speeds["phi"] - scalar(wanted.coordinate("phi").speed))
    found = derive(load_text(WHEELS)).summary()
    assert found["refuted"] == 0 and found["simulation"]["max_relative_error"] < 1e-8


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (SPRINGS, "nothing exerts the force along x"),
        (WHEELS.replace('"-P", "0"', '"P", "0"'), "would have to pull"),
        (
            BALL.replace('"link"\npoints', '"string"\npath').replace(
                'start = "theta_0"\nrange = ["0", "pi/2"]', 'start = "pi"'
            ),
            "would have to push",
        ),
    ],
    ids=["held by nothing", "contact that pulls", "string that pushes"],
)
def test_what_nothing_can_do_is_told(text: str, says: str) -> None:
    with pytest.raises(StatementError, match=says):
        derive(load_text(text), simulation=False)


def test_a_string_that_would_cross_its_pulley_is_told_at_once() -> None:
    text = problem_files()["movable-pulley"].read_text(encoding="utf-8").replace('"-h"', '"0"')
    with pytest.raises(StatementError, match="would have to cross its pulley"):
        derive(load_text(text), simulation=False)


def test_what_follows_up_to_a_constant_needs_a_start_where_a_range_excludes_the_one_that_is_taken() -> None:
    text = problem_files()["movable-pulley"].read_text(encoding="utf-8")
    text = re.sub(r'start\s*= "-h"', 'range = ["", "0"]', text)
    with pytest.raises(StatementError, match="but not where it begins"):
        derive(load_text(text), simulation=False)


def test_a_light_rod_may_push() -> None:
    found = derive(load_problem(problem_files()["coupled-cylinders-on-incline"]), simulation=False)
    assert not found.study.losses and found.summary()["refuted"] == 0


def test_the_time_goes_on_through_the_phases() -> None:
    found = derive(load_problem(problem_files()["cylinder-on-belt"]))
    assert found.summary()["proved"] == found.summary()["steps"]
    assert found.summary()["simulation"]["max_relative_error"] < 1e-8


def _train(count: int) -> str:
    """A cart that is pulled, with blocks on springs whose places are told from the cart: all are coupled."""
    blocks = range(count)
    lines = ['[parameters]\nm = "mass"\nM = "mass"\nk = "stiffness"\nF = "force"']
    lines += [f'[coordinates.{name}]\ndimension = "length"\nstart = "0"' for name in ("x", *(f"u_{i}" for i in blocks))]
    lines += ['[bodies.cart]\nshape = "particle"\nmass = "M"\ncenter = ["x", "0"]']
    lines += [f'[bodies.b{i}]\nshape = "particle"\nmass = "m"\ncenter = ["x + u_{i}", "0"]' for i in blocks]
    lines += [
        f'[interactions.S_{i}]\ntype = "spring"\nbetween = ["cart.center", "b{i}.center"]\nstiffness = "k"'
        for i in blocks
    ]
    return "\n".join([*lines, '[interactions.Q]\ntype = "force"\non = "cart.center"\nforce = ["F", "0"]\n'])


def test_more_than_three_coupled_coordinates_are_solved_for_where_that_is_short() -> None:
    system = Textbook(
        "train",
        _train(4),
        {
            "accelerations/x": "(F + k*(u_0 + u_1 + u_2 + u_3))/M",
            "accelerations/u_0": "-k*u_0/m - (F + k*(u_0 + u_1 + u_2 + u_3))/M",
        },
    )
    assert differences(system) == []
    assert complaints(system.text) == []


LINKED = """
[parameters]
L = "length"
M = "mass"
P = "force"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.y]
dimension = "length"
[bodies.a]
shape = "particle"
mass = "M"
center = ["x", "0"]
[bodies.b]
shape = "particle"
mass = "M"
center = ["y", "0"]
[interactions.D]
type = "force"
on = "a.center"
force = ["P", "0"]
[constraints.S]
type = "link"
points = ["a.center", "b.center"]
length = "L"
"""


@pytest.mark.parametrize("side", [-1, 1])
def test_on_which_side_a_link_along_a_line_holds_is_stated(side: int) -> None:
    with pytest.raises(StatementError, match="on which side"):
        derive(load_text(LINKED), simulation=False)
    begun = load_text(LINKED.replace("[bodies.a]", f'start = "{side}*L"\n[bodies.a]'))
    assert derive(begun, simulation=False).study.system.dependent["y"] == symbol("x") + symbol("L") * side
