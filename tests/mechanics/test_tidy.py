"""Values keep their value when they are tidied; bodies without mass; searches that end."""


import pytest

from rbpsym.field.calculus import root
from rbpsym.field.normal import same, without_even_roots
from rbpsym.field.scalar import Scalar, lift, symbol
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.inertia import inertia, tidy
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_problem
from tests.effort import MANY, at_most
from tests.mechanics.test_textbook_coupled import SYSTEMS
from tests.mechanics.test_textbook_motion import SYSTEMS as MOTION

X, Y = symbol("x"), symbol("y")
ROOTED = [
    1 / root(lift(2)),
    X / root(X),
    root(X) ** 3 + Y,
    root(X + Y) ** 4,
    1 / root(X + Y),
    3 / root(X + Y) ** 3,
    root(lift(2)) * root(lift(3)) ** -3,
    root(X / (1 + Y)) ** 2,
    root(1 - X * X) ** 5 / X,
]


@pytest.mark.parametrize("value", ROOTED, ids=range(len(ROOTED)))
def test_tidying_keeps_the_value(value: Scalar) -> None:
    """1/√2 once became √2: the normal form of a zero test holds up to a factor, a value must not."""
    at = {"x": 0.37, "y": 0.21}
    assert number(tidy(value), at) == pytest.approx(number(value, at), rel=1e-12)
    assert number(Scalar(without_even_roots(value.num), value.den), at) == pytest.approx(number(value, at), rel=1e-12)


def test_squares_of_roots_of_numbers_are_numbers() -> None:
    """A triangle of rods once had 3 + 2√3² below its bars."""
    three = root(lift(3))
    assert short(three**2 * X) == 3 * X
    assert short(three**3 * X + Y) == 3 * three * X + Y


def test_even_powers_are_gone() -> None:
    assert tidy(root(X + Y) ** 4) == (X + Y) ** 2
    assert tidy(1 / root(lift(2))) == root(lift(2)) / 2
    assert same(tidy(root(X) ** 3), X * root(X))


def test_a_body_without_mass() -> None:
    text = next(s.text for s in MOTION if "without mass" in s.name)
    rod = load_problem(text).body("rod")
    found = inertia(rod)
    assert not found.mass
    assert not found.moment


def test_the_search_for_equilibria_ends() -> None:
    """Roots of one equation that lead only to nested roots in the next are not followed."""
    text = next(s.text for s in SYSTEMS if "spring of no length" in s.name)
    with at_most(MANY):
        assert not Study(load_problem(text)).equilibria


def test_sample_numbers_do_not_depend_on_names() -> None:
    text = next(s.text for s in MOTION if s.name == "rod that falls about a hinge")
    other = text.replace('g = "acc', 'a = "acc').replace('type = "gravity"', 'type = "gravity"\ng = "a"')
    assert list(sample(load_problem(text)).values()) == list(sample(load_problem(other)).values())
