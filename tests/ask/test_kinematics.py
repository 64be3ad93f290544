"""Motions that are given need no masses: what is asked of them is told, and what hangs on a mass is refused."""

import pytest

from rbpsym import ask, derive, load_text
from rbpsym.errors import StatementError

WHEEL = """
[parameters]
R = "length: radius"
v = "speed: of the axle"
a = "acceleration: of the axle"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v"
{more}
[coordinates.phi]
start = "0"
[bodies.wheel]
shape = "disk"
radius = "R"
center = ["x", "R"]
angle = "-phi"
points = {{ P = ["0", "R"] }}
[constraints.N]
type = "rolling"
body = "wheel"
line = "y = 0"
"""
COLLAR = """
[parameters]
b = "length"
u = "speed"
a = "acceleration"
omega = "angular speed"
alpha = "angular acceleration"
[coordinates.theta]
start = "0"
speed = "omega"
acceleration = "alpha"
[coordinates.r]
dimension = "length"
start = "b"
speed = "u"
acceleration = "a"
[bodies.arm]
shape = "rod"
length = "2*b"
start = "O"
angle = "theta"
[bodies.collar]
shape = "particle"
center = ["r*cos(theta)", "r*sin(theta)"]
"""
FOUR_BAR = """
[parameters]
a = "length"
d = "length"
Omega = "angular speed"
[coordinates.theta]
start = "pi/2"
speed = "Omega"
[coordinates.beta]
start = "0"
[coordinates.gamma]
start = "3*pi/4"
[points]
C = ["a + d", "0"]
[bodies.crank]
shape = "rod"
length = "a"
start = "O"
angle = "theta"
[bodies.coupler]
shape = "rod"
length = "d"
start = "crank.end"
angle = "beta"
[bodies.rocker]
shape = "rod"
length = "sqrt(2)*a"
start = "C"
angle = "gamma"
[constraints.E]
type = "pin"
points = ["coupler.end", "rocker.end"]
"""
ROD = """
[parameters]
L = "length"
u = "speed: of the foot"
[coordinates.theta]
start = "theta_0"
speed = "u/(L*sin(theta_0))"
[bodies.rod]
shape = "rod"
length = "L"
start = ["L*cos(theta)", "0"]
angle = "pi - theta"
"""
LADDER = """
[parameters]
L = "length"
v = "speed: of the foot"
[coordinates.x]
dimension = "length"
start = "L/4"
speed = "v"
[coordinates.theta]
range = ["0", "pi/2"]
[bodies.ladder]
shape = "rod"
length = "L"
start = ["x", "0"]
angle = "pi - theta"
[constraints.A]
type = "contact"
point = "ladder.start"
line = "y = 0"
[constraints.B]
type = "contact"
point = "ladder.end"
line = "x = 0"
"""
PLANET = """
[parameters]
a = "length: radius of the sun"
b = "length: radius of the planet"
omega = "angular speed: of the sun"
[coordinates.alpha]
start = "0"
speed = "omega"
[coordinates.theta]
start = "0"
[coordinates.phi]
start = "0"
[bodies.sun]
shape = "disk"
radius = "a"
center = "O"
angle = "alpha"
[bodies.spider]
shape = "rod"
length = "a + b"
start = "O"
angle = "theta"
[bodies.planet]
shape = "disk"
radius = "b"
center = "spider.end"
angle = "phi"
points = { P = ["b", "0"] }
[constraints.G]
type = "gear"
body = "planet"
circle = "sun.center"
[constraints.H]
type = "gear"
body = "planet"
circle = "O"
radius = "a + 2*b"
side = "inside"
"""
SPOOL = """
[parameters]
R = "length"
r = "length < R"
d = "length > R"
v = "speed"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.phi]
start = "0"
[coordinates.s]
dimension = "length"
start = "d"
speed = "v"
[bodies.spool]
shape = "disk"
radius = "R"
center = ["x", "R"]
angle = "-phi"
points = { top = ["0", "R"] }
[bodies.hand]
shape = "particle"
center = ["s", "R - r"]
[constraints.N]
type = "rolling"
body = "spool"
line = "y = 0"
[constraints.T]
type = "string"
path = [{ around = "spool", radius = "r", sense = "ccw" }, "hand.center"]
"""
STEADY, GROWING = WHEEL.format(more=""), WHEEL.format(more='acceleration = "a"')


@pytest.mark.parametrize(
    ("text", "question", "wanted"),
    [
        (STEADY, "velocity of wheel.P where phi = pi/2", "(v, -v)"),
        (STEADY, "acceleration of wheel.P at the start", "(0, -v**2/R)"),
        (STEADY, "angular velocity of wheel", "-v/R"),
        (GROWING, "acceleration of wheel.P at the start", "(2*a, -v**2/R)"),
        (GROWING, "speed of wheel.P where x = R*pi", "0"),
        (COLLAR, "acceleration of collar at the start", "(a - b*omega**2, b*alpha + 2*u*omega)"),
        (FOUR_BAR, "angular velocity of coupler at the start", "-a*Omega/d"),
        (FOUR_BAR, "angular acceleration of rocker at the start", "Omega**2*(1 + a/d)"),
        (LADDER, "velocity of ladder.end where theta = pi/6", "(0, -v*sqrt(3))"),
        (PLANET, "angular velocity of spider", "a*omega/(2*(a + b))"),
        (PLANET, "velocity of planet.P at the start", "(0, 0)"),
        (SPOOL, "velocity of spool.top at the start", "(2*R*v/(R - r), 0)"),
        (SPOOL, "time until phi = 2*pi", "2*pi*(R - r)/v"),
        (GROWING, "time until angular velocity of wheel = -2*v/R", "v/a"),
        (FOUR_BAR.replace("constraints.E", "constraints.C"), "speed of rocker.end at the start", "a*Omega*sqrt(2)"),
        (FOUR_BAR, "instantaneous centre of coupler at the start", "(0, a + d)"),
    ],
)
def test_a_given_motion_needs_no_masses(text: str, question: str, wanted: str) -> None:
    [found] = ask(load_text(text), question)
    assert found.verdict.is_proved
    assert found.text.replace(" ", "") == wanted.replace(" ", "")


@pytest.mark.parametrize(
    ("text", "question", "said"),
    [
        (STEADY, "N", "it hangs on masses"),
        (STEADY, "kinetic energy", "hangs on masses, which are not stated (m_wheel)"),
        (ROD, "acceleration of rod.end at the start", "the acceleration of theta is not stated"),
    ],
)
def test_what_hangs_on_a_mass_is_refused(text: str, question: str, said: str) -> None:
    with pytest.raises(StatementError) as refused:
        ask(load_text(text), question)
    assert said in refused.value.what


def test_a_speed_that_hangs_on_the_place_is_that_of_the_start_alone() -> None:
    [found] = ask(load_text(ROD), "velocity of rod.end at the start")
    assert found.verdict.is_proved


def test_nothing_is_said_of_forces() -> None:
    found = derive(load_text(GROWING))
    assert found.steps and all(step.certificate.verdict.is_proved for step in found.steps)
    assert found.lagrange is None


def test_letters_that_stand_for_what_is_not_stated_meet_none_of_the_authors():
    """The author's m_wheel is a length, and a constraint is called D_x."""
    text = WHEEL.format(more='acceleration = "a"').replace("[coordinates.x]", 'm_wheel = "length: tread"\n[coordinates.x]', 1)
    other = {'radius = "R"': 'radius = "R + m_wheel"', '["x", "R"]': '["x", "R + m_wheel"]', "constraints.N": "constraints.D_x"}
    for old, new in other.items():
        text = text.replace(old, new)
    [found] = ask(load_text(text), "angular acceleration of wheel")
    assert found.verdict.is_proved and found.text == "-a/(R + m_wheel)"
