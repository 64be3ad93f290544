"""The conditions of an answer are those that it needs: none is missing, none is of another case, none was met before."""

import pytest

from rbpsym.ask.asking import answered
from rbpsym.ask.moments import Asked
from rbpsym.errors import StatementError
from rbpsym.notation.text import to_text
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
from tests.ask.test_unseen import asked

CONDITIONS = (
    ("banked-car", "largest v for which it does not slip", ["cos β − μ sin β > 0", "b − μh ≥ 0"], ""),
    ("banked-car", "largest v for which it does not tip", ["h cos β − b sin β > 0", "μh − b ≥ 0"], ""),
    ("banked-car", "smallest v for which it does not slip", ["sin β − μ cos β > 0", "b − μh ≥ 0"], ""),
    ("leaning-rod", "theta for which f is greatest", ["2d − a ≥ 0"], ""),
    ("leaning-rod", "largest f over theta", ["2d − a ≥ 0"], ""),
    ("cycloid-bead", "N where q = 0", [], ""),
    ("struck-in-line", "H when struck begins", [], ""),
    ("two-blocks-pulled", "F for which it does not slip", ["μ₂ − μ₁ > 0"], "else “it does not slip” holds for F < "),
    ("two-blocks-pulled", "largest F for which it does not slip", [], ""),
    ("back-spin", "time until x = 0", ["5v₀ − Rw₀ > 0", "Rw₀ − 2v₀ > 0"], ""),
    ("two-balls", "smallest M for which z reaches 4*h", ["2e − 1 > 0"], "else there is no such M"),
    ("two-balls", "does z reach 4*h with M = 10*m, e = 1", [], "yes"),
    ("bullet-and-spring", "x where x comes to rest in phase together", ["2μMgb(m + M) + kb²(m + M) − m²v₀² ≥ 0"], ""),
    ("slider-crank-driven", "speed of x where phi = pi/2", [], ""),
    ("quick-return", "speed of psi where phi = pi", [], ""),
)


@pytest.mark.parametrize(("name", "question", "told", "says"), CONDITIONS, ids=lambda value: str(value)[:40])
def test_an_answer_has_the_conditions_that_it_needs(name: str, question: str, told: list[str], says: str) -> None:
    found = answered(asked(name), question)
    assert found.verdict.is_proved and sorted(map(to_text, found.valid)) == sorted(told)
    assert found.says.startswith(says) and bool(found.says) is bool(says)


def test_a_string_does_not_run_through_its_pulley() -> None:
    problem = Asked(load_problem(find_problem("block-on-table")))
    with pytest.raises(StatementError, match="a string runs out"):
        answered(problem, "speed of x where x = 2*d")
    assert not answered(problem, "speed of x where x = d/2").valid
