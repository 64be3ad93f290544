"""Derivatives, substitutions and antiderivatives, against each other and against differences."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from rbpsym.field.calculus import SINES, TANGENTS, depends_on, derivative, function, root, split_factor, substitute
from rbpsym.field.integration import antiderivative, definite
from rbpsym.field.normal import is_zero, same
from rbpsym.field.roots import with_numbers_inside
from rbpsym.field.scalar import PI, Scalar, generator_of, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.mechanics import numbers
from tests.field.strategies import (
    POINT,
    A,
    B,
    M,
    X,
    Y,
    close,
    divisors,
    fractions,
    number,
    polynomials,
    quotients,
    scalars,
    steady,
)  # fmt: skip

names = st.sampled_from(["a", "x"])


@steady
@given(scalars, scalars, names)
def test_sum_and_product_rule(p: Scalar, q: Scalar, name: str) -> None:
    assert same(derivative(p + q, name), derivative(p, name) + derivative(q, name))
    assert same(derivative(p * q, name), derivative(p, name) * q + p * derivative(q, name))


@steady
@given(polynomials, divisors, names)
def test_quotient_rule(p: Scalar, q: Scalar, name: str) -> None:
    assert same(derivative(p / q, name), (derivative(p, name) * q - p * derivative(q, name)) / (q * q))


@steady
@given(scalars)
def test_mixed_derivatives_agree(p: Scalar) -> None:
    assert same(derivative(derivative(p, "a"), "x"), derivative(derivative(p, "x"), "a"))


@steady
@given(quotients, names)
def test_derivative_is_the_limit_of_differences(p: Scalar, name: str) -> None:
    assume(abs(number(p.den)) > 0.1 and abs(number(p.num)) < 1e3)
    step = 1e-5
    up, down = (number(p, {**POINT, name: POINT[name] + h}) for h in (step, -step))
    rate = number(derivative(p, name))
    assert abs((up - down) / (2 * step) - rate) <= 1e-4 * (1 + abs(rate))


@pytest.mark.parametrize("kind", ["cos", "sin", "root", "exp", "ln", "atan", "asin", "acos"])
def test_the_derivative_of_each_function_is_the_limit_of_differences(kind: str) -> None:
    value, step = generator_of(kind, X * X / 5 + lift(Fraction(1, 7))), 1e-5
    up, down = (number(value, {"x": 0.8 + h}) for h in (step, -step))
    assert close((up - down) / (2 * step), number(derivative(value, "x"), {"x": 0.8}))


@steady
@given(st.lists(fractions, min_size=1, max_size=6), fractions)
def test_exact_difference_of_polynomials(coefficients: list[Fraction], at: Fraction) -> None:
    """(p(x) - p(at))/(x - at), carried out exactly, is p'(at) at x = at."""
    p = sum((X**k * c for k, c in enumerate(coefficients)), lift(0))
    slope = (p - substitute(p, {"x": lift(at)})) / (X - at)
    assert substitute(slope, {"x": lift(at)}) == substitute(derivative(p, "x"), {"x": lift(at)})


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (root(X), 1 / (2 * root(X))),
        (root(X * X + Y), X / root(X * X + Y)),
        (function("ln", X * Y), 1 / X),
        (function("exp", X * Y), Y * function("exp", X * Y)),
        (function("atan", X), 1 / (1 + X * X)),
        (function("asin", X), 1 / root(1 - X * X)),
        (function("acos", X), -1 / root(1 - X * X)),
        (cosine(X * Y), -Y * sine(X * Y)),
        (function("tan", X), 1 / cosine(X) ** 2),
        (sine(X) ** 2 + cosine(X) ** 2, lift(0)),
        (Y, lift(0)),
    ],
)
def test_known_derivatives(value: Scalar, expected: Scalar) -> None:
    assert same(derivative(value, "x"), expected)


@steady
@given(polynomials, polynomials)
def test_substitution_is_composition(p: Scalar, q: Scalar) -> None:
    """The value at x = q is the number at that number; so is the chain rule."""
    found = substitute(p, {"x": q})
    inner = number(q)
    assume(abs(inner) < 20)
    assert close(number(found), number(p, {**POINT, "x": inner}))
    outer = substitute(derivative(p, "x"), {"x": q})
    direct = substitute(derivative(p, "a"), {"x": q})
    assert same(derivative(found, "a"), outer * derivative(q, "a") + direct)


def test_substitution_is_simultaneous() -> None:
    assert substitute(X - 2 * Y, {"x": Y, "y": X}) == Y - 2 * X
    assert substitute(cosine(A - B), {"a": B, "b": A}) == cosine(A - B)
    assert substitute(cosine(A), {"a": PI}) == -1
    assert substitute(root(X), {"x": lift(9)}) == 3
    assert substitute(X, {}) is X


def test_dependence() -> None:
    assert depends_on(cosine(A * 2 + B), "b") and not depends_on(cosine(A), "b")
    assert depends_on(root(X + 1), "x") and depends_on(1 / (1 + X), "x")
    [m] = (M * cosine(A) * X**2).num.terms
    free, bound = split_factor(m, "a")
    assert set(free) | set(bound) == set(m) and len(bound) == 1


integrands = st.lists(
    st.tuples(
        fractions,
        st.integers(0, 3),  # power of the variable
        st.integers(0, 4),  # of its cosine
        st.integers(0, 3),  # of its sine
        st.sampled_from([lift(1), M, cosine(B), 1 / M]),
        st.sampled_from([lift(1), cosine(2 * A), sine(A - B), cosine(3 * A + B)]),
    ),
    min_size=1,
    max_size=3,
)


@steady
@given(integrands)
def test_antiderivative_differentiates_back(terms) -> None:
    value = lift(0)
    for c, power, cosines, sines, free, wave in terms:
        value = value + A**power * cosine(A) ** cosines * sine(A) ** sines * free * wave * c
    found = antiderivative(value, "a")
    assert found is not None
    assert same(derivative(found, "a"), value)


@steady
@given(integrands, st.sampled_from([lift(0), B, PI * Fraction(1, 2)]), st.sampled_from([A, PI, X]))
def test_definite_integral_is_additive(terms, lower: Scalar, upper: Scalar) -> None:
    value = sum((A**power * cosine(A) ** c * sine(A) ** s * n for n, power, c, s, _, _ in terms), lift(0))
    whole = definite(value, "a", lower, upper)
    parts = definite(value, "a", lower, Y) + definite(value, "a", Y, upper)
    assert same(whole, parts)
    assert is_zero(definite(value, "a", upper, upper))
    assert same(whole, -definite(value, "a", upper, lower))


@pytest.mark.parametrize("sines", range(-4, 5))
@pytest.mark.parametrize("cosines", range(-4, 5))
def test_powers_of_sine_and_cosine(cosines: int, sines: int) -> None:
    value = cosine(2 * X + Y) ** cosines * sine(2 * X + Y) ** sines
    found = antiderivative(value, "x")
    assert found is not None or min(cosines, sines) < 0
    assert found is None or same(derivative(found, "x"), value)


@pytest.mark.parametrize(
    ("value", "lower", "upper", "expected"),
    [
        (cosine(A), lift(0), PI * Fraction(1, 2), lift(1)),
        (sine(A) ** 2, lift(0), 2 * PI, PI),
        (X**2 * M / Y, -Y / 2, Y / 2, M * Y**2 / 12),
        (root(X), lift(0), lift(4), lift(Fraction(16, 3))),
        (X / root(1 + X**2), lift(0), Y, root(1 + Y**2) - 1),
        (1 / X, Y, M, function("ln", M) - function("ln", Y)),
        (X * sine(X), lift(0), PI, PI),
        (cosine(X * Y), lift(0), PI / Y, lift(0)),
        ((1 + M) / (1 + Y) * X, lift(0), lift(2), 2 * (1 + M) / (1 + Y)),
        (1 / sine(X) ** 2, PI * Fraction(1, 4), PI * Fraction(1, 2), lift(1)),
        (cosine(X) / sine(X) ** 4, PI * Fraction(1, 6), PI * Fraction(1, 2), lift(Fraction(7, 3))),
        (sine(X) ** 2 / cosine(X) ** 2, lift(0), PI * Fraction(1, 4), 1 - PI * Fraction(1, 4)),
        (function("exp", X * 2), lift(0), lift(1), (function("exp", lift(2)) - 1) / 2),
    ],
)
def test_known_integrals(value: Scalar, lower: Scalar, upper: Scalar, expected: Scalar) -> None:
    name = "a" if depends_on(value, "a") else "x"
    assert same(definite(value, name, lower, upper), expected)


@pytest.mark.parametrize(
    "value", [root(X) * sine(X), 1 / (1 + X), function("exp", X * X), cosine(X * X), 1 / cosine(X), sine(X) / X]
)
def test_outside_the_class(value: Scalar) -> None:
    assert antiderivative(value, "x") is None
    assert definite(value, "x", symbol("p"), symbol("q")) is None


def test_cosines_of_twelfths_of_a_turn():
    for k in range(-24, 25):
        assert abs(numbers.number(cosine(PI * k / 12), {}) - math.cos(math.pi * k / 12)) < 1e-12, k
        assert abs(numbers.number(sine(PI * k / 12), {}) - math.sin(math.pi * k / 12)) < 1e-12, k


@pytest.mark.parametrize(("cosines", "sines"), [(2, -2), (-2, 2), (4, -2), (-4, 2)])
def test_squares_over_squares_are_integrated(cosines, sines):
    x = symbol("x")
    value = cosine(x) ** cosines * sine(x) ** sines
    found = antiderivative(value, "x")
    assert found is not None and same(derivative(found, "x"), value)


def test_the_derivative_of_a_root():
    x = symbol("x")
    assert same(derivative(root(x), "x") * root(x), lift(Fraction(1, 2)))


def test_angles_of_known_sines_and_tangents() -> None:
    assert all(same(sine(angle), value) for value, angle in SINES.items())
    assert all(same(sine(angle), value * cosine(angle)) for value, angle in TANGENTS.items())


@pytest.mark.parametrize("number", [Fraction(2, 3), Fraction(-2, 3), Fraction(3), Fraction(-1, 2)])
@pytest.mark.parametrize("radicand", [X * 6, X / Y / 3, X + Y * 2, 2 / X])
def test_a_number_goes_into_a_root_with_its_sign_before_it(number, radicand) -> None:
    value = root(radicand) * A * number
    for whole in (value, value + B, value * root(lift(2))):
        assert math.isclose(numbers.number(with_numbers_inside(whole), POINT), numbers.number(whole, POINT))
