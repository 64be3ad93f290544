"""How formulas are cut into lines: no relation sign stands alone, no line is wider than it need be."""

from __future__ import annotations

import pytest

from rbpsym.document import breaking
from rbpsym.document.model import Display, parts
from rbpsym.document.notes import notes
from rbpsym.expr.glyphs import DEFAULT
from rbpsym.expr.tree import ZERO, Add, Div, Fn, Mul, Node, Num, Sym, equation
from rbpsym.typeset import latex
from tests.library.derived import unsimulated

COS, SIN = Fn("cos", Sym("theta")), Fn("sin", Sym("theta"))


def sum_of(count: int) -> Node:
    """A sum of products, each a few em wide."""
    return Add(tuple(Mul((Div(Num(n), Num(4)), Sym("M"), Sym("g"), COS, SIN)) for n in range(1, count + 1)))


@pytest.mark.parametrize("column", [20.0, 30.0, 40.0, 41.0, 42.0])
@pytest.mark.parametrize("count", [3, 5, 6])
def test_a_short_end_goes_on_with_a_left_side_that_had_to_be_cut(count: int, column: float) -> None:
    found = breaking.lines(equation(sum_of(count), ZERO), DEFAULT, column)
    last = latex.render(found[-1].right).strip()
    assert last.endswith("= 0")
    assert not last.startswith("=") or len(found) == 1
    assert breaking.widest(found) <= column


def test_a_left_side_of_one_piece_keeps_its_end_below() -> None:
    """A single term that fills the line can't make room for "= 0"."""
    product = Mul(tuple(Sym(f"x_{n}") for n in range(30)))
    column = breaking.node_width(product) + 0.5
    found = breaking.lines(equation(product, ZERO), DEFAULT, column)
    assert [latex.render(line.right).strip().startswith("=") for line in found] == [False, True]


def test_one_over_a_wide_sum_is_no_factor_of_what_it_multiplies() -> None:
    """Written with a slash, “(a + b) sin θ / (…)” has no 1 before it."""
    wide = Add(tuple(Sym(f"x_{n}") for n in range(20, 29)))
    node = equation(Sym("y"), Mul((Div(Num(1), wide), Add((Sym("a"), Sym("b"))), SIN)))
    shown = "".join(latex.render(line.right) for line in breaking.lines(node, DEFAULT, 16.0))
    assert "= [(a + b)" in shown and "]/(" in shown and shown.count("(") == shown.count(")")


@pytest.mark.parametrize("column", [32.0, 36.0])
@pytest.mark.parametrize("name", ["half-ring-on-its-end", "man-on-turning-disc", "rod-over-corner"])
def test_rows_without_room_below_each_other_begin_at_the_margin(name: str, column: float) -> None:
    """A long left side beside a long right one in another row is no reason for a wider page."""
    document = notes(unsimulated(name))
    for shown in (part for part in parts(document) if isinstance(part, Display)):
        found = breaking.display_lines(shown, document.notation, column)
        assert breaking.widest(found) <= max(column, *(line.width for line in found))
