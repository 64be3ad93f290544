"""The hold-out of typed answers: every verdict as written down before, each refusal with a sentence and a caret, quickly."""

from __future__ import annotations

import re
from collections import Counter
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from rbpsym.teaching.grading.answer import grade_answer, grade_number
from rbpsym.teaching.grading.ground import GradingGround, bare_ground
from rbpsym.teaching.grading.judgement import Judgement, Status
from tests.teaching.typed_answers import Row, rows

ROWS = rows("holdout.txt")


@cache
def ground(symbols: tuple[tuple[str, str], ...]) -> GradingGround:
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


def test_none_is_right_that_should_not_be() -> None:
    for row in ROWS:
        assert judged(row).status is not Status.RIGHT or row.expected == "right", row


# --- numbers

LETTERS = {"value": "v", "unit": "u", "figures": "f"}


def numbers() -> dict[tuple[float, str, int], list[tuple[str, str]]]:
    """(value, unit, figures) -> the answers with what of them is right."""
    found: dict[tuple[float, str, int], list[tuple[str, str]]] = {}
    for line in (Path(__file__).parent / "holdout_numbers.txt").read_text(encoding="utf-8").splitlines():
        head = re.fullmatch(r"\[(\S+) (\S+) (\d)\]", line)
        if head:
            key = (float(head[1]), "" if head[2] == "1" else head[2], int(head[3]))
            found[key] = []
        elif line and not line.startswith("#"):
            found[key].append(tuple(line.split(" => ")))
    return found


HALF = Fraction(1, 2)


def is_as_expected(found: Judgement, expected: str) -> bool:
    right = "".join(LETTERS[name] if credit == 1 else "h" for name, credit in found.parts if credit in (1, HALF))
    outcomes = {
        "??": found.status is Status.INVALID, "0": found.status is Status.WRONG and not found.credit,
        "-": found.status in (Status.WRONG, Status.PARTLY) and "v" not in right,
    }  # fmt: skip
    return outcomes.get(expected, right == expected)


@pytest.mark.parametrize("key", numbers(), ids=str)
def test_numbers(key: tuple[float, str, int]) -> None:
    value, unit, figures = key
    for answer, expected in numbers()[key]:
        found = grade_number(answer, value, unit, figures=figures)
        assert is_as_expected(found, expected), (answer, expected, found)


def test_the_numbers_are_many() -> None:
    assert sum(map(len, numbers().values())) >= 280
