"""Each way to write a quantity or a moment that docs/ask.md shows is understood in some problem."""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.ask.question import CLAUSES, read_question
from rbpsym.errors import RbpsymError
from rbpsym.quantity.phrases import EXAMPLES
from tests.ask.test_answers import asked

PROBLEMS = (
    "rod-pendulum", "sliding-ladder", "center-of-percussion", "ball-slipping-to-rolling", "disk-on-incline", "rod-with-damper",
    "torsion-pendulum", "double-compound-pendulum", "disk-with-spring",
)  # fmt: skip
CLAIMED = {"a constant", "unknown", "defined here"}  # what only claims can say


def is_answered(name: str, question: str) -> bool:
    try:
        return answered(asked(name), question).verdict.is_proved
    except RbpsymError:
        return False


@pytest.mark.parametrize("example", [example for example in EXAMPLES if example not in CLAIMED])
def test_each_quantity_is_answered_somewhere(example: str) -> None:
    for name in PROBLEMS:
        if any(is_answered(name, text) for text in asked(name).whole.filled([example])):
            return
    pytest.fail(f"“{example}” is answered in none of {PROBLEMS}")


@pytest.mark.parametrize(("kind", "example"), [(kind, example) for kind, _, example in CLAUSES])
def test_each_clause_is_read(kind: str, example: str) -> None:
    found = read_question(example)
    assert (found.of if kind == "of" else found.when.kind == kind) and found.quantity
