"""Every row of the table is decided as it should be, and an independent road agrees."""

from __future__ import annotations

import mpmath
import pytest

from rbpsym.decide.equal import equal
from rbpsym.decide.verdict import PROVED, REFUTED, UNDECIDED
from tests.decide.numeric import NoValue, at_witness, fulfils, number, some_points, typed
from tests.decide.rows import Row, table

ROWS = table()
by_row = pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row.left}={row.right}[{row.assuming}]"[:80])


def test_the_table_is_large() -> None:
    kinds = [row.verdict for row in ROWS]
    assert len(set(ROWS)) == len(ROWS) >= 300
    assert kinds.count(PROVED) >= 150
    assert kinds.count(REFUTED) >= 150


@by_row
def test_verdict(row: Row) -> None:
    verdict = equal(*row.sides, row.assumptions)
    assert verdict.kind is row.verdict, str(verdict)
    assert verdict.how or verdict.kind is UNDECIDED
    assert verdict.reason or verdict.kind is not UNDECIDED


@by_row
def test_verdict_is_symmetric(row: Row) -> None:
    assert equal(*reversed(row.sides), row.assumptions).kind is row.verdict


@pytest.mark.parametrize("row", [row for row in ROWS if row.verdict is REFUTED], ids=lambda row: row.left[:60])
def test_witness_checks(row: Row) -> None:
    """At the witness, computed by other means, the assumptions hold and the sides differ."""
    witness = equal(*row.sides, row.assumptions).witness
    anything = some_points(row.assuming, row.names, 1, seed=1)[0]  # for names on which nothing depends
    point = {**anything, **at_witness(witness)}
    assert fulfils(row.assuming, row.names, point), witness
    left, right = typed(row.left, point), typed(row.right, point)
    assert abs(left - right) > mpmath.mpf(10) ** -35, witness
    for told, found in ((witness.left, left), (witness.right, right)):
        low, high = (told, told) if not hasattr(told, "lower") else (told.lower, told.upper)
        assert mpmath.mpf(low.numerator) / low.denominator <= found + mpmath.mpf(10) ** -30
        assert mpmath.mpf(high.numerator) / high.denominator >= found - mpmath.mpf(10) ** -30


@pytest.mark.parametrize("row", [row for row in ROWS if row.verdict is PROVED], ids=lambda row: row.left[:60])
def test_proved_rows_hold_at_random_points(row: Row) -> None:
    points = some_points(row.assuming, row.names, 12, seed=len(row.left))
    assert points
    for point in points:
        try:
            a, b = typed(row.left, point), typed(row.right, point)
        except NoValue:
            continue
        assert mpmath.almosteq(a, b, rel_eps=mpmath.mpf(10) ** -30, abs_eps=mpmath.mpf(10) ** -30), (row, point)
        assert mpmath.almosteq(a, number(row.sides[0], point), rel_eps=mpmath.mpf(10) ** -40)
