"""Places where something vanishes, in closed form; bounds of parameters decide signs and sample numbers."""

import pytest

from rbpsym.decide.signs import sign
from rbpsym.expr.infix import read_infix
from rbpsym.field.calculus import substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.field.roots import without_even_roots
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.roots import common_zeros, factor_zeros, factors_in, zeros
from rbpsym.mechanics.study import Study
from rbpsym.statement import load_text

NAMES = ("a", "b", "c", "x", "theta")


def value(text):
    return scalar(read_infix(text, NAMES))


@pytest.mark.parametrize(
    ("text", "name", "count"),
    [
        ("a*x**2 + b*x + c", "x", 2),
        ("x**2 - a**2*b", "x", 2),
        ("a*cos(theta)**2 + b*cos(theta) + c", "theta", 4),
        ("a*sin(theta)**2 + b*cos(theta) + c", "theta", 4),
        ("a*cos(theta)**2 + b*sin(theta) + c", "theta", 4),
        ("a*cos(theta) + b*sin(theta)", "theta", 2),
    ],
)
def test_zeros_are_zeros(text, name, count):
    found = zeros(value(text), name)
    assert len(found) == count
    for place in found:
        assert is_zero(without_even_roots(substitute(value(text), {name: place})))


def test_what_has_no_closed_form_has_no_zeros():
    assert zeros(value("a*cos(theta)**2 + b*sin(theta)*cos(theta) + c*sin(theta)"), "theta") == []


def test_a_factor_is_solved_wholly_or_not_at_all():
    hidden = value("a*sin(2*theta) + b*cos(theta)*cos(2*theta) + c*sin(theta)*cos(theta)**2*sin(2*theta)")
    solved = {factor: bool(factor_zeros(factor, "theta")) for factor in factors_in(hidden, "theta")}
    assert sorted(solved.values()) == [False, True]
    assert len(common_zeros([hidden], ["theta"]).open_) == 1


BOUNDED = """
[parameters]
m = "mass"
R = "length > 2*r: outer"
r = "length: inner"
mu = { dimension = "number", range = ["0", "tan(beta)"] }
beta = "angle, acute"
g = "acceleration"
[coordinates.x]
dimension = "length"
[bodies.bob]
shape = "particle"
mass = "m"
center = ["x", "0"]
"""


@pytest.mark.parametrize("text", ["R - 2*r", "R**2 - 4*r**2", "tan(beta) - mu", "cos(beta)", "sin(beta)*cos(beta)"])
def test_bounds_decide_signs(text):
    study = Study(load_text(BOUNDED))
    names = [q.name for q in study.problem.parameters]
    assert sign(scalar(read_infix(text, names)), study.assumptions).kind == "positive"
    assert number(scalar(read_infix(text, names)), sample(study.problem)) > 0
