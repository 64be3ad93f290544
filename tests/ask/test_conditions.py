"""The conditions of an answer are those that it needs: none is missing, none is of another case, none was met before."""

import re
from collections.abc import Iterable

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import Scalar
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
from rbpsym.typeset.machine import to_machine
from tests.ask.test_unseen import asked

WORD = re.compile(r"\b(?!sin\b|cos\b)[A-Za-z]\w*")
CONDITIONS = (
    ("banked-car", "largest v for which it does not slip", ["cos(beta) - mu*sin(beta) > 0", "b - mu*h >= 0"], ""),
    ("banked-car", "largest v for which it does not tip", ["h*cos(beta) - b*sin(beta) > 0", "mu*h - b >= 0"], ""),
    ("banked-car", "smallest v for which it does not slip", ["sin(beta) - mu*cos(beta) > 0", "b - mu*h >= 0"], ""),
    ("leaning-rod", "theta for which f is greatest", ["2*d - a >= 0"], ""),
    ("leaning-rod", "largest f over theta", ["2*d - a >= 0"], ""),
    ("cycloid-bead", "N where q = 0", [], ""),
    ("struck-in-line", "H when struck begins", [], ""),
    ("two-blocks-pulled", "F for which it does not slip", ["mu_2 - mu_1 > 0"], "else “it does not slip” holds for F < "),
    ("two-blocks-pulled", "largest F for which it does not slip", [], ""),
    ("back-spin", "time until x = 0", ["5*v_0 - R*w_0 > 0", "R*w_0 - 2*v_0 > 0"], ""),
    ("two-balls", "smallest M for which z reaches 4*h", ["2*e - 1 > 0"], "else there is no such M"),
    ("two-balls", "does z reach 4*h with M = 10*m, e = 1", [], "yes"),
    ("bullet-and-spring", "x where x comes to rest in phase together", ["b*(m + M)*(2*mu*M*g + k*b) - m^2*v_0^2 >= 0"], ""),
    ("slider-crank-driven", "speed of x where phi = pi/2", [], ""),
    ("quick-return", "speed of psi where phi = pi", [], ""),
)


def _values(told: Iterable[str]) -> set[tuple[str, Scalar]]:
    """What is positive, or not negative, however it is written."""
    rows = (text.rsplit(" ", 2)[:2] for text in told)
    return {(op, scalar(read_infix(left, WORD.findall(left)))) for left, op in rows}


@pytest.mark.parametrize(("name", "question", "told", "says"), CONDITIONS, ids=lambda value: str(value)[:40])
def test_an_answer_has_the_conditions_that_it_needs(name: str, question: str, told: list[str], says: str) -> None:
    found = answered(asked(name), question)
    assert found.verdict.is_proved and _values(map(to_machine, found.valid)) == _values(told)
    assert found.says.startswith(says) and bool(found.says) is bool(says)


def test_a_string_does_not_run_through_its_pulley() -> None:
    problem = Asked(load_problem(find_problem("block-on-table")))
    with pytest.raises(StatementError, match="a string runs out"):
        answered(problem, "speed of x where x = 2*d")
    assert not answered(problem, "speed of x where x = d/2").valid


@pytest.mark.parametrize("question", ["ratio of acceleration of phi to acceleration of s", "N / acceleration of s"])
def test_a_quotient_has_the_conditions_of_its_parts(question: str) -> None:
    asked_of = Asked(load_problem(find_problem("cylinder-with-rolling-resistance")))
    parts = _values(map(to_machine, answered(asked_of, "acceleration of s").valid))
    assert parts and parts <= _values(map(to_machine, answered(asked_of, question).valid))
