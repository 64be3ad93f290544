"""Residues: what is said of a linear system is proved, never guessed."""

from rbpsym.field.calculus import root
from rbpsym.field.scalar import symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.mechanics.elimination import is_surely_nonzero_on, solve_linear

A, C, X, Y = map(symbol, "acxy")


def test_values_on_a_solution() -> None:
    rows = [X * cosine(A) + Y - C, X - Y * sine(A)]
    found = solve_linear(rows, "xy").values
    assert not any(is_surely_nonzero_on(row, found) for row in rows)
    assert is_surely_nonzero_on(rows[0] + 1, found)
    assert not is_surely_nonzero_on(root(C) * X, {"x": C})  # undecided counts as no
