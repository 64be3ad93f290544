"""Squares are known for what they are, also where only sin² + cos² = 1 shows it."""

import pytest

from rbpsym.expr.infix import read_infix
from rbpsym.field import is_zero
from rbpsym.field.evaluate import scalar
from rbpsym.field.roots import side_of

NAMES = {"s", "b", "p", "R", "beta"}

SQUARES = (
    "(s - b/cos(beta) - R*tan(beta))**2",
    "(R*sin(beta) + b)**2",
    "(2*s*cos(beta) - 3*R*sin(beta) + b)**2/cos(beta)**2",
    "(p*s + R*sin(beta)*cos(beta))**2",
)
OTHERS = ("s**2 + 2*b*s + R**2", "s**2*sin(beta) + 2*s*b + b**2", "s**2 + b**2*cos(beta)**2")


@pytest.mark.parametrize("text", SQUARES)
def test_a_square_has_a_side(text: str) -> None:
    square = scalar(read_infix(text, NAMES))
    side = side_of(square)
    assert side is not None
    assert is_zero(side * side - square)


@pytest.mark.parametrize("text", OTHERS)
def test_what_is_no_square_has_none(text: str) -> None:
    assert side_of(scalar(read_infix(text, NAMES))) is None
