"""Division and cancelling: exact, complete for common factors, and never a change of value."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import assume, given

from rbpsym.field import flint_ring, ring, sympy_bridge
from rbpsym.field.division import cancel, divide, without_poles
from rbpsym.field.normal import is_zero, normal, partner, same
from rbpsym.field.poly import ONE, Poly, inverse
from rbpsym.field.ring import cofactors, factors
from rbpsym.field.scalar import Scalar, lift, quotient
from rbpsym.field.sympy_bridge import to_sympy
from rbpsym.field.trig import cosine, sine
from tests.field.strategies import A, B, M, X, Y, divisors, polynomials, quotients, steady


@steady
@given(polynomials, divisors)
def test_a_product_divides(p: Scalar, q: Scalar) -> None:
    found = divide(p.num * q.num, q.num)
    assert found is not None and found == p.num


@steady
@given(polynomials, divisors)
def test_what_divides_multiplies_back(p: Scalar, q: Scalar) -> None:
    found = divide(p.num, q.num)
    assert found is None or found * q.num == p.num


@steady
@given(polynomials, divisors, divisors)
def test_cancelling_keeps_the_quotient(p: Scalar, q: Scalar, common: Scalar) -> None:
    num, den = cancel(p.num * common.num, q.num * common.num)
    assert is_zero(Scalar(num * q.num - p.num * den))


@steady
@given(polynomials, divisors, divisors)
def test_a_common_factor_goes(p: Scalar, q: Scalar, common: Scalar) -> None:
    assert same((p * common) / (q * common), p / q)
    assert (p * common) / common - p == 0 or same((p * common) / common, p)


@steady
@given(quotients)
def test_no_fraction_inside_a_quotient(p: Scalar) -> None:
    """Coefficients below are whole, without common factor, and the form is kept by itself."""
    if p.den != ONE:
        assert all(c.denominator == 1 for c in p.den.terms.values())
        assert p.den.content() == (Fraction(1), ())
    assert same(quotient(p.num, p.den), p)


@steady
@given(polynomials)
def test_factors_multiply_to_the_polynomial(p: Scalar) -> None:
    assume(p.num.terms and all(e > 0 for m in p.num.terms for _, e in m))
    coefficient, found = factors(p.num)
    product = lift(coefficient)
    for factor, exponent in found:
        product = product * Scalar(factor) ** exponent
    assert product == p


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        ((X**2 - Y**2) / (X - Y), X + Y),
        ((X**5 - 1) / (X - 1), X**4 + X**3 + X**2 + X + 1),
        ((X**2 * M + X * M * Y) / (X * M), X + Y),
        ((1 - cosine(A) ** 2) / (1 - cosine(A)), 1 + cosine(A)),
        (sine(A) ** 2 / (1 + cosine(A)), 1 - cosine(A)),
        ((X + Y) ** 3 / (X + Y) ** 2, X + Y),
        (1 / (1 / X + 1 / Y), X * Y / (X + Y)),
        ((cosine(A - B) ** 2 - 1) / sine(A - B), -sine(A - B)),
    ],
)
def test_cancelled_forms(value: Scalar, expected: Scalar) -> None:
    assert same(value, expected)
    assert value.den == expected.den


def test_division_by_a_hidden_zero() -> None:
    with pytest.raises(ZeroDivisionError):
        X / (sine(A) ** 2 + cosine(A) ** 2 - 1)


def test_cofactors_are_coprime() -> None:
    a, b = cofactors(((X + Y) * (X - 1)).num, ((X + Y) * M).num)
    assert (a, b) == ((X - 1).num, M.num) or (a, b) == ((1 - X).num, (-M).num)


def test_sympy_sees_the_same_value() -> None:
    import sympy

    names = {name: sympy.Symbol(name) for name in "abxy"}
    value = (X * cosine(A + B) + sine(A) ** 2) / (1 + Y**2)
    expected = (names["x"] * sympy.cos(names["a"] + names["b"]) + sympy.sin(names["a"]) ** 2) / (1 + names["y"] ** 2)
    assert sympy.simplify(to_sympy(value) - expected) == 0


@steady
@given(polynomials, divisors, divisors)
def test_flint_and_sympy_find_the_same(p: Scalar, q: Scalar, common: Scalar) -> None:
    """Factors with their order and scale, cofactors up to a number, in plain integers and fractions."""
    a, b = (_without_inverses((part * common).num) for part in (p, q))
    assume(a.terms)
    found = []
    for backend in (flint_ring, sympy_bridge):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(ring, "backend", lambda backend=backend: backend)
            found.append((ring.factors.__wrapped__(a), ring.cofactors(a, b)))
    (ours, (x, y)), (theirs, (z, w)) = found
    assert ours == theirs
    assert x * w == y * z and len(x) == len(z)
    for poly in (x, y, *(factor for factor, _ in ours[1])):
        assert all(type(c) in (int, Fraction) for c in poly.terms.values())
        assert all(type(e) is int for m in poly.terms for _, e in m)


def _without_inverses(poly: Poly) -> Poly:
    return poly.scaled(1, inverse(poly.content()[1]))


def _summed(nested, values) -> Fraction:
    """The polynomial of nested coefficients at a place, by Horner's rule."""
    if not values:
        return Fraction(nested)
    total = Fraction(0)
    for part in nested:
        total = total * values[0] + _summed(part, values[1:])
    return total


@pytest.mark.parametrize("powers", [{(2,): 1, (0,): 5}, {(3, 0): 2, (1, 2): -1, (0, 1): 4}, {(0, 0, 2): 1, (2, 1, 0): 7}])
def test_nested_coefficients_are_those_of_the_polynomial(powers) -> None:
    [count] = {len(key) for key in powers}
    place = [Fraction(3), Fraction(-2, 5), Fraction(7)][:count]
    value = sum(c * math.prod(x**k for x, k in zip(place, key, strict=True)) for key, c in powers.items())
    assert _summed(ring._nested([*powers.items()], 0, count), place) == value


X_SIN, X_COS, Y_SIN, Y_COS, TURN = sine(X), cosine(X), sine(Y), cosine(Y), cosine(X - Y)
SPREAD = Scalar(normal((sine(X - Y) * (M + TURN)).num))
POLES = {  # above, below, and what is left below
    "one of several": (1 - X_SIN**2, X_SIN * X_COS**2, X_SIN),
    "the other": (1 - X_COS**2, X_COS * X_SIN**2, X_COS),
    "a sum": (A**2 - (A**2 + B**2) * X_COS**2, A * X_SIN - B * X_COS, lift(1)),
    "its square": ((A * X_SIN - B * X_COS) ** 2 * (A + X_SIN), (A * X_SIN - B * X_COS) ** 2, lift(1)),
    "two angles": (1 - X_COS**2 - Y_SIN**2 * X_SIN**2, Y_COS * X_SIN, lift(1)),
    "the angle between": ((M - TURN**2) * A, M - X_COS * Y_COS * TURN - X_SIN * Y_SIN * TURN, lift(1)),
    "of a difference, in both angles": (A * sine(X - Y), SPREAD, M + TURN),
    "half of them": (1 - X_COS, X_SIN, 1 + X_COS),
    "a true one": (A - X_COS, X_SIN, X_SIN),
    "none": (A, B + M, lift(1)),
}


@pytest.mark.parametrize("above, below, left", POLES.values(), ids=POLES)
def test_of_poles_those_are_left_that_the_circle_does_not_take_away(above: Scalar, below: Scalar, left: Scalar) -> None:
    value = above / below
    found = without_poles(value)
    assert same(found, value)
    whole = found * left
    assert not any(partner(i) for i in whole.den.atoms()) and all(e > 0 for m in whole.num.terms for i, e in m if partner(i))
