"""Problems stated from the documentation alone, with answers worked out by hand first: greatest values up to a phase, places and
moments that a quantity tells by the time, forces by what they are, other words.

Kleppner & Kolenkow 1, 2; Beer & Johnston 11, 13; Hibbeler 12, 14; Meriam & Kraige 2, 3.
"""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.expr.tree import names
from tests.ask.test_unseen import asked
from tests.ask.test_unseen import test_it_finds_what_is_worked_out_by_hand as found

SLIDES, LEFT = "(sin(beta) + mu*cos(beta))", "sqrt(k*d**2/m - 2*g*d*(sin(beta) + mu*cos(beta)))"
GAIN = "(g*(m_2 - m_1*sin(beta) - mu*m_1*cos(beta))/(m_1 + m_2 + M/2))"
SPUN, HELD = "(m*v*r)", "M*w**2/3 + m*r**2"
ANSWERS = (
    ("block-shot-up-slope", "largest speed of s until free", f"sqrt(k/m)*(d - m*g*{SLIDES}/k)"),  # not when it is free
    ("block-shot-up-slope", "largest speed of s", f"sqrt(k/m)*(d - m*g*{SLIDES}/k)"),
    ("block-shot-up-slope", "largest speed of s in phase free", LEFT),
    ("block-shot-up-slope", "largest elongation of S until free", "0"),
    ("block-shot-up-slope", "height of block where speed of s is largest", f"-m*g*{SLIDES}*sin(beta)/k"),
    ("block-shot-up-slope", "speed of s where acceleration of s vanishes", f"sqrt(k/m)*(d - m*g*{SLIDES}/k)"),
    ("block-shot-up-slope", "work of the spring until free", "k*d**2/2"),
    ("block-shot-up-slope", "work of friction until free", "-mu*m*g*d*cos(beta)"),
    ("block-shot-up-slope", "distance travelled until it comes to rest", f"k*d**2/(2*m*g*{SLIDES})"),
    ("block-shot-up-slope", "energy lost in phase free until s comes to rest", f"mu*m*g*cos(beta)*(k*d**2/(2*m*g*{SLIDES}) - d)"),
    ("coin-on-turntable", "t where magnitude of f = mu*m*g", "sqrt(sqrt(mu**2*g**2 - r**2*alpha**2)/(r*alpha**2))"),
    ("coin-on-turntable", "time until magnitude of f = mu*m*g", "sqrt(sqrt(mu**2*g**2 - r**2*alpha**2)/(r*alpha**2))"),
    ("coin-on-turntable", "speed of phi where magnitude of f = mu*m*g", "sqrt(sqrt(mu**2*g**2 - r**2*alpha**2)/r)"),
    ("coin-on-turntable", "time until number of turns of table = 2", "sqrt(8*pi/alpha)"),
    ("motor-that-tires", "largest power of C", "tau_0*omega_m/4"),
    ("motor-that-tires", "speed of phi where power of C is largest", "omega_m/2"),
    ("boat-by-winch", "speed of x where x = d/2", "-u*sqrt(d**2 + 4*h**2)/d"),
    ("boat-by-winch", "time until x = d/2", "(2*sqrt(h**2 + d**2) - sqrt(4*h**2 + d**2))/(2*u)"),
    ("block-pulley-load", "T_2", f"m_2*(g - {GAIN})"),
    ("block-pulley-load", "work of friction until s = h", "-mu*m_1*g*h*cos(beta)"),
    ("block-pulley-load", "work of the weight on load until s = h", "m_2*g*h"),
    ("block-pulley-load", "moment of inertia of pulley about its centre", "M*R**2/2"),
    ("block-pulley-load", "normal force on block", "m_1*g*cos(beta)"),
    ("block-pulley-load", "tension on load", f"m_2*(g - {GAIN})"),
    ("block-pulley-load", "weight of the block", "m_1*g"),
    ("bullet-into-door", "phi where phi comes to rest", f"{SPUN}**2/({HELD})/(2*M_f)"),  # though its sine has no plain form
    ("bullet-into-door", "angle through which the door turns until it comes to rest", f"{SPUN}**2/({HELD})/(2*M_f)"),
    ("bullet-into-door", "number of turns of door until the door stops", f"{SPUN}**2/({HELD})/(4*pi*M_f)"),
    ("bullet-into-door", "time until the door stops", f"{SPUN}/M_f"),
    ("hoist-on-drum", "terminal speed of y", "P/(m*g)"),
    ("hoist-on-drum", "time until speed of y = P/(2*m*g)",
     "(m + I_d/R**2)*(v_0/(m*g) - P/(2*(m*g)**2) - P/(m*g)**2*ln(P/(2*(P - m*g*v_0))))"),
    ("brake-block", "P for which it stops after 20 turns", "I_w*omega_0**2*a/(80*pi*mu*b*R)"),
    ("brake-block", "omega_0 for which the wheel stops in 20 turns", "sqrt(80*pi*mu*P*b*R/(I_w*a))"),
    ("block-in-free-bowl", "work of N on large until theta = pi/2", "m**2*g*R/(m + M)"),
    ("rod-with-weight", "F_y at the lowest point", "(M + m)*g + (M + 2*m)**2*3*g/(2*(M + 3*m))"),
)  # fmt: skip


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: str(value)[:60])
def test_it_finds_what_is_worked_out_by_hand(name: str, question: str, worked_out: str) -> None:
    found(name, question, worked_out)


def test_what_a_solution_asks_is_told_of_its_moment() -> None:
    """With no letter t in a condition of an answer that is one number."""
    found = answered(asked("block-shot-up-slope"), "time until it comes to rest")
    assert found.verdict.is_proved
    assert found.valid
    assert not any("t" in names(node) for node in found.valid)


def test_a_unit_is_read_where_the_names_of_the_problem_do_not_fit() -> None:
    """m and s are a mass and a way there."""
    found = answered(asked("block-shot-up-slope"), "d for which speed of s when free begins = 2 m/s")
    assert found.verdict.is_proved
    assert dict(found.given) == {"q_1": "2 m/s"}
