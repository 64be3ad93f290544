"""Words that could be taken for others: each was once answered with the value of something else."""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import ask
from rbpsym.ask.limits import leading
from rbpsym.ask.numbers import rounded
from rbpsym.ask.special import _term
from rbpsym.ask.telling import latex_of
from rbpsym.decide.assumptions import NONE
from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.field.scalar import symbol
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem

MEANT = (
    ("disk-with-spring", "largest speed of x", "magnitude of speed of x where x = 0"),
    ("rod-pendulum", "x component of F at the start", "F_x at the start"),
    ("rod-pendulum", "component of F across rod at the start", "component of force F on rod across rod at the start"),
    ("bowling-with-overspin", "work of F on ball when rolling begins", "work of F on ball until rolling"),
    ("ball-in-a-loop", "v_0 for which N = 0 where theta = pi", "v_0 for which N where theta = pi = 0"),
)
LIMITS = (
    ("yo-yo", "acceleration of y in the limit b -> 0", "0"),
    ("yo-yo", "acceleration of y for small b", "2*b**2*g/R**2"),
)
WRONG = (
    ("double-atwood", "acceleration of h", "is a constant"),
    ("rod-pendulum", "x component of M", "is no vector"),
    ("disk-on-viscous-bearing", "largest phi", "how far phi goes"),
)


def answers(name: str, *questions: str):
    return ask(load_problem(problem_files()[name]), *questions)


@pytest.mark.parametrize(("name", "question", "other"), MEANT)
def test_it_is_what_the_longer_words_mean(name, question, other):
    found, same = answers(name, question, other)
    assert found.verdict.is_proved
    assert scalars_equal(found.value, same.value, found.study.assumptions).is_proved


@pytest.mark.parametrize(("name", "question", "value"), LIMITS)
def test_a_limit_is_a_value_and_what_is_near_it_a_term(name, question, value):
    [found] = answers(name, question)
    names = {quantity.name: quantity.name for quantity in found.study.problem.parameters}
    assert found.verdict.is_proved and is_zero(found.value - scalar(read_infix(value, names)))


@pytest.mark.parametrize(("name", "question", "told"), WRONG)
def test_what_means_nothing_gets_a_sentence(name, question, told):
    with pytest.raises(StatementError, match=told):
        answers(name, question)


def test_the_lowest_frequency_is_that_of_a_mode():
    low, high = answers("double-compound-pendulum", "lowest frequency of theta_1", "highest frequency of theta_1")
    assert low.text != high.text


@pytest.mark.parametrize(("power", "to"), [(-2, "b"), (3, "b"), (1, None), (-1, None)])
def test_the_leading_term_of_a_power_is_that_power(power, to):
    x, c, end = symbol("x"), symbol("c"), None if to is None else symbol(to)
    value = c * (x if end is None else x - end) ** power
    assert is_zero(_term(leading(value, "x", end, NONE, 1), "x", end, 1) - value)


def test_a_vector_stands_in_brackets():
    place, mass = answers("spoked-wheel-moments", "centre of mass of wheel and counterweight", "mass of wheel")
    assert latex_of(place).startswith(r"\left(") and len(place.values) == 2
    assert not latex_of(mass).startswith(r"\left(")


@pytest.mark.parametrize(("value", "told"), [(45.6, "45.6"), (456.0, "456"), (4560.0, "4.56e+03"), (0.00123, "0.00123")])
def test_numbers_are_told_with_their_figures(value, told):
    assert rounded(value, 3) == told
