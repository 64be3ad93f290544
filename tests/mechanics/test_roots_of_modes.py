"""Roots of characteristic polynomials, and the conditions under which all motions decay, against numpy's roots."""

import random
from fractions import Fraction

import numpy as np
import pytest

from rbpsym.decide.assumptions import NONE
from rbpsym.field.scalar import lift
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.oscillation import conditions, decaying, eigenvalues, hurwitz, squares


def polynomial(source: random.Random, degree: int) -> tuple[list[int], tuple]:
    whole = [source.randint(1, 5), *(source.choice((1, 1, 1, -1)) * source.randint(1, 9) for _ in range(degree))]
    return whole, tuple(map(lift, whole))


@pytest.mark.parametrize("degree", [1, 2, 3, 4, 5])
def test_the_conditions_hold_exactly_where_all_motions_decay(degree):
    source, seen = random.Random(degree), set()
    for _ in range(60):
        whole, powers = polynomial(source, degree)
        furthest = max(root.real for root in np.roots(whole))
        if abs(furthest) > 1e-9:
            found = all(number(value, {}) > 0 for value in conditions(powers))
            assert found is bool(furthest < 0), whole
            seen.add(found)
    assert seen == {False, True}


def test_hurwitz_matrix_of_degree_four():
    found = hurwitz(tuple(map(lift, (1, 2, 3, 4, 5))), 4)
    assert [[number(part, {}) for part in row] for row in found] == [[2, 4, 0, 0], [1, 3, 5, 0], [0, 2, 4, 0], [0, 1, 3, 5]]


def test_roots_of_short_factors_are_roots():
    source = random.Random(3)
    for _ in range(40):
        whole, powers = polynomial(source, 2)
        if whole[1] ** 2 > 4 * whole[0] * whole[2]:
            slow, fast = (number(root, {}) for root in eigenvalues(powers))
            assert (slow, fast) == pytest.approx(tuple(sorted(np.roots(whole).real)))
        decay, square = (number(part, {}) for part in decaying(powers))
        assert (2 * decay, square) == pytest.approx((whole[1] / whole[0], whole[2] / whole[0]))
        [root] = eigenvalues(powers[:2])
        assert whole[0] * root.number() + whole[1] == 0
    assert eigenvalues(tuple(map(lift, (1, 1, 1, 1)))) is None
    assert not any(decaying(tuple(map(lift, (1, 1, 1, 1)))))


def test_squares_of_frequencies_are_roots_of_the_even_factor():
    for a, b, c in ((1, 5, 4), (2, 9, 3), (1, 7, 1)):
        powers = tuple(map(lift, (a, 0, b, 0, c)))
        found = [number(value, {}) for value in squares(powers, NONE)]
        assert found == pytest.approx(sorted(-np.roots([a, b, c]).real))
    assert [value.number() for value in squares(tuple(map(lift, (3, 0, 2))), NONE)] == [Fraction(2, 3)]
    assert squares(tuple(map(lift, (1, 0, 9, 0, 9, 0, 1))), NONE) == []
