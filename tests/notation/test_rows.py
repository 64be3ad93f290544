"""What only forms the page of a display is no part of what it says: ends of rows, alignment, gaps, frames."""

from functools import partial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rbpsym.equality.poles import faults
from rbpsym.errors import RbpsymError
from rbpsym.notation.latex_reader import read_latex
from rbpsym.notation.symbol_table import symbol_table
from tests.notation.textbook import DIMENSION_OF, NAMES

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
