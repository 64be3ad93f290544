"""Forces and couples against a motion, drives: their values by hand, their senses through phases, and what is refused."""

from __future__ import annotations

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.ask.found import Answer
from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.at_start import study_of
from rbpsym.oracles.lagrange import lagrange_verdict
from rbpsym.oracles.simulation import simulate_study
from rbpsym.statement.loader import load_text

BLOCK = """
[parameters]
m = "mass"
F = "force"
k = "stiffness"
v_0 = "speed"
u = "speed"
c = "damping"
[coordinates.x]
dimension = "length"
start = "0"
{start}
[bodies.block]
shape = "particle"
mass = "m"
center = ["x", "0"]
[interactions.D]
type = "resistance"
on = "block.center"
{more}
"""
WHEEL = """
[parameters]
m = "mass"
R = "length"
b = "length < R"
g = "acceleration"
v_0 = "speed"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v_0"
[coordinates.phi]
[bodies.wheel]
shape = "disk"
mass = "m"
radius = "R"
center = ["x", "R"]
angle = "-phi"
[interactions.W]
type = "gravity"
[interactions.C]
type = "resisting-couple"
between = ["ground", "wheel"]
size = "{size}"
[constraints.N]
type = "rolling"
body = "wheel"
line = "y = 0"
friction = "f"
"""
MOVING, RESTING = 'speed = "v_0"', ""
BACK = """[interactions.S]
type = "spring"
between = ["O", "block.center"]
stiffness = "k"
[[phases]]
name = "back"
event = "rests"
of = "x"
interactions = { D = { toward = ["-1", "0"] } }
"""


def is_value(found: Answer, wanted: str) -> bool:
    expected = scalar(read_infix(wanted, {*found.study.letters.quantities, "t"}), found.study.system.scope)
    return scalars_equal(found.value, expected, found.study.assumptions).is_proved


def block(more: str, start: str = MOVING) -> Asked:
    return Asked(load_text(BLOCK.format(start=start, more=more), "block.toml"))


def wheel(size: str = "b*N") -> Asked:
    return Asked(load_text(WHEEL.format(size=size), "wheel.toml"))


VALUES = [
    (block('size = "F"'), "x where x comes to rest", "m*v_0**2/(2*F)"),
    (block('size = "F"\n' + BACK), "acceleration of x in phase back", "(F-k*x)/m"),
    (block('size = "c*v"\nmedium = ["u", "0"]'), "acceleration of x", "-c*(x_dot-u)/m"),
    (block('size = "F"'), "energy lost until x comes to rest", "m*v_0**2/2"),
    (wheel(), "x where x comes to rest", "3*R*v_0**2/(4*b*g)"),
    (wheel(), "f", "-2*m*b*g/(3*R)"),
]


@pytest.mark.parametrize(("asked", "question", "value"), VALUES, ids=lambda value: value if isinstance(value, str) else "")
def test_what_is_resisted_moves_as_by_hand(asked: Asked, question: str, value: str) -> None:
    found = answered(asked, question)
    assert found.verdict.is_proved
    assert is_value(found, value)


REFUSED = [
    ('size = "F"', RESTING, "nothing moves there"),
    ('size = "F"\ntoward = ["-1", "0"]', MOVING, "moves the other way"),
    ('size = "F"\ntoward = ["0", "1"]', RESTING, "nothing moves there"),
    ('size = "-F"', MOVING, "must be nonnegative"),
    ('size = "N"', MOVING, "unknown symbol"),
]


@pytest.mark.parametrize(("more", "start", "told"), REFUSED)
def test_a_resistance_without_a_sense_or_a_size_gets_a_sentence(more: str, start: str, told: str) -> None:
    with pytest.raises(RbpsymError) as caught:
        answered(block(more, start), "acceleration of x")
    assert told in str(caught.value)


@pytest.mark.parametrize(("size", "told"), [("b*sqrt(N**2 + f**2)", "not linear"), ("-b*N", "must be nonnegative"), ("b*T", "T")])
def test_a_couple_of_unknown_forces_is_linear_in_them_and_no_negative_size(size: str, told: str) -> None:
    with pytest.raises(RbpsymError) as caught:
        answered(wheel(size), "f")
    assert told in str(caught.value)


def test_the_letter_of_the_speed_means_nothing_else() -> None:
    text = BLOCK.format(start=MOVING, more='size = "c*v"').replace('v_0 = "speed"', 'v_0 = "speed"\nv = "speed"')
    with pytest.raises(StatementError, match="which is the speed there"):
        load_text(text, "block.toml")


def test_a_multiple_of_the_speed_needs_no_sense() -> None:
    assert study_of(block('size = "c*v"', RESTING).problem).dynamics.accelerations


def test_dry_friction_tells_no_equilibrium_and_no_last_speed() -> None:
    text = BLOCK.format(start=MOVING, more='size = "F"\n' + BACK.partition("[[phases]]")[0])
    assert study_of(load_text(text, "block.toml")).equilibria == ()


DRIVEN = {
    "winch": """
[coordinates.y]
dimension = "length"
range = ["0", ""]
[bodies.load]
shape = "particle"
mass = "m"
center = ["0", "-y"]
[interactions.W]
type = "gravity"
[constraints.T]
type = "string"
path = ["O", "load.center"]
length = "h - a*t**2/2"
""",
    "telescope": """
[coordinates.theta]
start = "0"
speed = "omega_0"
[bodies.load]
shape = "particle"
mass = "m"
center = ["(h + u*t)*cos(theta)", "(h + u*t)*sin(theta)"]
[constraints.S]
type = "link"
points = ["O", "load.center"]
length = "h + u*t"
""",
    "bead": """
[coordinates.phi]
start = "0"
speed = "omega_0"
[coordinates.x]
dimension = "length"
start = "h"
speed = "-u"
[coordinates.y]
dimension = "length"
start = "0"
[bodies.arm]
shape = "given"
mass = "M"
moment = "I"
center = "O"
angle = "phi"
[bodies.load]
shape = "particle"
mass = "m"
center = ["x", "y"]
[constraints.F]
type = "pivot"
point = "arm.center"
[constraints.N]
type = "guide"
point = "load.center"
line = "y = 0"
of = "arm"
[constraints.D]
type = "prescribed"
point = "load.center"
of = "arm"
distance = "h - u*t"
""",
}
CONSTANTS = """
[parameters]
m = "mass"
M = "mass"
I = "moment of inertia"
h = "length"
a = "acceleration"
g = "acceleration"
u = "speed"
omega_0 = "angular speed"
"""
AT_START = [
    ("winch", "T", "m*(g+a)"),
    ("telescope", "S at the start", "m*h*omega_0**2"),
    ("bead", "D at the start", "-m*h*omega_0**2"),
]


@pytest.mark.parametrize(("name", "force", "value"), AT_START)
def test_what_is_driven_takes_the_force_by_hand_and_the_oracles_agree(name: str, force: str, value: str) -> None:
    asked = Asked(load_text(CONSTANTS + DRIVEN[name], f"{name}.toml"))
    assert is_value(answered(asked, force), value)
    study = asked.first
    assert lagrange_verdict(study.system, study.dynamics, study.assumptions).is_proved
    assert simulate_study(study).max_relative_error < 1e-6
