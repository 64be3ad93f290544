"""Normal forms: zero is found exactly, and no form changes the value."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import assume, given

from rbpsym.field.calculus import function, root
from rbpsym.field.modular import is_surely_nonzero
from rbpsym.field.normal import (
    bases_of,
    is_rooted,
    is_zero,
    normal,
    reduce_squares,
    same,
    shorten,
    without_even_roots,
    without_squares,
)
from rbpsym.field.scalar import PI, Scalar, lift
from rbpsym.field.trig import cosine, sine
from tests.field.strategies import OTHER, POINT, A, B, X, Y, angles, close, number, polynomials, steady


@steady
@given(angles)
def test_pythagoras(angle: Scalar) -> None:
    assert is_zero(cosine(angle) ** 2 + sine(angle) ** 2 - 1)
    assert not is_zero(cosine(angle) ** 2 + sine(angle) ** 2 - Fraction(999, 1000))


@steady
@given(angles, angles)
def test_compound_angles(a: Scalar, b: Scalar) -> None:
    assert same(cosine(a + b), cosine(a) * cosine(b) - sine(a) * sine(b))
    assert same(sine(a - b), sine(a) * cosine(b) - cosine(a) * sine(b))


@steady
@given(angles)
def test_waves_have_their_values(angle: Scalar) -> None:
    import math

    for of, exact in ((math.cos, cosine), (math.sin, sine)):
        assert close(of(number(angle)), number(exact(angle)))


@steady
@given(angles)
def test_symmetries_of_waves(angle: Scalar) -> None:
    assert cosine(-angle) == cosine(angle)
    assert sine(-angle) == -sine(angle)
    assert cosine(angle + PI) == -cosine(angle)
    assert sine(angle + 2 * PI) == sine(angle)
    assert sine(PI * Fraction(1, 2) - angle) == cosine(angle)


@steady
@given(polynomials)
def test_forms_keep_the_value(value: Scalar) -> None:
    for form in (normal, reduce_squares, shorten, without_even_roots):
        for point in (POINT, OTHER):
            assert close(number(form(value.num), point), number(value.num, point)), form


@steady
@given(polynomials)
def test_normal_form_is_idempotent(value: Scalar) -> None:
    once = normal(value.num)
    assert normal(once, bases_of(value.num)) == once
    assert len(shorten(value.num)) <= len(value.num)


@steady
@given(polynomials, polynomials)
def test_zero_is_decided(p: Scalar, q: Scalar) -> None:
    """What is zero vanishes at points; what is not does not at all of them."""
    difference = p * q - q * p + p - q
    values = [abs(number(difference, point)) for point in (POINT, OTHER)]
    assert is_zero(difference) == (max(values) < 1e-9)


@steady
@given(polynomials)
def test_modular_refutation_is_right(value: Scalar) -> None:
    assume(not is_rooted(value.num))
    if is_surely_nonzero(value.num):
        assert normal(value.num).terms


@pytest.mark.parametrize("n", range(1, 13))
def test_multiple_angles(n: int) -> None:
    """cos(nA) + i sin(nA) by repeated multiplication."""
    c, s = lift(1), lift(0)
    for _ in range(n):
        c, s = c * cosine(A) - s * sine(A), s * cosine(A) + c * sine(A)
    assert same(cosine(n * A), c) and same(sine(n * A), s)
    assert not same(cosine(n * A), c + sine(A) ** 9)


@pytest.mark.parametrize("denominator", range(1, 25))
def test_special_angles(denominator: int) -> None:
    import math

    for k in range(-denominator, 2 * denominator):
        turns = Fraction(k, denominator)
        assert math.isclose(number(cosine(PI * turns)), math.cos(math.pi * turns), abs_tol=1e-12)
        assert math.isclose(number(sine(PI * turns)), math.sin(math.pi * turns), abs_tol=1e-12)


def test_roots_are_reduced() -> None:
    r = root(X * X + Y)
    assert is_zero(r * r - X * X - Y)
    assert is_zero(r**4 - (X * X + Y) ** 2)
    assert not is_zero(r - X)
    assert is_zero(1 / r - r / (X * X + Y))
    assert same(root(lift(12)), 2 * root(lift(3)))
    assert same(root(lift(Fraction(1, 2))), root(lift(2)) / 2)
    assert same(root(lift(6)), root(lift(2)) * root(lift(3)))


def test_squares_of_sines_or_cosines_are_replaced() -> None:
    [sine_index], [cosine_index] = sine(A).atoms(), cosine(A).atoms()
    p = (sine(A) ** 3 + cosine(A) ** 2).num
    assert max(without_squares(p, sine_index).by_power(sine_index)) == 1
    assert max(without_squares(p, cosine_index).by_power(cosine_index)) <= 1


def test_functions_are_independent() -> None:
    assert not same(function("exp", A + B), function("exp", A) * function("exp", B))  # for `radicals` to decide
    assert same(function("tan", A), sine(A) / cosine(A))
    assert function("exp", lift(0)) == 1 and function("ln", lift(1)) == 0
