"""Functions of quotients, and waves of inverse functions: what is equal is proved, what is not is not."""

from collections.abc import Callable

import pytest

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import _factors
from rbpsym.decide.equal import scalars_equal
from rbpsym.field.calculus import root
from rbpsym.field.scalar import Scalar, generator_of, lift, symbol
from rbpsym.field.trig import cosine, sine
from tests.field.strategies import close, number

X, Y = symbol("x"), symbol("y")
WITHIN = Assumptions({"x": "positive", "y": "positive"}, {"x": (lift(0), lift(1))})
AT = {"x": 0.37, "y": 0.6}


def proved(left: Scalar, right: Scalar) -> bool:
    return scalars_equal(left, right, WITHIN).is_proved


@pytest.mark.parametrize("kind", ["exp", "ln", "atan", "asin", "acos", "root"])
def test_a_function_of_a_quotient_is_none_of_a_product(kind: str) -> None:
    small = X / (2 + Y)
    assert not proved(generator_of(kind, small), generator_of(kind, X * (2 + Y) / 9))
    assert not proved(generator_of(kind, small), generator_of(kind, X * (2 + Y)))
    assert proved(generator_of(kind, small), generator_of(kind, (X * Y) / (2 * Y + Y * Y)))


WAVES: dict[str, Callable[[Scalar], tuple[Scalar, Scalar]]] = {
    "asin": lambda x: (root(1 - x * x), x),
    "acos": lambda x: (x, root(1 - x * x)),
    "atan": lambda x: (1 / root(1 + x * x), x / root(1 + x * x)),
}


@pytest.mark.parametrize("kind", WAVES)
@pytest.mark.parametrize("times", [-2, -1, 0, 1, 2])
def test_waves_of_multiples_of_inverse_functions(kind: str, times: int) -> None:
    angle = generator_of(kind, X)
    c, s = lift(1), lift(0)
    cos, sin = WAVES[kind](X)
    for _ in range(abs(times)):
        c, s = c * cos - s * sin, s * cos + c * sin
    s = s if times >= 0 else -s
    for one, other in ((cosine(angle * times), c), (sine(angle * times), s)):
        assert close(number(one, AT), number(other, AT))
        assert proved(one, other)
    assert not proved(cosine(angle * (times or 3)), WAVES["acos" if kind != "acos" else "asin"](X)[1] + X)


def test_half_of_an_inverse_cosine() -> None:
    half = generator_of("acos", X) / 2
    assert proved(cosine(half) ** 2, (1 + X) / 2) and proved(sine(half), root((1 - X) / 2))


@pytest.mark.parametrize("value", [(X - 2) / X, (X - 2) * X**2, X**-3 * (X * X + Y) * (X - Y)])
def test_what_a_value_is_a_product_of(value: Scalar) -> None:
    found = list(_factors(value, "x"))
    assert X in found and len(found) == len(set(found))
    rest = value
    for factor in found:
        while (shorter := rest / factor).den.terms == lift(1).num.terms and len(shorter.num) < len(rest.num):
            rest = shorter
    assert len(rest.num) == 1


@pytest.mark.parametrize(
    ("left", "right", "without_signs"),
    [
        (generator_of("ln", X) + generator_of("ln", Y), generator_of("ln", X * Y), True),
        (root(X) * root(Y), root(X * Y), True),
        (root(X * X * Y), X * root(Y), False),
    ],
)
def test_what_holds_wherever_both_have_a_value_is_proved(left: Scalar, right: Scalar, without_signs: bool) -> None:
    assert proved(left, right)
    assert scalars_equal(left, right).is_proved is without_signs


COSINES = {
    "asin": (root(1 - X * X), X), "acos": (X, root(1 - X * X)), "atan": (1 / root(1 + X * X), X / root(1 + X * X)),
}  # fmt: skip


@pytest.mark.parametrize("kind", COSINES)
def test_waves_of_a_sum_with_an_inverse_function(kind: str) -> None:
    cos, sin = COSINES[kind]
    angle = generator_of(kind, X) + Y
    assert proved(cosine(angle), cos * cosine(Y) - sin * sine(Y))
    assert proved(sine(angle), sin * cosine(Y) + cos * sine(Y))
    assert not proved(cosine(angle), sin * cosine(Y) - cos * sine(Y))
