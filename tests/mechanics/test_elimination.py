"""Ranks and residues: what is said of a linear system is proved, never guessed."""

from rbpsym.algebra.calculus import root
from rbpsym.algebra.scalar import symbol
from rbpsym.algebra.trig import cosine, sine
from rbpsym.mechanics.elimination import has_full_rank, is_surely_nonzero_on, solve_linear

A, C, X, Y = map(symbol, "acxy")


def test_full_rank_of_plain_rows() -> None:
    assert has_full_rank([X * cosine(A) + Y * sine(A), Y * cosine(A) - X * sine(A)], "xy")
    assert not has_full_rank([X * cosine(A) + Y * sine(A), (X * cosine(A) + Y * sine(A)) * C], "xy")


def test_a_root_is_not_taken_for_zero() -> None:
    """√c x + y and c x + √c y are multiples of each other: no residue of √c may hide that."""
    rows = [root(C) * X + Y, C * X + root(C) * Y]
    assert not has_full_rank(rows, "xy")
    assert has_full_rank([root(C) * X + Y, X - Y], "xy")


def test_values_on_a_solution() -> None:
    rows = [X * cosine(A) + Y - C, X - Y * sine(A)]
    found = solve_linear(rows, "xy").values
    assert not any(is_surely_nonzero_on(row, found) for row in rows)
    assert is_surely_nonzero_on(rows[0] + 1, found)
    assert not is_surely_nonzero_on(root(C) * X, {"x": C})  # undecided counts as no
