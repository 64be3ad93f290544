"""The rate of an integral with an unknown integrand, by its limits."""

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field.evaluate import Meanings, rate
from rbpsym.field.scalar import symbol

N, SPEED = symbol("N"), symbol("theta_dot")
SCOPE = Meanings(rates={"theta": SPEED}, start={"theta": symbol("theta_0")})
START, NOW = t.Sym("theta_0"), t.Sym("theta")


@pytest.mark.parametrize(("lower", "upper", "wanted"), [(START, NOW, N * SPEED), (NOW, START, -(N * SPEED))])
def test_from_the_start_to_now_and_back(lower, upper, wanted):
    assert rate(t.Integral(t.Sym("N"), "theta", lower, upper), SCOPE) == wanted


def test_between_other_limits_the_integral_itself_is_differentiated():
    found = rate(t.Integral(t.Fn("cos", NOW), "theta", t.ZERO, NOW), SCOPE)
    assert found == rate(t.Fn("sin", NOW), SCOPE)


def test_a_sum_over_particles_has_no_value_of_its_own():
    with pytest.raises(RbpsymError, match="has no value"):
        rate(t.Sum(t.Sym("m")), SCOPE)


M = t.Sym("m")


@pytest.mark.parametrize(
    ("formula", "factor"),
    [
        (lambda x: t.Div(x, M), symbol("m").inverse()),
        (lambda x: t.Mul((M, x)), symbol("m")),
        (lambda x: t.Add((x, M, x)), symbol("m") / symbol("m") * 2),
        (t.Neg, symbol("m") / -symbol("m")),
        (t.Group, symbol("m") / symbol("m")),
    ],
)
def test_what_stands_beside_an_integral_is_constant(formula, factor):
    integral = t.Integral(t.Sym("N"), "theta", START, NOW)
    assert rate(formula(integral), SCOPE) == rate(integral, SCOPE) * factor
