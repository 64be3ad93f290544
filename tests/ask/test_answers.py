"""Questions of textbooks about problems of the library, with the answers that the books give."""

from __future__ import annotations

from functools import cache

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.field.roots import without_even_roots
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.numbers import number, sample
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, load_text

ANSWERS = [
    ("brake-drum", "speed of phi after 2 turns", "sqrt(omega_0^2 - 8*pi*mu*P*r*ell/(I*a))"),
    ("brake-drum", "total angle of phi", "I*a*omega_0^2/(2*mu*P*r*ell)"),
    ("sliding-ladder", "N_w", "3*M*g*cos(theta)*(3*sin(theta) - 2*sin(theta_0))/4"),
    ("sliding-ladder", "what is N_w at the start?", "3*M*g*sin(theta_0)*cos(theta_0)/4"),
    ("rod-pendulum", "angular velocity of theta where theta = 0", "-sqrt(3*g*(1 - cos(theta_0))/ell)"),
    ("rod-pendulum", "y component of acceleration of the centre of mass at the start", "-3*g*sin(theta_0)^2/4"),
    ("bullet-in-a-rod", "x component of velocity of the centre of mass of the system at the start", "m*v_0/(M + m)"),
    ("sliding-ladder", "angular velocity of ladder", "sqrt(3*g*(sin(theta_0) - sin(theta))/(2*ell))"),
    ("sliding-ladder", "theta where N_w vanishes", "asin(2*sin(theta_0)/3)"),
    ("sliding-ladder", "theta_dot where N_w vanishes", "-sqrt(g*sin(theta_0)/(2*ell))"),
    ("sliding-ladder", "work of W from the start to where N_w vanishes", "M*g*ell*sin(theta_0)/3"),
    ("rod-pendulum", "period of theta", "2*pi*sqrt(2*ell/(3*g))"),
    ("rod-pendulum", "F_y in equilibrium", "M*g"),
    ("rod-pendulum", "component of force F on rod across rod at the start", "M*g*sin(theta_0)/4"),
    ("rod-pendulum", "radial component of force F on rod about O where theta = 0", "M*g*(3*cos(theta_0) - 5)/2"),
    ("rod-pendulum", "dL/dt", "-M*g*ell*sin(theta)/2"),
    ("rod-pendulum", "speed of rod(2/3) where theta = 0", "2*sqrt(g*ell*(1 - cos(theta_0))/3)*1"),
    ("rod-pendulum", "angular velocity of rod", "-sqrt(3*g*(cos(theta) - cos(theta_0))/ell)"),
    ("rod-pendulum", "direction of velocity of rod.cm where theta = 0", "pi"),
    ("rod-pendulum", "component of acceleration of rod.end across rod", "-3*g*sin(theta)/2"),
    ("rod-pendulum", "y component of velocity of rod.end relative to rod.cm at the start", "0"),
    ("disk-on-incline", "s as a function of phi", "R*phi"),
    ("falling-stick", "N where theta = pi/2", "M*g/4"),
    ("falling-stick", "speed of stick.cm where theta = pi/2", "sqrt(3*g*ell)/2"),
    ("center-of-percussion", "angular velocity of rod right after the blow B", "3*J*b/(M*ell^2)"),
    ("center-of-percussion", "turning point of theta", "acos(1 - 3*J^2*b^2/(M^2*g*ell^3))"),
    ("center-of-percussion", "horizontal linear momentum of rod right after struck", "3*J*b/(2*ell)"),
    ("sliding-ladder", "work of W until N_w vanishes", "M*g*ell*sin(theta_0)/3"),
    ("center-of-percussion", "impulse of F_x when struck begins", "J*(3*b/(2*ell) - 1)"),
    ("ball-slipping-to-rolling", "time until rolling", "2*v_0/(7*mu*g)"),
    ("ball-slipping-to-rolling", "x component of velocity of ball.cm when rolling begins", "5*v_0/7"),
    ("ball-slipping-to-rolling", "work of f until rolling", "-M*v_0^2/7"),
    ("ball-slipping-to-rolling", "friction f in phase rolling", "0"),
    ("cylinder-off-cylinder", "theta where N vanishes", "acos(4/7)"),
    ("cylinder-off-cylinder", "speed of cylinder.cm where N vanishes", "sqrt(4*g*(R + r)/7)"),
    ("ball-off-sphere", "theta where N vanishes", "acos(10/17)"),
    ("ball-off-sphere", "horizontal velocity of ball.cm where N vanishes", "10*sqrt(170*g*(a + R))/289"),
    ("block-sliding-or-tipping", "time until x comes to rest", "m*v_0/(mu*m*g - P)"),
    ("rod-with-damper", "decay rate of theta", "3*c/(2*M*ell^2)"),
    ("falling-hinged-stick", "speed of stick.end where theta = 0", "sqrt(3*g*ell*sin(theta_0))"),
    ("disk-on-incline", "acceleration of s", "2*g*sin(beta)/3"),
    ("disk-on-incline", "friction coefficient needed at N", "tan(beta)/3"),
    ("rod-on-two-strings", "tension T at the start", "M*g/4"),
    ("disk-on-incline", "s as a function of t", "g*t^2*sin(beta)/3"),
    ("yo-yo", "tension T", "M*g*R^2/(R^2 + 2*b^2)"),
]  # fmt: skip


FALL = """
[parameters]
m = "mass"
g = "acceleration"
v_0 = "speed"
h = "length"
[coordinates]
x = { dimension = "length", start = "0", speed = "v_0" }
y = { dimension = "length", start = "h", speed = "0" }
[bodies.p]
shape = "particle"
mass = "m"
center = ["x", "y"]
[interactions.W]
type = "gravity"
"""
FALLS = [
    ("time of flight until y = 0", "sqrt(2*h/g)"),
    ("x where y = 0", "v_0*sqrt(2*h/g)"),
    ("vertical velocity of p where y = 0", "-sqrt(2*g*h)"),
    ("direction of velocity of p where y = 0", "-atan(sqrt(2*g*h)/v_0)"),
    ("work of W until y = 0", "m*g*h"),
    ("y as a function of t", "h - g*t^2/2"),
]


@pytest.mark.parametrize(("question", "told"), FALLS)
def test_a_fall_comes_to_the_floor(question: str, told: str) -> None:
    """Both coordinates move; the time comes first, and all else from it."""
    problem = load_text(FALL)
    found = answered(Asked(problem), question)
    numbers = sample(problem) | {"t": 0.7}
    expected = scalar(read_infix(told, ["m", "g", "v_0", "h", "t"]))
    assert found.verdict.is_proved, found.verdict
    assert number(found.value, numbers) == pytest.approx(number(expected, numbers))


@cache
def asked(name: str) -> Asked:
    return Asked(load_problem(find_problem(name)))


@pytest.mark.parametrize(("name", "question", "told"), ANSWERS, ids=lambda value: str(value))
def test_answers_are_those_of_the_books(name: str, question: str, told: str) -> None:
    """The value has the square of the one told, and its sign; each is proved by steps."""
    found = answered(asked(name), question)
    expected = scalar(read_infix(told, [*asked(name).whole.names, "t"]))
    assert is_zero(short(without_even_roots(found.value * found.value - expected * expected)))
    numbers = sample(found.study.problem) | {"t": 0.7}
    assert number(found.value, numbers) == pytest.approx(number(expected, numbers))
    assert found.verdict.is_proved, found.verdict
    assert found.steps and all(step.certificate.verdict.is_proved for step in found.steps)
