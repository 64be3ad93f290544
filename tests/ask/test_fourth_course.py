"""Limits and bounds of which a question names no parameter, what a resistance leaves at last, and forces between: worked out
by hand before the engine was asked.

Kleppner & Kolenkow 2, 6, 7; Morin 5, 8; Meriam & Kraige 3, 6, 8; Beer & Johnston 8, 12, 16, 19; Irodov 1.2, 1.3; French 3.
"""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.errors import StatementError
from tests.ask.test_unseen import asked
from tests.ask.test_unseen import test_it_finds_what_is_worked_out_by_hand as found

ANSWERS = (
    # which of two limits comes first
    ("push-at-height", "H for which it tips before it slips", "b/(2*mu)"),
    ("push-at-height", "smallest mu for which the crate tips before it slips", "b/(2*H)"),
    ("push-at-height", "largest H for which it slips before it tips as P grows", "b/(2*mu)"),
    ("push-at-height", "largest P for which it neither slips nor tips", "mu*m*g"),
    ("push-at-height", "smallest mu for which the crate stays at rest", "P/(m*g)"),
    ("push-and-lift", "mu for which it tips before it slips as P grows", "b*(m*g - 2*F)/(2*H*(m*g - F))"),
    ("block-on-incline", "mu for which it tips before it slips", "b/h"),
    ("block-on-incline", "largest h for which the block slips before it tips", "b/mu"),
    # bounds of quantities
    ("stacked-and-hung", "largest acceleration of x for which it does not slip", "mu*g"),
    ("stacked-and-hung", "largest m for which the top does not slip", "mu*(m_1 + m_2)/(1 - mu)"),
    ("stacked-and-hung", "largest tension for which it does not slip", "mu*g*(m_1 + m_2)"),
    # what is least under a condition of its own
    ("ring-with-beads", "least T", "M*g - 2*m*g/3"),
    ("ring-with-beads", "theta where T is least", "acos(1/3)"),
    ("ring-with-beads", "smallest m for which T vanishes", "3*M/2"),
    # motions as functions of the time
    ("critical-blow", "time until x comes to rest", "sqrt(m/k)"),
    ("critical-blow", "x where x comes to rest", "v_0*sqrt(m/k)*exp(-1)"),
    ("overdamped", "time until x comes to rest", "sqrt(m/k)*ln(2)"),
    ("overdamped", "x where x comes to rest", "v_0*sqrt(m/k)/4"),
    ("drag-on-slope", "terminal speed of s", "m*g*(sin(beta)-mu*cos(beta))/c"),
    # bodies that rise, and what stays
    ("geared-winch", "smallest tau for which the load rises", "m*g*r*r_1/r_2"),
    ("geared-winch", "tau for which y stays constant", "m*g*r*r_1/r_2"),
    # a sense that a start of either sign tells
    ("turning-parabola", "speed of x where x = 0", "-x_0*sqrt(g/p - Omega**2)"),
    # what a place asks for where no formula tells where it would stop; roots in inverse functions; shapes of modes
    ("spring-launch-up", "smallest d for which s reaches 0", "2*m*g*(sin(beta)+mu*cos(beta))/k"),
    ("stiff-hinge", "speed of theta where theta = -pi/2", "-sqrt(3*(m*g*L-pi*tau)/(m*L**2))"),
    ("stiff-hinge", "energy lost until theta = -pi/2", "tau*pi/2"),
    ("stiff-hinge", "tau for which theta comes to rest at -pi/2", "m*g*L/pi"),
    ("unbalanced-machine", "Omega for which the phase of y = pi/2", "sqrt(k/(M+m))"),
    ("two-on-cart", "ratio of theta_2 to theta_1 in the highest mode", "1"),
    ("two-on-cart", "ratio of theta_1 to x in the highest mode", "-(M+2*m)/(2*m*L)"),
    ("rods-that-fold", "speed of left.end just before theta = 0", "sqrt(3*g*L*sin(beta_0))"),
    ("bowl-that-slides", "x where theta = pi/2", "-2*m*R/(M+m)"),
    ("chimney", "largest magnitude of tau over a", "m*g*L/27"),
    ("chimney", "largest magnitude of tau over a where theta = pi/2", "m*g*L/27"),
    ("chimney", "a for which the largest magnitude of tau is largest", "L/3"),
    # by how much a spring is longer; a place where what pulls has no value is no steady motion
    ("masses-let-go", "speed of x_2 where elongation of S = 0", "d*sqrt(k*m_1/(m_2*(m_1+m_2)))"),
    ("masses-let-go", "time until S reaches its natural length", "pi/2*sqrt(m_1*m_2/(k*(m_1+m_2)))"),
    ("masses-let-go", "ratio of kinetic energy of left to kinetic energy of right", "m_2/m_1"),
    ("bob-on-slack-spring", "speed of bob where elongation of S = m*g/k", "g*sqrt(m/k)"),
    ("bead-on-cycloid", "frequency of q", "sqrt(g/R)/2"),
    ("wheel-before-step", "smallest P for which N vanishes", "M*g*sqrt(2*R*h-h**2)/(R-h)"),
    # a constant power from rest
    ("car-of-one-power", "time until speed of x = v_1", "m*v_1**2/(2*P)"),
    ("car-of-one-power", "x where speed of x = v_1", "m*v_1**3/(3*P)"),
    ("held-by-string", "smallest mu for which it does not slip", "tan(beta/2)"),
    ("rod-with-beads", "speed of phi as a function of r", "omega_0*(M*L**2/3+2*m*r_0**2)/(M*L**2/3+2*m*r**2)"),
    ("ball-off-wall", "ratio of energy lost until rolling to kinetic energy at the start", "40/49"),
)  # fmt: skip


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: value[:60])
def test_it_finds_what_is_worked_out(name: str, question: str, worked_out: str) -> None:
    found(name, question, worked_out)


def test_a_start_of_either_sign_needs_no_case() -> None:
    answer = answered(asked("turning-parabola"), "speed of x where x = 0")
    assert all(op == "!=" for node in answer.valid for op in node.ops)


def test_whether_one_limit_comes_first_is_told_with_its_condition() -> None:
    answer = answered(asked("push-at-height"), "does it tip before it slips")
    assert answer.verdict.is_proved and answer.holds_so is None and answer.valid


@pytest.mark.parametrize(
    ("name", "question", "said"),
    [
        ("push-at-height", "P for which it tips before it slips", "no parameter is known whose growth"),
        ("push-and-lift", "mu for which it tips before it slips", "depends on which of F, P grows"),
        ("stacked-and-hung", "smallest mu for which it stays at rest", "is not decided by its contacts"),
        ("stacked-and-hung", "largest magnitude of N for which it does not slip", "no parameter is known"),
    ],
)
def test_what_no_parameter_bounds_gets_a_sentence(name: str, question: str, said: str) -> None:
    with pytest.raises(StatementError, match=said):
        answered(asked(name), question)
