"""What is printed has the value that it was made of."""

import random
from fractions import Fraction

import pytest

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.normal import same
from rbpsym.algebra.present import present
from rbpsym.algebra.scalar import NOTHING, lift, symbol
from rbpsym.algebra.style import Style
from rbpsym.algebra.trig import cosine, sine

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
