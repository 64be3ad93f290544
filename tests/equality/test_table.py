"""Every row of the table gets its verdict, and what is said of it holds by independent arithmetic."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest

from rbpsym.equality.enclosure import ends
from rbpsym.equality.verdict import Witness
from tests.equality.independent import DIGITS, at_witness, differ, evaluate, samples, satisfies
from tests.equality.table import Row, load

ROWS = load()


def test_the_table_is_large_and_has_no_row_twice():
    assert len(ROWS) >= 300
    assert len({(row.id, row.signs, row.ranges) for row in ROWS}) == len(ROWS)
    assert {row.verdict for row in ROWS} == {"PROVED", "REFUTED", "UNDECIDED"}


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.id)
def test_verdict(row: Row):
    verdict = row.decide()
    assert verdict.kind == row.verdict, f"{row.note}: {verdict}"
    if verdict.is_refuted:
        check_witness(row, verdict.witness)
    elif verdict.is_proved:
        assert verdict.how
    else:
        assert verdict.reason


@pytest.mark.parametrize("row", [row for row in ROWS if row.verdict == "PROVED"], ids=lambda row: row.id)
def test_what_is_proved_holds_at_random_points(row: Row):
    found = samples(row, 5)
    assert found, "no point satisfies the conditions: the row says nothing"
    assert not any(differ(row, values) for values in found)


def check_witness(row: Row, witness: Witness) -> None:
    """The conditions hold at the witness, the sides differ, and both values are those recorded."""
    values = at_witness(witness)
    assert set(values) >= set(row.names)
    assert satisfies(row, values)
    assert differ(row, values)
    for text, recorded in ((row.left, witness.left), (row.right, witness.right)):
        low, high = map(as_float, ends(recorded))
        margin = mpmath.mpf(10) ** -25 * (1 + abs(low))
        assert low - margin <= evaluate(text, values) <= high + margin


def as_float(number: Fraction) -> mpmath.mpf:
    with mpmath.workdps(DIGITS):
        return mpmath.mpf(number.numerator) / number.denominator
