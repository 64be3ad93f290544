"""No lemma is hollow: a step that prints a wrong value is refused, also where it says what its own letter is."""

from __future__ import annotations

import pytest

from rbpsym.expr import tree as t
from rbpsym.frozen import replace
from rbpsym.kernel.certify import written
from rbpsym.proof.step import Step
from tests.library.derived import unsimulated

pytestmark = pytest.mark.heavy

STAY_TRUE = {  # by its step what is as true of twice the last side, or of 1 for 0
    "equilibrium.1": "2 · 0 is 0", "equilibrium.2": "2π is a place of rest, too",
    "rest": "where the range has no place of rest, whatever is said of one is true",
}  # fmt: skip
PROBLEMS = ("sliding-ladder", "yo-yo", "ball-in-a-loop", "rod-with-damper", "elastic-pendulum", "bead-in-rolling-hoop")


def spoilt(step: Step) -> Step | None:
    """Twice the last side of each row (1 for 0); nothing for what states no equation."""
    rows = [*t.chains(step.statement)]
    if not rows or any(row.ops[-1] not in "=~" for row in rows):
        return None
    lasts = [t.ONE if row.items[-1] == t.ZERO else t.Mul((t.TWO, row.items[-1])) for row in rows]
    wrong = tuple(replace(row, items=(*row.items[:-1], last)) for row, last in zip(rows, lasts, strict=True))
    return replace(step, statement=wrong[0] if isinstance(step.statement, t.Chain) else replace(step.statement, rows=wrong))


@pytest.mark.parametrize("name", PROBLEMS)
def test_a_step_that_prints_a_wrong_value_has_no_lemma(name: str) -> None:
    whole, tried = unsimulated(name), 0
    for place, step in enumerate(whole.steps):
        if (wrong := spoilt(step)) is not None and step.id not in STAY_TRUE:
            own = replace(whole, steps=(*whole.steps[:place], wrong, *whole.steps[place + 1 :]))
            assert step.id in written(own, [step.id]).refused, step.id
            tried += 1
    assert tried > 20
