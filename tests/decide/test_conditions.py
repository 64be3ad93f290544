"""Where a formula has a value: the condition that each part leaves, and what discharges it."""

import pytest

from rbpsym.decide.assumptions import NONE
from rbpsym.decide.domain import _is_plainly_positive, conditions, obligations
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Fn, Sym
from rbpsym.field.evaluate import BARE
from rbpsym.typeset.machine import to_machine
from tests.decide.rows import names_in, read_assumptions


def left(text: str, assuming: str = "") -> dict[str, bool]:
    """Each condition of a formula with whether it is discharged."""
    names = names_in(text)
    found = obligations(conditions(read_infix(text, names), BARE), read_assumptions(assuming, names))
    return {to_machine(duty.relation): duty.is_discharged for duty in found}


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("1/x", {"x != 0": False}),
        ("sqrt(x)", {"x >= 0": False}),
        ("sqrt(x**2)", {"x**2 >= 0": True}),
        ("sqrt(x**3)", {"x**3 >= 0": False}),
        ("sqrt(x**4 + y**2)", {"x**4 + y**2 >= 0": True}),
        ("1/(x**2 + 1)", {"x**2 + 1 != 0": True}),
        ("1/(x**2 + y)", {"x**2 + y != 0": False}),
        ("tan(x)", {"cos(x) != 0": False}),
        ("cot(x)", {"sin(x) != 0": False}),
        ("ln(x)", {"x > 0": False}),
        ("1/(2*x*(x - y)**2) + 1/(3*(x - y)*z)", {"x != 0": False, "x - y != 0": False, "z != 0": False}),
        ("x/(y/(2*z))", {"y != 0": False, "z != 0": False}),
        ("sqrt(2*(x - y))", {"x - y >= 0": False}),
        ("sqrt(2*x*y)", {"x*y >= 0": False}),
    ],
)
def test_what_a_formula_asks(text, wanted):
    assert left(text) == wanted


def test_declared_signs_discharge_it():
    assert set(left("1/x + sqrt(x) + ln(x)", "positive").values()) == {True}


@pytest.mark.parametrize("name", ["asin", "acos"])
def test_an_inverse_function_asks_for_its_domain(name):
    found = list(conditions(Fn(name, Sym("x")), BARE))
    assert len(found) >= 1 and all("x" in to_machine(duty.node) for duty in found)


def test_squares_are_told_as_the_reason():
    found = conditions(read_infix("sqrt(x**4 + y**2)", {"x", "y"}), BARE)
    assert [duty.why for duty in obligations(found, NONE)] == ["a sum of squares and of what is not negative"]


@pytest.mark.parametrize(
    ("text", "assuming", "is_plain"),
    [
        ("m + x**2", "positive m", True), ("x**2 + 1", "", True), ("sqrt(x) + m", "positive m", True),
        ("x**2 + y**2", "", False), ("m + x**2", "", False), ("x**2 - 1", "", False), ("m*x**2", "positive m", False),
        ("m + x**2", "nonnegative m", False), ("m + x", "positive m", False), ("x**2 + 0", "", False),
    ],
)  # fmt: skip
def test_a_sum_is_plainly_positive_where_one_term_is(text, assuming, is_plain):
    names = names_in(text)
    assert _is_plainly_positive(read_infix(text, names), read_assumptions(assuming, names)) is is_plain
