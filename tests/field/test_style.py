"""What moves and what stays in a formula, and where factors are looked for."""

from fractions import Fraction

import pytest

from rbpsym.decide.points import Outside, Point
from rbpsym.expr import tree as t
from rbpsym.field.calculus import root
from rbpsym.field.scalar import generator_of, lift, symbol
from rbpsym.field.trig import cosine
from rbpsym.present.bars import roots_last
from rbpsym.present.grouping import FEW, MOST_FACTORED, is_worth_factoring
from rbpsym.present.style import Style, moves

M, X = symbol("m"), symbol("x")
STYLE = Style(moving=frozenset({"x"}))


@pytest.mark.parametrize(
    ("value", "varies"),
    [
        (M, False), (X, True), (symbol("m_dot"), True), (cosine(X), True), (root(1 + X), True), (root(1 + M), False),
        (generator_of("exp", M), True), (generator_of("atan", X), True),
    ],
)  # fmt: skip
def test_what_moves(value, varies):
    [index] = value.atoms()
    assert moves(index, STYLE) is varies


def of_length(value, count):
    return sum((value ** (k + 1) for k in range(count)), lift(0)).num


@pytest.mark.parametrize(("value", "most"), [(M, FEW), (X, MOST_FACTORED)])
def test_factors_are_looked_for_in_short_sums_longer_ones_of_what_moves(value, most):
    found = {count: is_worth_factoring(of_length(value, count), STYLE) for count in (1, 2, most, most + 1)}
    assert found == {1: False, 2: True, most: True, most + 1: False}
    assert not is_worth_factoring((value**-1 + 1).num, STYLE)


def test_a_sum_stands_before_the_root():
    sum_, root_ = t.Add((t.Sym("R"), t.Sym("h"))), t.Sqrt(t.Sym("g"))
    assert roots_last([t.Sym("M"), root_, sum_]) == [t.Sym("M"), sum_, root_]
    assert roots_last([root_, t.Pow(sum_, t.TWO)]) == [t.Pow(sum_, t.TWO), root_]
    assert roots_last([root_, t.Sym("M")]) == [root_, t.Sym("M")]


def test_the_sign_of_a_number():
    value = generator_of("sign", X - 2)
    assert [Point({"x": Fraction(k)}).value(value) for k in (1, 2, 5)] == [-1, 0, 1]
    with pytest.raises(Outside):
        Point({"x": Fraction(2)}).value(generator_of("sign", cosine(lift(1)) ** 2 + generator_of("sin", lift(1).num) ** 2 - 1))
