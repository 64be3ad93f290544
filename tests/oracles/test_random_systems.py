"""Random systems, derived and put to every oracle: no false verdict, no crash; what once was found stays mended.

The thorough tier has two thousand (tests/thorough/test_systems.py).
"""

import random

import pytest
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import compare
from rbpsym.field.scalar import NOTHING, symbol
from tests.oracles.judged import judged
from tests.oracles.systems import FAMILIES, statement, used

# a system that fails is told as it is: to make it smaller would take minutes
QUIET = settings(suppress_health_check=list(HealthCheck), phases=(Phase.explicit, Phase.generate))


@seed(11)
@settings(QUIET, max_examples=3)
@given(st.data())
def test_nothing_false_is_told_of_a_random_system(data):
    text = statement(lambda entries: data.draw(st.sampled_from(entries)))
    found = judged(text)
    assert not found.wrong, text


SEEDS = {"chain": 8, "ladder": 5, "loop": 8}  # of systems that are small, but have something to compare; of the others 3


@pytest.mark.parametrize("name", FAMILIES)
def test_each_kind_of_system_is_derived_and_compared(name):
    found = judged(used(FAMILIES[name](random.Random(SEEDS.get(name, 3)).choice)))
    assert found.outcome in ("proved", "undecided"), found.text
    assert found.sets and found.compared > 5


# seeds at which something was wrong once: what it was
MENDED = {
    85: "a bound without a value at a sample point ended the derivation",
    186: "an empty list of forces was printed as the condition of rest",
    622: "a spring between points of one place ended the derivation",
    1015: "a force has a zero in closed form, and another one without, which was forgotten",
}


@pytest.mark.parametrize("number", MENDED)
def test_what_was_found_is_mended(number):
    found = judged(statement(random.Random(number).choice))
    assert not found.wrong, MENDED[number]


@pytest.mark.parametrize("number", (4, 14))
def test_a_place_exists_under_the_conditions_printed_with_it(number):
    assert judged(statement(random.Random(number).choice)).outcome == "proved"


def test_a_bound_without_a_value_is_no_error():
    x, a, b = map(symbol, "xab")
    given_ = Assumptions({"a": "positive", "b": "positive"}, {"x": (a / (a - b), None)})
    assert not compare(NOTHING, x, given_).is_proved
