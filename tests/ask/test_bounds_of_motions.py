"""Bounds of parameters where the motion itself depends on them: its sense, what ends it before, and what friction takes in time.

Irodov 1.1; Kleppner & Kolenkow 2, 6; Beer & Johnston 8, 16; Meriam & Kraige 6.
"""

from __future__ import annotations

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.statement.loader import load_text
from tests.ask.test_unseen import HERE
from tests.ask.test_unseen import test_it_finds_what_is_worked_out_by_hand as found

ANSWERS = (
    ("jumping-blocks", "smallest d for which N vanishes", "(2*m_1+m_2)*g/k"),
    ("jumping-blocks", "largest d for which N stays positive", "(2*m_1+m_2)*g/k"),
    ("jumping-blocks", "smallest d for which the lower block lifts", "(2*m_1+m_2)*g/k"),
    ("jumping-blocks", "speed of the centre of mass when lifted begins",
     "m_1/(m_1+m_2)*sqrt((k*d**2-m_2**2*g**2/k)/m_1-2*g*(d+m_2*g/k))"),
    ("disks-on-spring", "largest a for which it does not slip", "3*mu*m_1*g/k"),
    ("disks-on-spring", "smallest mu for which it does not slip", "k*a/(3*m_1*g)"),
    ("disks-on-spring", "time until S reaches its natural length", "pi/2*sqrt(3*m_1*m_2/(2*k*(m_1+m_2)))"),
    ("pushed-wedge", "smallest A for which it does not slip", "g*(sin(beta)-mu*cos(beta))/(cos(beta)+mu*sin(beta))"),
    ("pushed-wedge", "largest A for which it does not slip", "g*(sin(beta)+mu*cos(beta))/(cos(beta)-mu*sin(beta))"),
    ("wedge-lift", "smallest P for which the block rises",
     "M*g*((1-mu**2)*sin(alpha)+2*mu*cos(alpha))/((1-mu**2)*cos(alpha)-2*mu*sin(alpha))"),
    ("string-on-post", "speed of puck", "v_0"),
    ("string-on-post", "tension as a function of phi", "m*v_0**2/(L-R*phi)"),
    ("string-on-post", "angular momentum of puck about O", "m*v_0*(L-R*phi)"),
    ("string-on-post", "work of S", "0"),
    ("string-on-post", "phi for which S = 2*m*v_0**2/L", "L/(2*R)"),
    ("unequal-balls", "time until both_roll", "4*M*v_0/(7*mu*g*(M+m))"),
    ("unequal-balls", "speed of x_1 when first_rolls begins", "v_0*(M-3*m/7)/(M+m)"),
    ("trolley-door", "smallest P for which the door moves", "mu*m*g*b/(2*b+mu*h)"),
    ("two-rods-pushed", "angular acceleration of upper at the start for d -> L", "-6*P/(7*m*L)"),
    ("two-rods-pushed", "B_x at the start as d goes to L", "2*P/7"),
)  # fmt: skip


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: value[:60])
def test_bounds_are_those_of_the_motion_that_comes_about(name: str, question: str, worked_out: str) -> None:
    found(name, question, worked_out)


@pytest.mark.parametrize("question", ["smallest P for which it tips", "P for which it tips"])
def test_what_slips_before_never_tips(question: str) -> None:
    text = (HERE / "tip-or-slide.toml").read_text(encoding="utf-8").replace('mu = "number:', 'mu = "number < b/(2*H):')
    told = answered(Asked(load_text('title = "Smooth enough"\n' + text, "crate.toml")), question)
    assert told.verdict.is_proved and not told.values and "there is no such P: “it tips”" in told.says
