"""Two thousand random systems, without one false verdict."""

import random

import pytest

from tests.oracles.judged import judged
from tests.oracles.systems import statement

pytestmark = pytest.mark.thorough
SYSTEMS, SLICE = 2000, 20


@pytest.mark.parametrize("first", range(0, SYSTEMS, SLICE))
def test_nothing_false_is_told(first):
    wrong = {}
    for number in range(first, first + SLICE):
        found = judged(statement(random.Random(number).choice))
        if found.wrong:
            wrong[number] = found.wrong
    assert not wrong
