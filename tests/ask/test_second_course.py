"""Conditions, both cases and strict bounds that fresh users asked for, with their answers by hand."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.ask.numbers import read_numbers
from rbpsym.ask.telling import record
from rbpsym.decide.equal import equal
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.typeset.machine import to_machine
from rbpsym.typeset.text import to_text
from tests.ask.test_first_course import PLATE

WEDGE = """
[parameters]
M = "mass: wedge"
m = "mass: block"
b = "length: base"
beta = "angle, acute: slope"
mu = "number < tan(beta): friction"
a = "acceleration: of the wedge"
g = "acceleration: gravity"
[coordinates.X]
dimension = "length"
[bodies.wedge]
shape = "triangle"
mass = "M"
base = "b"
height = "b*tan(beta)"
offset = "b/2"
middle = ["X", "0"]
angle = "0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["X", "b*tan(beta)/2"]
[interactions.W]
type = "gravity"
[constraints.R]
type = "slider"
point = "wedge.middle"
line = "y = 0"
[constraints.D]
type = "prescribed"
point = "wedge.middle"
distance = "-a*t**2/2"
[constraints.N]
type = "sticking"
point = "block.center"
line = "y = (x + b/2)*tan(beta)"
of = "wedge"
friction = "f"
limit = "mu"
"""
BULLET = """
[parameters]
M = "mass: wheel"
R = "length: radius"
m = "mass: bullet"
v = "speed: bullet"
[coordinates.phi]
start = "0"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v"
[coordinates.y]
dimension = "length"
start = "R"
[bodies.wheel]
shape = "disk"
mass = "M"
radius = "R"
center = "O"
angle = "phi"
points = { P = ["0", "R"] }
[bodies.bullet]
shape = "particle"
mass = "m"
center = ["x", "y"]
[constraints.F]
type = "pivot"
point = "wheel.center"
[[phases]]
name = "stuck"
event = "at once"
constraints = { J = { type = "pin", points = ["wheel.P", "bullet.center"] } }
"""
TURNED = """
[parameters]
I = "moment of inertia: wheel"
m = "mass: wheel"
C = "torque: drive"
D = "torque: load"
omega_0 = "angular speed: at the start"
[coordinates.phi]
start = "0"
speed = "omega_0"
[bodies.wheel]
shape = "given"
mass = "m"
moment = "I"
cm = "O"
angle = "phi"
[interactions.Q]
type = "couple"
on = "wheel"
couple = "C - D"
[constraints.F]
type = "pivot"
point = "wheel.cm"
"""


def test_the_least_friction_is_told_for_both_senses_in_which_it_may_slip() -> None:
    """N = m(g cos β + a sin β), f = m(g sin β - a cos β) up the slope."""
    [found] = ask(load_text(WEDGE), "smallest mu for which it does not slip")
    told = ["(g sin β − a cos β)/(a sin β + g cos β)", "(a cos β − g sin β)/(a sin β + g cos β)"]
    assert found.verdict.is_proved and [to_text(node) for node in found.nodes] == told
    assert [to_machine(each[0]) for each in found.each] == ["g*sin(beta) - a*cos(beta) > 0", "a*cos(beta) - g*sin(beta) > 0"]


@pytest.mark.parametrize(("question", "value"), [
    ("time until phi = -pi in phase stuck", "pi*R*(M + 2*m)/(2*m*v)"),
    ("velocity of bullet.cm where phi = -pi/3 in phase stuck", "(m*v/(M + 2*m), -m*v*sqrt(3)/(M + 2*m))"),
])  # fmt: skip
def test_what_follows_from_a_coordinate_that_turns_uniformly(question: str, value: str) -> None:
    [found] = ask(load_text(BULLET), question)
    assert found.verdict.is_proved and found.text == value


@pytest.mark.parametrize(("drive", "load"), [(3.0, 1.0), (1.0, 1.2)])
def test_what_sets_out_that_way_comes_there_faster_or_slower(drive: float, load: float) -> None:
    """q̈ = C - D of either sign: the way 1 from a speed of 2 is done where 4 + 2 (C - D) is not negative."""
    problem = load_text(TURNED)
    [found] = ask(problem, "speed of phi where phi = 1")
    assert found.verdict.is_proved and "I*omega_0**2 + 2*C - 2*D >= 0" in [to_machine(node) for node in found.valid]
    numbers = read_numbers(f"I = 1 kg m^2, m = 1 kg, C = {drive} N m, D = {load} N m, omega_0 = 2 rad/s", problem)
    assert record(found, numbers)["value"] == pytest.approx((4 + 2 * (drive - load)) ** 0.5, rel=1e-3)


def test_what_is_positive_is_not_zero() -> None:
    [found] = ask(load_text(TURNED), "C for which acceleration of phi is positive")
    assert found.verdict.is_proved and (found.relation, found.text) == (">", "D")


def test_a_mass_asks_nothing_of_the_motion() -> None:
    force, mass = ask(load_text(WEDGE), "f", "mass of block")
    assert force.valid and not mass.valid and mass.text == "m"


def test_the_ratio_of_a_quantity_to_itself_is_not_told() -> None:
    with pytest.raises(StatementError, match="both parts"):
        ask(load_text(PLATE), "ratio of period of theta to period of theta with a = b")


LIFT = """
[parameters]
m_1 = "mass: cab"
m_2 = "mass: counterweight"
H = "length: depth"
g = "acceleration: gravity"
[coordinates.y]
dimension = "length"
start = "0"
[bodies.cab]
shape = "particle"
mass = "m_1"
center = ["0", "-H + y"]
[bodies.weight]
shape = "particle"
mass = "m_2"
center = ["0", "-H - y"]
[interactions.W]
type = "gravity"
[constraints.T]
type = "string"
path = ["cab.center", { around = "O" }, "weight.center"]
"""
BEAD = """
[parameters]
m = "mass: bead"
M = "mass: rod"
b = "length: rod"
k = "stiffness: spring"
ell = "length < b: natural"
Omega = "angular speed: rod"
[coordinates.phi]
[coordinates.r]
dimension = "length"
start = "ell"
range = ["0", ""]
[bodies.rod]
shape = "rod"
mass = "M"
length = "b"
start = "O"
angle = "phi"
[bodies.bead]
shape = "particle"
mass = "m"
center = ["r*cos(phi)", "r*sin(phi)"]
[interactions.S]
type = "spring"
between = ["O", "bead.center"]
stiffness = "k"
natural_length = "ell"
[constraints.F]
type = "pivot"
point = "rod.start"
[constraints.C]
type = "prescribed-angle"
body = "rod"
angle = "Omega*t"
[constraints.N]
type = "guide"
point = "bead.center"
line = "y = 0"
of = "rod"
"""


def test_a_string_that_runs_out_at_last_holds_until_then() -> None:
    """a = g(m_2 - m_1)/(m_1 + m_2); each of the weights stays below the peg while H ± a t²/2 is not negative."""
    [found] = ask(load_text(LIFT), "y as a function of t")
    told = {"H*(m_1 + m_2)*2 + g*t**2*(m_1 - m_2) >= 0", "H*(m_1 + m_2)*2 + g*t**2*(m_2 - m_1) >= 0"}
    assert found.verdict.is_proved and len(found.valid) == 2
    names = ("H", "m_1", "m_2", "g", "t")
    gaps = [[equal(node.items[0], read_infix(text.split(" >=")[0], names)).is_proved for text in told] for node in found.valid]
    assert sorted(map(sum, gaps)) == [1, 1]


def test_a_coordinate_that_is_driven_has_its_time_though_others_move() -> None:
    [found] = ask(load_text(BEAD), "time until phi = pi")
    assert found.verdict.is_proved and found.text == "pi/Omega" and not found.valid


def test_a_place_of_rest_has_no_condition_that_contradicts_it() -> None:
    [found] = ask(load_problem("bead-on-parabola"), "N in equilibrium")
    assert not any("!=" in to_machine(node) for node in found.valid)
