"""What only forms the page of a display is no part of what it says: ends of rows, alignment, gaps, frames."""

from functools import partial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rbpsym.decide.domain import faults
from rbpsym.errors import RbpsymError
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import symbol_table
from tests.expr.textbook import DIMENSION_OF, NAMES

TABLE = symbol_table(NAMES - {"d"}, faults=partial(faults, dimensions=DIMENSION_OF))
TERMS = ("mg x", r"\frac12 k x^2", r"U\cos\theta", r"(m + M) g x")
BLANK = ("", " ", r" \\ ", r" \\ \\ ", r"& \\ &", r" \\ &\qquad ", r"\quad \\ ", r"\nonumber \\[2pt] & ")
EDGE = ("", r"\\ ", r"& ", r"\quad ", r"\quad & ", r"\quad\quad ")


@settings(max_examples=200)
@given(st.lists(st.sampled_from(TERMS), min_size=1, max_size=3), st.data())
def test_a_row_that_ends_with_a_sign_goes_on(terms, data):
    draw = lambda values: data.draw(st.sampled_from(values))  # noqa: E731
    signs = ["=", *(draw("+-") for _ in terms[1:])]
    plain = "U" + "".join(f" {sign} {term}" for sign, term in zip(signs, terms, strict=True))
    shown = "U" + "".join(f" {sign} {draw(BLANK)} {term}" for sign, term in zip(signs, terms, strict=True))
    assert read_latex(f"{draw(EDGE)} {shown} {draw(EDGE)}", TABLE) == read_latex(plain, TABLE)


FRAMED = "U = mg x"


@pytest.mark.parametrize("frame", [r"\boxed{%s}", r"\fbox{%s}", r" \boxed{\boxed{%s} } "])
def test_a_frame_says_nothing(frame):
    assert read_latex(frame % FRAMED, TABLE) == read_latex(FRAMED, TABLE)


def test_a_frame_that_is_not_closed_is_told():
    with pytest.raises(RbpsymError):
        read_latex(r"\boxed{U = mg x", TABLE)


@pytest.mark.parametrize("number", ["(1)", "(2.3)", "(4.5a)", "(*)"])
@pytest.mark.parametrize("display", [r"%s \quad {0}", r"%s, \qquad {0}", r"{0} \quad %s", r"& {0}\quad %s"])
def test_a_number_written_by_hand_says_nothing(number, display):
    assert read_latex(display.format(number) % FRAMED, TABLE) == read_latex(FRAMED, TABLE)


@pytest.mark.parametrize("display", [r"U = mg (1)", r"U = mg\,(1) + k x^2", r"U = mg\quad(1) + k x^2"])
def test_a_number_in_parentheses_that_may_be_a_factor_is_kept(display):
    try:
        found = read_latex(display, TABLE)
    except RbpsymError:
        return
    assert found != read_latex(r"U = mg", TABLE) and found != read_latex(r"U = mg + k x^2", TABLE)


@pytest.mark.parametrize("condition", [r"x > 0", r"0 \le x, \theta < \pi"])
def test_what_stands_in_parentheses_behind_a_gap_says_when_it_holds(condition):
    parts = condition.replace(",", r" \text{if}")
    assert read_latex(rf"{FRAMED} \quad ({condition})", TABLE) == read_latex(rf"{FRAMED} \text{{if}} {parts}", TABLE)


def test_a_remark_in_a_column_of_its_own_says_nothing():
    rows = r"U &= mg x & \text{(energy)} \\ k &= m & \text{(stiffness)}"
    assert read_latex(rows, TABLE) == read_latex(r"U &= mg x \\ k &= m", TABLE)
