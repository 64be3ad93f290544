"""Bounds of one side among several, what grows where no question says so, shapes of modes, what is led round: worked out by hand
before the engine was asked.

Hibbeler 8, 17; Beer & Johnston 16; Taylor 11; Serway 6; Irodov 1.3.
"""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.typeset.machine import to_machine
from tests.ask.test_unseen import asked
from tests.ask.test_unseen import test_it_finds_what_is_worked_out_by_hand as found

ANSWERS = (
    ("pulled-up-slope", "smallest P for which it slips", "M*g*(sin(beta) + mu*cos(beta))"),
    ("pulled-up-slope", "smallest P for which it tips", "M*g*(H*sin(beta) + b*cos(beta))/(2*h)"),
    ("pulled-up-slope", "largest h for which it slips before it tips",
     "(H*sin(beta) + b*cos(beta))/(2*(sin(beta) + mu*cos(beta)))"),
    ("forklift", "largest deceleration for which N_B >= 0", "g*(M*c - m*d)/(M*h_1 + m*h_2)"),
    ("sprung-cart-pendulum", "ratio of x to theta in the lowest mode with M = m, k = m*g/l", "l*(1 + sqrt(5))/2"),
    ("sprung-cart-pendulum", "lowest frequency with M = m, k = m*g/l", "sqrt((3 - sqrt(5))*g/(2*l))"),
    ("swing-on-rope", "largest theta_0 for which T stays below T_max", "acos((3 - T_max/(m*g))/2)"),
    ("wheel-on-spring", "largest amplitude of x for which it does not slip", "3*mu*m*g/k"),
    ("dryer", "Omega for which N vanishes where theta = 7*pi/18", "sqrt(g*sin(7*pi/18)/R)"),
    ("dryer", "smallest Omega for which N stays positive", "sqrt(g/R)"),
    ("slipping-spool", "smallest beta for which the spool begins to move", "atan(mu*(1 + R/r))"),
    ("block-on-sprung-slope", "time until the block stops", "pi*sqrt(m/k)"),
    ("grinding-wheel", "time until the wheel stops", "I/c*ln(1 + c*omega_0/M_f)"),
    ("grinding-wheel", "angle turned by wheel until the wheel stops", "-(I*M_f/c**2*ln(1 + c*omega_0/M_f) - I*omega_0/c)"),
    ("hoop-with-body", "smallest v_0 for which phi reaches pi", "sqrt(2*m*g*R/M)"),
    ("pull-that-grows", "time until slipping", "mu*m_2*g*(m_1 + m_2)*T_1/(q*m_1)"),
    ("pull-that-grows", "acceleration of x in phase slipping", "mu*m_2*g/m_1"),
    ("skaters-on-rope", "work of T until r = r_0/2", "3*m*v**2"),
    ("beam-on-forces", "frequency of theta", "sqrt(6*k/M)"),
    ("collar-beside-hook", "speed of y where y = 3*b/4", "sqrt(3*g*b/2 - k*b**2/(16*m))"),
    ("collar-beside-hook", "k for which y comes to rest at y = 3*b/4", "24*m*g/b"),
    ("collar-beside-hook", "k for which y where y comes to rest = 3*b/4", "24*m*g/b"),
    ("wheel-on-spring", "x component of velocity of disk.top as a function of the state", "2*x_dot"),
    ("wheel-on-spring", "y component of acceleration of disk.bottom as a function of the state", "x_dot**2/R"),
    ("rod-on-wire", "length of the simple pendulum with equal period", "L/6"),
)  # fmt: skip


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: str(value)[:60])
def test_it_finds_what_is_worked_out_by_hand(name: str, question: str, worked_out: str) -> None:
    found(name, question, worked_out)


def test_where_else_it_slips_is_said_beside_the_smallest_pull() -> None:
    """Downwards, under a pull that is too small."""
    answer = answered(asked("pulled-up-slope"), "smallest P for which it slips")
    assert answer.verdict.is_proved
    assert answer.says.startswith("“it slips” holds for P < ")


def test_a_bound_has_the_sign_of_what_it_bounds() -> None:
    """A rough slope holds the block without any pull; what followed from a condition that was left out stands without it."""
    answer = answered(asked("pulled-up-slope"), "smallest P for which it does not slip")
    assert answer.verdict.is_proved
    assert "sin(beta) - mu*cos(beta) > 0" in map(to_machine, answer.valid)


def test_on_which_side_of_its_hook_a_spring_is_is_a_condition_where_no_start_says_it() -> None:
    answer = answered(asked("block-on-unsaid-spring"), "acceleration of x")
    assert answer.verdict.is_proved
    assert "x > 0" in map(to_machine, answer.valid)
