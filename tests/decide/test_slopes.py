"""Signs that follow from slopes and from the values at the ends, against values inside the range."""

from __future__ import annotations

import random

import pytest

from rbpsym.decide.assumptions import NONE
from rbpsym.decide.rooted import sign_along
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.numbers import number

KNOWN = (
    ("x - sin(x)", "0", "pi/2", 1),
    ("cos(x) - 1 + x**2/2", "0", "1", 1),
    ("1 + x - exp(x)", "0", "2", -1),
    ("sin(x) - 2*x/pi", "0", "pi/2", 1),
    ("2*sin(x) + 3*(cos(x) - 1)", "0", "2*atan(2/3)", 1),
    ("3*sin(x) + 2*(cos(x) - 1)", "0", "2*atan(3/2)", 1),
    ("3*sin(x) + 2*(cos(x) - 1)", "0", "pi", 0),
    ("cos(2*x) - 1 - sin(2*x)/2", "0", "pi/2", -1),
    ("1/x - 1", "-1", "2", 0),
    ("exp(1/x) - 1", "-1", "1", 0),
    ("sin(x) - 1/2", "0", "pi/2", 0),
)


def value(text: str):
    return scalar(read_infix(text, ["x"]))


@pytest.mark.parametrize(("text", "low", "high", "side"), KNOWN)
def test_the_sign_is_that_of_the_whole_range(text, low, high, side):
    assert sign_along(value(text), "x", NONE.with_range("x", value(low), value(high))) == side


def test_what_is_told_of_an_end_is_used():
    falling, given = scalar(read_infix("a - x", ["a", "x"])), NONE.with_range("x", value("0"), value("1"))
    assert sign_along(falling, "x", given) == 0
    assert sign_along(falling, "x", given, lambda end: end == scalar(read_infix("a - 1", ["a"]))) == 1


def test_no_sign_is_told_that_a_point_inside_denies():
    drawn, decided = random.Random(7), 0
    for _ in range(50):
        parts = [f"({drawn.randint(-3, 3)})*{part}" for part in ("1", "x", "x**2", "sin(x)", "cos(x)", "exp(x)", "sin(x)*cos(x)")]
        found, (low, high) = value("+".join(parts)), sorted(drawn.sample(range(-3, 4), 2))
        side = sign_along(found, "x", NONE.with_range("x", value(str(low)), value(str(high))))
        decided += side != 0
        inside = [low + (high - low) * k / 40 for k in range(1, 40)]
        assert not side or all(number(found, {"x": x}) * side > -1e-9 for x in inside), (parts, low, high)
    assert decided > 6
