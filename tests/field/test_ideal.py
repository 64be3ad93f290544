"""The zero test under conditions, and roots with squares taken out."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given

from rbpsym.field.calculus import root
from rbpsym.field.division import vanishes_on
from rbpsym.field.roots import simplified_root
from rbpsym.field.scalar import Scalar, lift, symbol
from rbpsym.field.trig import cosine, sine
from tests.field.strategies import POINT, A, B, M, X, Y, close, fractions, number, polynomials, steady

CIRCLE = X * X + Y * Y - 1
LADDER = X - 2 * cosine(A)


@pytest.mark.parametrize(
    ("value", "relations", "vanishes"),
    [
        (CIRCLE, [CIRCLE], True),
        (CIRCLE * M, [CIRCLE], True),
        (X**4 - (1 - Y * Y) ** 2, [CIRCLE], True),
        (X - 1, [CIRCLE], False),
        (X * X + 4 * sine(A) ** 2 - 4, [LADDER], True),
        (X * X - 2 - 2 * cosine(2 * A), [LADDER], True),
        (X - 2 * sine(A), [LADDER], False),
        (X**2 * M - Y**2 * M, [X - Y], True),
        (M, [X - Y, X + Y], False),
        (X, [X - Y, X + Y], True),
        (sine(A) ** 2 + cosine(A) ** 2 - 1, [], True),
        (cosine(A) - cosine(B), [cosine(A) - cosine(B), sine(A) - sine(B)], True),
        (cosine(A - B) - 1, [cosine(A) - cosine(B), sine(A) - sine(B)], True),
        (sine(A + B) - 2 * sine(A) * cosine(A), [cosine(A) - cosine(B), sine(A) - sine(B)], True),
        ((X - Y) / (X * X + 1), [X - Y], True),
        (X * X, [X], True),
        (X, [X * X], False),  # it vanishes, but is not in the ideal: no proof
    ],
)
def test_vanishing_on_conditions(value: Scalar, relations: list[Scalar], vanishes: bool) -> None:
    assert vanishes_on(value, relations) is vanishes


@steady
@given(polynomials, polynomials)
def test_combinations_of_conditions_vanish(p: Scalar, q: Scalar) -> None:
    relations = [X - cosine(A), M * X - Y]
    assert vanishes_on(p * relations[0] + q * relations[1], relations)


def always(name: str) -> bool:
    return name != ""  # a sine has no name


def never(_name: str) -> bool:
    return False


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (X * X, X),
        (X**3 * Y, X * root(X * Y)),
        (4 * X * X * (1 + Y), 2 * X * root(1 + Y)),
        (lift(Fraction(9, 4)), lift(Fraction(3, 2))),
        (12 * X, 2 * root(lift(3)) * root(X)),
        (X * X / Y**2, X / Y),
        (M, root(M)),
    ],
)
def test_squares_come_out(value: Scalar, expected: Scalar) -> None:
    assert simplified_root(value, always) == expected


def test_signs_are_respected() -> None:
    assert simplified_root(X * X, never) == root(X * X)
    assert simplified_root(4 * X * X, never) == 2 * root(X * X)
    assert simplified_root(X * X * Y, lambda name: name == "y") == root(X * X * Y)


@steady
@given(polynomials, fractions.filter(bool))
def test_the_value_is_kept(p: Scalar, c: Fraction) -> None:
    radicand = p * p * abs(c) * X**3 / Y
    assert close(number(simplified_root(radicand, always), POINT), number(radicand, POINT) ** 0.5)


def test_names_are_what_is_asked_for() -> None:
    asked: list[str] = []
    simplified_root(symbol("q") ** 2 * cosine(A) ** 2, lambda name: bool(asked.append(name)))
    assert "q" in asked
