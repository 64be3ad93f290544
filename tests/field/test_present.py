"""What is printed has the value that it was made of."""

import random
import subprocess
import sys
from fractions import Fraction

import pytest

from rbpsym.expr import tree as t
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import same
from rbpsym.field.scalar import NOTHING, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.present.forms import present
from rbpsym.present.grouping import leads_negative, leads_positive
from rbpsym.present.style import Style

A, B = symbol("a"), symbol("b")
ATOMS = [symbol("m"), symbol("ell"), symbol("g"), symbol("a_dot"), cosine(A), sine(A), cosine(B), sine(A - B)]
STYLE = Style({"m": (1, 0), "g": (3, 0), "ell": (4, 0)}, frozenset({"a", "b", "a_dot"}))


def some_term(source: random.Random):
    term = lift(Fraction(source.randint(-6, 6) or 1, source.choice([1, 1, 2, 3, 4])))
    for atom in source.sample(ATOMS, source.randint(1, 4)):
        term = term * atom ** source.choice([1, 1, 2, -1, -2])
    return term


@pytest.mark.parametrize("factor", [False, True])
@pytest.mark.parametrize("seed", range(60))
def test_the_tree_has_the_value(seed, factor):
    source = random.Random(seed)
    value = sum((some_term(source) for _ in range(source.randint(1, 5))), NOTHING)
    if seed % 3 == 0:
        value = value / (some_term(source) + some_term(source) + 1)
    assert same(scalar(present(value, STYLE, factor=factor)), value)


def test_common_moving_factors_below_the_bar_are_kept():
    """A common 1/cos b of all terms was lost once."""
    value = (sine(A) * symbol("a_dot") ** 2 - cosine(A)) / cosine(B)
    assert same(scalar(present(value, STYLE)), value)


def test_a_sum_stands_before_a_function():
    """sin(b)(s + x cos b) reads as a sine of all that follows."""
    found = present((symbol("ell") + symbol("m") * cosine(B)) * sine(B), STYLE)
    assert isinstance(found, t.Mul)
    assert [type(factor) for factor in found.factors] == [t.Add, t.Fn]


def test_a_minus_goes_into_a_difference_below_the_bar():
    """-c/(a - b) is printed c/(b - a), unless a is known to be the greater."""
    m, ell, c, g = (symbol(name) for name in ("m", "ell", "c", "g"))
    turned, kept = (c - ell, m * c - ell, 4 * c - 3 * m), (ell - c, 4 - 3 * sine(A) ** 2, 6 - 11 * sine(A))
    for difference, is_turned in (*((one, True) for one in turned), *((one, False) for one in kept)):
        value = -(g + m + ell) / difference
        found = present(value, Style(STYLE.rank, greater=frozenset({("ell", "c")})))
        assert same(scalar(found), value)
        assert isinstance(found, t.Neg) is not is_turned


def test_no_fraction_below_a_fraction():
    m, ell, g = (symbol(name) for name in ("m", "ell", "g"))
    found = present(m / (m * ell ** (-2) * g**2 + 1), STYLE)
    assert same(scalar(found), m / (m * ell ** (-2) * g**2 + 1))
    assert isinstance(found, t.Div)
    assert not any(isinstance(node, t.Div) for node in t.walk(found.den))


def test_a_known_greater_one_is_not_taken_off():
    """With ell > a, 3 ell² - 2 a² is positive, and 2 ell² - 3 a² need not be."""
    style = Style(STYLE.rank, greater=frozenset({("ell", "c")}))
    ell, c, g = (symbol(name) for name in ("ell", "c", "g"))
    sure, unsure = present(g / (2 * c**2 - 3 * ell**2), style), present(g / (3 * ell**2 - 2 * c**2), style)
    assert isinstance(sure, t.Neg)
    assert isinstance(unsure, t.Div)
    assert not leads_positive((2 * ell**2 - 3 * c**2).num, style)
    assert not leads_negative((3 * c**2 - 2 * ell**2).num, style)
    assert leads_positive((3 * ell**2 - 2 * c**2).num, style)


SPOKEN_OF_BEFORE = """
import sys
from rbpsym.field.evaluate import scalar
from rbpsym.present.forms import present
from rbpsym.expr.infix import read_infix
from rbpsym.typeset.machine import to_machine
names = sys.argv[1].split()
for name in names:
    scalar(read_infix(name, names))
print(to_machine(present(scalar(read_infix("15*mu - c**2*mu - 2*c*mu - c*sqrt(15 - c**2 - 2*c)", names)))))
print(to_machine(present(scalar(read_infix("3*M*R**2*m + 3*M**2*R**2 + m**2*b**2 + 4*m*M*b**2", names)))))
"""


def test_how_a_sum_is_grouped_does_not_depend_on_what_was_met_before():
    orders = ("c mu M R m b", "b m R M mu c", "mu m c b M R")
    told = {subprocess.run([sys.executable, "-c", SPOKEN_OF_BEFORE, names], capture_output=True, text=True, check=True).stdout
            for names in orders}  # fmt: skip
    assert len(told) == 1 and all(told)
