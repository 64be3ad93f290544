"""What follows from equations: nothing is divided by what is zero in disguise."""

import pytest

from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.proof.entailment import SourcedRow, known_by, used_by_numbers

NAMES = ("p", "x", "x_dot", "N", "g", "F", "m", "a")


def row(text: str) -> SourcedRow:
    return SourcedRow(scalar(read_infix(text, NAMES)), frozenset({text}))


def rank(name: str) -> int:
    return int(name == "N")


def test_roots_that_are_equal_are_no_divisor() -> None:
    """p √(1 + x²/p²) = √(p² + x²) for p > 0: of such a difference nothing is concluded."""
    zero = "(p*sqrt(1 + x**2/p**2) - sqrt(p**2 + x**2))"
    for text, wanted in ((f"{zero}*x_dot**2 + p*g", {"x_dot"}), (f"{zero}*N + p*g", {"N"})):
        found = known_by([row(text)], wanted, rank, {"x_dot"})
        assert not found.squares and not found.pivots


def test_other_roots_are() -> None:
    found = known_by([row("(sqrt(1 + x**2) + sqrt(p**2 + x**2))*N - g")], {"N"}, rank, {"x_dot"})
    assert [pivot.name for pivot in found.pivots] == ["N"]


def test_a_root_that_has_no_value_at_some_numbers_is_looked_at_at_others() -> None:
    for slope in ("sqrt(p**2 - g**2)", "(sqrt(2) - 1)"):
        found = known_by([row(f"{slope}*N - g")], {"N"}, rank, set())
        assert [pivot.name for pivot in found.pivots] == ["N"]


@pytest.mark.parametrize(
    ("goal", "told"),
    [
        ("F - m*g/p", {"F - m*a", "p*a - g"}),
        ("F - 2*m*a", None),
        ("F - m*N", None),
        ("F - m*a + x_dot**2 - g*x", {"F - m*a", "x_dot**2 - g*x"}),
        ("F - m*a + x_dot*x", None),
        ("a*x_dot**2 - a*g*x", {"x_dot**2 - g*x"}),
        ("g - g", set()),
    ],
)
def test_by_numbers_it_is_seen_which_equations_say_it(goal, told) -> None:
    rows = [row(text) for text in ("F - m*a", "p*a - g", "x_dot**2 - g*x", "N - g")]
    found = used_by_numbers(rows, row(goal).value, {"F", "a", "N", "x_dot"}, {"x_dot"}, {})
    assert found is None if told is None else found >= told
