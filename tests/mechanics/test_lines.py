"""A line in any form is the same line: a unit normal and the distance from the origin."""

from fractions import Fraction

import pytest

from rbpsym.expr.infix import read_infix
from rbpsym.field.scalar import PI, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.mechanics.geometry import components
from rbpsym.mechanics.roots import _principal
from rbpsym.statement.model import Line

BETA = symbol("beta")


@pytest.mark.parametrize(
    ("parts", "wanted"),
    [
        (("3", "4", "10"), (lift(Fraction(3, 5)), lift(Fraction(4, 5)), lift(2))),
        (("0", "2", "d"), (lift(0), lift(1), symbol("d") / 2)),
        (("tan(beta)", "1", "0"), (sine(BETA), cosine(BETA), lift(0))),
    ],
)
def test_the_normal_is_a_unit_vector(parts, wanted):
    found = components(Line("", *(read_infix(part, ("beta", "d")) for part in parts)))
    assert all(not (a - b) for a, b in zip(found, wanted, strict=True))


@pytest.mark.parametrize(("given", "wanted"), [(1, 1), (-1, 1), (Fraction(3, 2), Fraction(-1, 2)), (2, 0), (-3, 1)])
def test_an_angle_is_brought_into_one_turn(given, wanted):
    assert not _principal(PI * given) - PI * wanted
