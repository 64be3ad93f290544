"""Only what is zero is taken for a zero among algebraic numbers, however near to it others are."""

from fractions import Fraction

import pytest

from rbpsym.decide.constants import is_zero_number
from rbpsym.decide.radicals import _number_root
from rbpsym.field.calculus import root
from rbpsym.field.scalar import PI, lift
from rbpsym.field.trig import cosine


@pytest.mark.parametrize("large", [3, 10, 10**6, 10**20])
def test_what_is_small_is_not_zero(large):
    assert not is_zero_number((root(lift(large**2 + 1)) - large).num)
    assert not is_zero_number((root(lift(large**2 + 1)) - root(lift(large**2 + 2))).num)


ZEROS = [
    root(lift(2)) + root(lift(3)) - root(5 + 2 * root(lift(6))),
    cosine(PI / 5) - (1 + root(lift(5))) / 4,
    root(lift(2)) * root(lift(8)) - 4,
]


@pytest.mark.parametrize("value", ZEROS)
def test_what_is_zero_is_known_to_be(value):
    assert is_zero_number(value.num)
    assert not is_zero_number((value + lift(1) / 10**9).num)


@pytest.mark.parametrize("found", [0, 1, 3, Fraction(1, 2), Fraction(2, 3), Fraction(7, 10**9)])
def test_squares_of_numbers_are_known(found):
    square = Fraction(found) ** 2
    assert _number_root(square) == found
    assert _number_root(square * 2) == (None if found else 0)
    assert _number_root(-square) == (None if found else 0)
