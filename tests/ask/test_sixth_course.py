"""Problems of mechanics stated from the documentation alone, with answers worked out by hand first: strings over pegs with roots
in their lengths, light rods, coordinates that others lead, times of endings, places as functions of places, forms with surds.

Kleppner & Kolenkow 2, 6; Irodov 1.2, 1.3; Morin 4, 8; Goldstein 6; Taylor 4, 7.
"""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.typeset.machine import to_machine
from tests.ask.test_unseen import asked
from tests.ask.test_unseen import test_it_finds_what_is_worked_out_by_hand as found

ANSWERS = (
    ("dumbbell-wall", "S as a function of theta", "-m*g*(3*cos(theta)-2*cos(theta_0))"),  # √(ℓ²) is ℓ
    ("dumbbell-wall", "speed of lower where N_w vanishes", "2*cos(theta_0)/3*sqrt(2*g*ell*cos(theta_0)/3)"),
    ("rotor-sqrt", "work of C until phi comes to rest", "-I_c*omega_0**2/2"),  # the speed stands within a root
    ("rotor-sqrt", "time until phi comes to rest", "2*I_c*sqrt(omega_0*omega_1)/c"),
    ("ring-on-rod", "equilibrium of y", "m*d/sqrt(M**2 - m**2)"),
    ("ring-on-rod", "frequency of y", "sqrt(g*(M - m)*sqrt(M**2 - m**2)/(d*M*m))"),
    ("ring-on-rod", "y where y comes to rest", "2*M*m*d/(M**2 - m**2)"),
    ("ring-on-rod", "speed of y where y = d", "2*sqrt(g*d*(m + M - M*sqrt(2))/(M + 2*m))"),
    ("string-pair", "y as a function of t", "m_2/(m_1 + m_2)*(v_0*t - ell*sin(v_0*t/ell))"),
    ("string-pair", "speed of first where theta = pi", "2*m_2*v_0/(m_1 + m_2)"),
    ("string-pair", "x as a function of theta", "m_2*ell/(m_1 + m_2)*(1 - cos(theta))"),
    ("spring-against-wall", "time until free", "pi/2*sqrt(m_2/k)"),
    ("driven-free-mass", "x as a function of t", "F_0/(m*Omega)*t - F_0/(m*Omega**2)*sin(Omega*t)"),
    ("driven-free-mass", "largest speed of x", "2*F_0/(m*Omega)"),
    ("ring-spring-rod", "frequency of x", "sqrt(k*(1 - ell/h)/m)"),
    ("hit-and-spring", "frequency of x_3 in phase joined", "sqrt(k*(m + 2*M)/(M*(m + M)))"),
    ("plate-cut", "S when cut begins", "2*m*g/5"),
    ("plate-cut", "angular acceleration of plate right after the cut", "-6*g/(5*a)"),
    ("pendulums-collide", "S just before hit", "m_1*g*(3 - 2*cos(theta_0))"),
    ("rod-on-string", "ratio of theta_2 to theta_1 in the lowest mode", "(sqrt(19) - 1)/3"),
    ("pendulum-under-spring-block", "ratio of theta to x in the lowest mode with k = (M + m)*g/ell", "sqrt((M + m)/m)/ell"),
    ("pendulum-under-spring-block", "lowest frequency of x with k = (M + m)*g/ell", "sqrt(g*(M + m - sqrt(m*(M + m)))/(M*ell))"),
    ("rod-on-string", "tension of S in equilibrium", "m*g"),
    ("block-on-falling-rod", "theta where it slips",
     "atan(mu*M*ell*(2*ell - 3*b)/(2*(M*ell*(ell + 3*b) + 9*m*b**2)))"),
)  # fmt: skip


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: value[:60])
def test_it_finds_what_is_worked_out_by_hand(name: str, question: str, worked_out: str) -> None:
    found(name, question, worked_out)


def test_a_place_is_told_as_a_function_of_another_one() -> None:
    told = answered(asked("projectile"), "y as a function of x")
    assert told.verdict.is_proved
    assert told.text == "h + x_1*tan(alpha) - g*x_1**2/(2*v_0**2*cos(alpha)**2)"
    assert told.given == {"x_1": "x"}


def test_a_way_relative_to_another_body_is_told() -> None:
    told = answered(asked("spin-on-free-plank"), "displacement of disk relative to plank until rolling")
    assert told.verdict.is_proved
    assert told.text == "(M*R**2*omega_0**2*(M + m)/(2*mu*g*(3*M + m)**2), 0)"


@pytest.mark.parametrize("question", ["equilibrium of y_2", "T in equilibrium", "frequencies of y_1"])
def test_a_place_of_rest_is_told_with_the_side_on_which_the_motion_begins(question: str) -> None:
    """With the lower mass above the upper one it is another place."""
    told = answered(asked("hanging-chain-of-two"), question)
    assert told.verdict.is_proved
    assert "a_1 - a_2 > 0" in {to_machine(node) for node in told.valid}


@pytest.mark.parametrize(
    ("name", "question", "text"),
    [
        ("hanging-chain-of-two", "lowest frequency of y_1", "1/2*sqrt(k/m)*(sqrt(5) - 1)"),
        ("hanging-chain-of-two", "ratio of y_2 to y_1 in the lowest mode", "(1 + sqrt(5))/2"),
    ],
)
def test_surds_stand_as_one_writes_them(name: str, question: str, text: str) -> None:
    assert answered(asked(name), question).text == text
