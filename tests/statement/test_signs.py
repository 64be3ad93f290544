"""Signs are told only where the form tells them, and multiples of pi are compared exactly."""

from __future__ import annotations

import pytest

from rbpsym.notation.infix import read_infix
from rbpsym.statement.signs import compare_numbers, sign_of

SIGNS = {"a": "positive", "b": "positive", "c": "real", "n": "nonnegative"}


@pytest.mark.parametrize(
    ("text", "sign"),
    [
        ("a", 1),
        ("-a", -1),
        ("2*a*b", 1),
        ("-2*a/b", -1),
        ("a + b", 1),
        ("-a - b", -1),
        ("a - b", None),
        ("c", None),
        ("c**2", None),
        ("n", None),
        ("a + n", None),
        ("sqrt(a)", 1),
        ("a**3", 1),
        ("0*c", 0),
        ("0", 0),
        ("1 - 1", 0),
        ("22/7 - pi", 1),
        ("3 - pi", -1),
        ("pi - pi", 0),
        ("(a)", 1),
        ("sin(a)", None),
        ("0 + a", 1),
    ],
)
def test_sign(text: str, sign: int | None) -> None:
    assert sign_of(read_infix(text, SIGNS), SIGNS) == sign


@pytest.mark.parametrize(
    ("left", "right", "sign"),
    [
        ("pi/2", "1.5707963267948966", 1),
        ("pi/2", "1.57079632679489662", -1),
        ("2*pi/4", "pi/2", 0),
        ("-pi", "pi", -1),
        ("a", "a", None),
        ("pi*pi", "9", None),
        ("355/113", "pi", 1),
    ],
)
def test_compare(left: str, right: str, sign: int | None) -> None:
    assert compare_numbers(read_infix(left, SIGNS), read_infix(right, SIGNS)) == sign
