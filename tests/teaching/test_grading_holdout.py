"""The hold-out of typed answers: every verdict as written down before, each refusal with a sentence and a caret, quickly."""

from __future__ import annotations

import statistics
from collections import Counter
from functools import cache
from time import process_time

import pytest

from rbpsym.teaching.grading.answer import grade_answer
from rbpsym.teaching.grading.ground import Ground, bare_ground
from rbpsym.teaching.grading.judgement import Judgement, Status
from tests.teaching.typed_answers import Row, rows

ROWS = rows("holdout.txt")


@cache
def ground(symbols: tuple[tuple[str, str], ...]) -> Ground:
    return bare_ground(dict(symbols))


def judged(row: Row) -> Judgement:
    return grade_answer(row.answer, row.key, ground(row.symbols))


@pytest.mark.parametrize("key", list(dict.fromkeys(row.key for row in ROWS)))
def test_verdicts(key: str) -> None:
    found = {row.answer: judged(row).status.value for row in ROWS if row.key == key}
    assert found == {row.answer: row.expected for row in ROWS if row.key == key}


def test_it_is_large_and_decided() -> None:
    counted = Counter(row.expected for row in ROWS)
    assert len(set(ROWS)) == len(ROWS) >= 1100
    assert counted["undecided"] <= len(ROWS) / 100
    assert min(counted["right"], counted["wrong"]) >= 400


def test_refusals_have_a_sentence_and_a_caret() -> None:
    for row in (row for row in ROWS if row.expected == "invalid"):
        (remark,) = judged(row).remarks
        assert remark.slots["why"].endswith((".", "?")) and len(remark.slots["why"]) > 20, row
        line, caret = remark.slots["shown"].split("\n")
        assert caret.strip("^ ") == "" and "^" in caret and len(caret) <= len(line) + 1, row


def test_time() -> None:
    spent = []
    for row in ROWS:
        begin = process_time()
        found = judged(row)
        spent.append(process_time() - begin)
        assert found.status is not Status.RIGHT or row.expected == "right", row
    assert statistics.median(spent) <= 0.003
    assert statistics.quantiles(spent, n=100)[-1] <= 0.1
