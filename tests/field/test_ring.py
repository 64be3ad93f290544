"""The axioms of a field, for sums, products and quotients of parameters, sines and cosines."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import assume, given

from rbpsym.errors import LimitError
from rbpsym.field.normal import is_zero, same
from rbpsym.field.poly import ONE, ZERO, Poly, accumulate, constant
from rbpsym.field.scalar import NOTHING, UNITY, Scalar, lift, quotient, show
from tests.field.strategies import A, X, Y, close, fractions, number, polynomials, quotients, scalars, steady


@steady
@given(scalars, scalars, scalars)
def test_addition(p: Scalar, q: Scalar, r: Scalar) -> None:
    assert same(p + q, q + p)
    assert same((p + q) + r, p + (q + r))
    assert same(p + NOTHING, p)
    assert same(p - p, NOTHING)
    assert same(p - q, -(q - p))


@steady
@given(scalars, scalars, polynomials)
def test_multiplication(p: Scalar, q: Scalar, r: Scalar) -> None:
    assert same(p * q, q * p)
    assert same((p * q) * r, p * (q * r))
    assert same(p * UNITY, p)
    assert same(p * (q + r), p * q + p * r)


@steady
@given(scalars, scalars)
def test_division(p: Scalar, q: Scalar) -> None:
    assume(not is_zero(q))
    assert same(p / q * q, p)
    assert same(q / q, UNITY)
    assert same(1 / (1 / q), q)


@steady
@given(scalars, fractions)
def test_numbers_mix_in(p: Scalar, n) -> None:
    assert same(p + n, n + p) and same(p + n, p + lift(n))
    assert same(p * n, n * p)
    assert same(n - p, -(p - n))


@steady
@given(polynomials)
def test_powers(p: Scalar) -> None:
    assert same(p**3, p * p * p)
    assert p**0 == UNITY
    assume(not is_zero(p))
    assert same(p**-2 * p**2, UNITY)


@steady
@given(quotients, polynomials)
def test_operations_are_those_of_numbers(p: Scalar, q: Scalar) -> None:
    assume(abs(number(p.den)) > 1e-3)
    assert close(number(p + q), number(p) + number(q))
    assert close(number(p * q), number(p) * number(q))


@steady
@given(scalars, scalars)
def test_equal_values_have_equal_hashes(p: Scalar, q: Scalar) -> None:
    again = Scalar(Poly(dict(reversed(p.num.terms.items()))), Poly(dict(p.den.terms)))
    assert again == p and hash(again) == hash(p)
    assert p != q or hash(p) == hash(q)


@steady
@given(scalars)
def test_a_denominator_of_one_term_is_absorbed(p: Scalar) -> None:
    assert p.den == ONE or len(p.den) > 1
    assert (p / X).den == p.den or len((p / X).den) > 1


@steady
@given(polynomials, fractions)
def test_sums_in_one_pass(p: Scalar, n) -> None:
    assert accumulate([(n, p.num), (1 - n, p.num)]) == p.num
    assert p.num.scaled(0) == ZERO


def test_division_by_zero() -> None:
    with pytest.raises(ZeroDivisionError):
        X / NOTHING
    with pytest.raises(ZeroDivisionError):
        NOTHING**-1


def test_too_many_terms() -> None:
    with pytest.raises(LimitError):
        Scalar(accumulate((1, (X + k).num * (Y**k).num) for k in range(300))) ** 40


def test_forms() -> None:
    assert X - X == 0 and not X - X
    assert (X * 3).number() is None and lift(7).number() == 7
    assert (X / 2).num == X.num.scaled(lift(1).num.constant_value()) * constant((lift(1) / 2).number())
    assert quotient(ZERO, (X + Y).num) == NOTHING
    assert (A + X).atoms() == A.atoms() | X.atoms()
    assert show((X + 1) / (Y - 1)) and repr(X) == "Scalar(x)"


def test_zero_is_not_nothing() -> None:
    """A bound 0 of a range is not the absence of a bound."""
    assert NOTHING != None  # noqa: E711  (what tuples of bounds do)
    assert (None, NOTHING) != (None, None)
    assert NOTHING == 0 and lift(Fraction(1, 2)) == Fraction(1, 2)
    assert NOTHING != "" and X != 1 and lift(3) != "3"
