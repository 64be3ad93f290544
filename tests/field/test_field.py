"""Laws of the field, of derivatives and of antiderivatives, on random values."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rbpsym.decide.enclosure import ends
from rbpsym.decide.points import Point
from rbpsym.errors import LimitError, Undecided
from rbpsym.field.calculus import derivative, function, root, substitute
from rbpsym.field.division import cancel, divide
from rbpsym.field.integration import antiderivative, definite
from rbpsym.field.modular import is_surely_nonzero
from rbpsym.field.normal import is_zero, normal, same
from rbpsym.field.poly import Poly
from rbpsym.field.scalar import NOTHING, PI, UNITY, Scalar, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.field.vector import EX, EY, Space, cartesian, polar

M, ELL, X, A, B = map(symbol, ("m", "ell", "x", "alpha", "beta"))
quickly = settings(max_examples=50, suppress_health_check=[HealthCheck.too_slow])
numbers = st.fractions(min_value=-3, max_value=3, max_denominator=4).map(lift)
WAVY = [cosine(A), sine(A), cosine(B), sine(A - B), cosine(A * 2), sine(X)]
leaves = st.one_of(numbers, st.sampled_from([M, ELL, X, *WAVY]))


def _sums(inner):
    return st.one_of(
        st.tuples(inner, inner).map(lambda pair: pair[0] + pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] * pair[1]),
    )


polynomials = st.recursive(leaves, _sums, max_leaves=5)
divisors = st.sampled_from([M, M + ELL, lift(2), 1 + sine(A) ** 2, M * ELL + X * X + 1, 2 - cosine(B)])
values = st.tuples(polynomials, divisors).map(lambda pair: pair[0] / pair[1])
POINT = Point(
    {"m": Fraction(3, 2), "ell": Fraction(5, 7), "x": Fraction(-2, 3)},
    {"alpha": (Fraction(3, 5), Fraction(4, 5)), "beta": (Fraction(-5, 13), Fraction(12, 13))},
    {"alpha": 2, "beta": 1},
)


@quickly
@given(values, values, values)
def test_ring_axioms(a: Scalar, b: Scalar, c: Scalar) -> None:
    assert same(a + b, b + a)
    assert same(a * b, b * a)
    assert same((a + b) + c, a + (b + c))
    assert same((a * b) * c, a * (b * c))
    assert same(a * (b + c), a * b + a * c)
    assert is_zero(a - a)
    assert same(a + NOTHING, a) and same(a * UNITY, a)


@quickly
@given(values)
def test_inverses(a: Scalar) -> None:
    if not is_zero(a):
        assert same(a * a.inverse(), UNITY)
        assert same(a**-2 * a**3, a)


@quickly
@given(values, values)
def test_value_at_a_point_is_a_homomorphism(a: Scalar, b: Scalar) -> None:
    for found, wanted in ((a + b, POINT.value(a) + POINT.value(b)), (a * b, POINT.value(a) * POINT.value(b))):
        difference = POINT.value(found) - wanted
        low, high = ends(difference)
        assert low <= 0 <= high and high - low < Fraction(1, 10**20)


@quickly
@given(polynomials)
def test_normal_form_is_idempotent_and_kind_to_values(a: Scalar) -> None:
    once = normal(a.num)
    assert normal(once) == once
    low, high = ends(POINT.poly(once) - POINT.poly(a.num))
    assert low <= 0 <= high


@quickly
@given(polynomials)
def test_surely_nonzero_is_nonzero(a: Scalar) -> None:
    if is_surely_nonzero(a.num):
        assert normal(a.num).terms
    assert not is_surely_nonzero((a * (sine(B) ** 2 + cosine(B) ** 2) - a).num)


@quickly
@given(polynomials, polynomials)
def test_exact_division(a: Scalar, b: Scalar) -> None:
    if not b.num.terms:
        return
    product = a.num * b.num
    assert not product.terms or divide(product, b.num) == a.num
    if not is_zero(b):
        one_more = divide(product + Poly({(): 1}), b.num)
        assert one_more is None or one_more * b.num == product + Poly({(): 1})


@quickly
@given(polynomials, polynomials, divisors)
def test_cancelling_keeps_the_value(a: Scalar, b: Scalar, c: Scalar) -> None:
    if is_zero(b):
        return
    num, den = cancel(a.num * c.num, b.num * c.num)
    assert is_zero(Scalar(num * b.num - den * a.num))


@quickly
@given(values, values, st.sampled_from(["m", "x", "alpha"]))
def test_rules_of_the_derivative(a: Scalar, b: Scalar, name: str) -> None:
    da, db = derivative(a, name), derivative(b, name)
    assert same(derivative(a + b, name), da + db)
    assert same(derivative(a * b, name), da * b + a * db)
    if not is_zero(b):
        assert same(derivative(a / b, name) * b * b, da * b - a * db)
    assert same(derivative(derivative(a, "x"), "m"), derivative(derivative(a, "m"), "x"))


@quickly
@given(polynomials, st.sampled_from(["m", "ell"]))
def test_derivative_is_the_limit_of_differences(a: Scalar, name: str) -> None:
    """Exactly: for a polynomial of degree d in the name, d+1 values give the derivative."""
    step, place = Fraction(1, 10**8), POINT.numbers[name]
    sides = []
    for shift in (step, -step):
        moved = Point({**POINT.numbers, name: place + shift}, POINT.angles, POINT.parts)
        sides.append(moved.value(a))
    quotient = (sides[0] - sides[1]) * (1 / (2 * step))
    low, high = ends(quotient - POINT.value(derivative(a, name)))
    assert max(abs(low), abs(high)) < Fraction(1, 10**8)


@quickly
@given(polynomials, polynomials)
def test_substitution_respects_sums_and_products(a: Scalar, b: Scalar) -> None:
    images = {"m": ELL + 1, "alpha": B + PI / 2, "x": B * 2}
    assert same(substitute(a * b, images), substitute(a, images) * substitute(b, images))
    assert same(substitute(a + b, images), substitute(a, images) + substitute(b, images))


WAVES = [X**k * cosine(A) ** p * sine(A) ** q for k in range(3) for p in range(3) for q in range(3)]


@pytest.mark.parametrize("seed", range(25))
def test_antiderivative_is_differentiated_back(seed: int) -> None:
    source = random.Random(seed)
    terms = [source.choice(WAVES) * source.choice([M, ELL, lift(3), cosine(B)]) for _ in range(3)]
    value = sum(terms, NOTHING) / (M + ELL)
    for name in ("x", "alpha", "m"):
        if name == "m":
            value = value * (M + ELL)
        found = antiderivative(value, name)
        assert found is not None
        assert same(derivative(found, name), value)


@pytest.mark.parametrize(
    ("value", "name", "bounds", "result"),
    [
        (X**2, "x", (NOTHING, ELL), ELL**3 / 3),
        (sine(X), "x", (NOTHING, PI), lift(2)),
        (sine(X) ** 2, "x", (NOTHING, PI * 2), PI),
        (X * cosine(X), "x", (NOTHING, PI / 2), PI / 2 - 1),
        (cosine(A * 3) * cosine(A * 3), "alpha", (NOTHING, PI), PI / 2),
        (M / ELL * X**2, "x", (-ELL / 2, ELL / 2), M * ELL**2 / 12),
        (UNITY, "x", (A, B), B - A),
    ],
)
def test_definite_integrals(value: Scalar, name: str, bounds: tuple[Scalar, Scalar], result: Scalar) -> None:
    assert same(definite(value, name, *bounds), result)


@pytest.mark.parametrize("value", [function("exp", X * X), root(1 + X * X), function("ln", X), 1 / (1 + X)])
def test_what_is_outside_the_class_is_not_integrated(value: Scalar) -> None:
    assert antiderivative(value, "x") is None


@quickly
@given(polynomials, polynomials)
def test_plane_vectors(a: Scalar, b: Scalar) -> None:
    turned = polar(a, A) + polar(b, B)
    assert same(turned.x, a * cosine(A) + b * cosine(B))
    assert same(turned.y, a * sine(A) + b * sine(B))
    assert same(turned.dot(turned.turned()), NOTHING)
    assert same(turned.cross(turned.turned()), turned.dot(turned))
    again = cartesian(turned.x, turned.y)
    assert same(again.x, turned.x) and same(again.y, turned.y)


@quickly
@given(polynomials, polynomials, polynomials)
def test_vectors_of_space(a: Scalar, b: Scalar, c: Scalar) -> None:
    u, v = Space(EX * a + EY * b, c), Space(polar(c, A), a)
    w = u.cross(v)
    assert same(w.dot(u), NOTHING) and same(w.dot(v), NOTHING)
    assert same(w.dot(w) + u.dot(v) ** 2, u.dot(u) * v.dot(v))


def test_division_by_a_hidden_zero() -> None:
    with pytest.raises(ZeroDivisionError):
        UNITY / (sine(A) ** 2 + cosine(A) ** 2 - 1)
    with pytest.raises(ZeroDivisionError):
        UNITY / NOTHING
    with pytest.raises(ZeroDivisionError):
        M / ((M + ELL) * (sine(A) ** 2 + cosine(A) ** 2 - 1))


def test_double_angles_below_a_fraction_bar() -> None:
    assert same((2 * cosine(A) ** 2 - 1) / cosine(A * 2), UNITY)
    assert same(2 * sine(A) * cosine(A) / sine(A * 2), UNITY)
    assert not same((2 * cosine(A) ** 2 + 1) / cosine(A * 2), UNITY)


def test_limits_are_told() -> None:
    many = sum((symbol(f"y{k}") for k in range(40)), NOTHING)
    with pytest.raises(LimitError):
        many**9
    with pytest.raises(Undecided):
        cosine(1 / (M + ELL))
