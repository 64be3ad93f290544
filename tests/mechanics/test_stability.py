"""A stiffness of numbers is that of a stable place where its eigenvalues are positive."""

import random

import numpy as np
import pytest

from rbpsym.decide.assumptions import Assumptions
from rbpsym.field.scalar import lift, symbol
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.stability import essential, is_stable, stable_where

K, A, B = map(symbol, "kab")
GIVEN = Assumptions(dict.fromkeys("kab", "positive"))


@pytest.mark.parametrize("size", [1, 2, 3])
def test_it_is_stable_where_all_eigenvalues_are_positive(size):
    source, seen = random.Random(size), set()
    for _ in range(60):
        whole = np.array([[source.randint(-4, 4) for _ in range(size)] for _ in range(size)])
        whole = whole + whole.T + np.eye(size, dtype=int) * source.randint(-4, 9)
        least = min(np.linalg.eigvalsh(whole))
        found = is_stable(tuple(tuple(lift(int(part)) for part in row) for row in whole), GIVEN)
        if abs(least) > 1e-9:
            assert found in (None, bool(least > 0)) and (least < 0 or found), whole
        seen.add(found)
    assert {True, False} <= seen


def test_where_it_is_stable_is_told_by_one_condition():
    assert is_stable(((A - B,),), GIVEN) is None and stable_where(((A - B,),), GIVEN) == A - B
    assert stable_where(((A, NONE := lift(0)), (NONE, (A - B) * 3 * K)), GIVEN) == A - B
    assert stable_where(((A, NONE), (NONE, NONE)), GIVEN) is None
    assert stable_where(((A - B, NONE), (NONE, B - A)), GIVEN) is None


@pytest.mark.parametrize("value", [3 * K * (A - B), -2 * (A - B) / K, (A - B) * (A + B), -K * (A * A - 2 * B * B)])
def test_what_is_essential_has_the_same_sign(value):
    found = essential(value, GIVEN)
    assert len(found.num) == 2 and found.num.content()[0] == 1
    for at in ({"k": 2.0, "a": 1.0, "b": 3.0}, {"k": 0.5, "a": 4.0, "b": 1.0}):
        assert number(found, at) * number(value, at) > 0
