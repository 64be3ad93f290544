"""The images of polynomials modulo a prime are those of a ring, and keep every relation between sines and cosines."""

from fractions import Fraction

import pytest
from hypothesis import assume, given

from rbpsym.field.exponentials import with_squares
from rbpsym.field.modular import NoImage, value_of
from rbpsym.field.normal import is_rooted, same
from rbpsym.field.scalar import Scalar, lift
from rbpsym.field.trig import cosine, sine
from tests.field.strategies import A, B, X, Y, close, number, polynomials, steady, symbol

PRIME = 2**61 - 1


def image(value: Scalar) -> int:
    return value_of(value.num) * pow(value_of(value.den), -1, PRIME) % PRIME


@steady
@given(polynomials, polynomials)
def test_sums_and_products_keep_their_images(p: Scalar, q: Scalar) -> None:
    assume(not is_rooted(p.num) and not is_rooted(q.num))
    try:
        one, other = image(p), image(q)
    except NoImage:
        assume(False)
    assert image(p * q) == one * other % PRIME
    assert image(p + q) == (one + other) % PRIME


@pytest.mark.parametrize(("m", "n"), [(1, 1), (1, -1), (2, 3), (-3, 2), (Fraction(1, 2), Fraction(-5, 3))])
def test_the_images_of_compound_angles_are_those_of_the_parts(m, n) -> None:
    one, other = A * m, B * n
    assert image(cosine(one + other)) == image(cosine(one) * cosine(other) - sine(one) * sine(other))
    assert image(sine(one + other)) == image(sine(one) * cosine(other) + cosine(one) * sine(other))
    assert image(cosine(one) ** 2 + sine(one) ** 2) == 1
    assert image(cosine(2 * one)) == image(1 - 2 * sine(one) ** 2)


SPEED = symbol("x_dot")


@pytest.mark.parametrize(
    "value",
    [SPEED**2, SPEED**3 + 2 * SPEED**2 - SPEED + 5, SPEED**4 * Y - SPEED * X, (1 + SPEED**2) / (Y + SPEED**4), X * Y],
)
def test_a_known_square_of_a_speed_is_put_in(value: Scalar) -> None:
    square = X * X + Y
    found = with_squares(value, {"x": square})
    assert close(number(found, at := {"x": 1.9, "y": 0.6, "x_dot": (1.9**2 + 0.6) ** 0.5}), number(value, at))
    assert same(with_squares(SPEED**2, {"x": lift(4)}), lift(4))
