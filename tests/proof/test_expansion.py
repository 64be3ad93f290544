"""To first order a value goes with its derivative, and products and powers of series with those of numbers."""

import pytest

from rbpsym.errors import Undecided
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import lift, symbol
from rbpsym.mechanics.numbers import number
from rbpsym.proof.expansion import FirstOrder, expanded

AT, STEP = {"x": 0.7, "y": 1.3}, 1e-6
IMAGES = {"x": FirstOrder(symbol("x"), lift(1)), "y": FirstOrder(symbol("y"), lift(-2))}
VALUES = (
    "x*y", "x**3*y", "x/y", "1/(x + y)**3", "x**-2*y", "cos(x*y)", "sin(2*x - y)*y", "atan(x/y)", "sqrt(x**2 + y)", "exp(2)*x",
    "exp(x*y)", "ln(x/y)", "sqrt(x)/(1 + cos(y))", "(x - y)**4", "1/y**3",
)  # fmt: skip


@pytest.mark.parametrize("text", VALUES)
def test_what_is_of_first_order_is_the_slope(text):
    value = scalar(read_infix(text, ("x", "y")))
    found = expanded(value, IMAGES)
    up, down = (number(value, {"x": AT["x"] + h, "y": AT["y"] - 2 * h}) for h in (STEP, -STEP))
    assert number(found.value, AT) == pytest.approx(number(value, AT))
    assert number(found.slope, AT) == pytest.approx((up - down) / (2 * STEP), rel=1e-6)


@pytest.mark.parametrize("power", range(-4, 5))
def test_powers_of_a_series(power):
    found = FirstOrder(lift(3), lift(5)) ** power
    assert (found.value, found.slope) == (lift(3) ** power, 5 * power * lift(3) ** (power - 1))


@pytest.mark.parametrize("text", ["asin(x)", "acos(x)"])
def test_what_has_no_rule_is_not_expanded(text):
    with pytest.raises(Undecided):
        expanded(scalar(read_infix(text, ("x",))), IMAGES)
