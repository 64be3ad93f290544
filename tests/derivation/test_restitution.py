"""A coefficient of restitution is no more than 1, or energy would be gained: a page says so where nothing declared does."""

from __future__ import annotations

import pytest

from rbpsym.derive import derive
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_text

DECLARED = 'e = { dimension = "number", range = ["0", "1"] }'


@pytest.mark.parametrize(("declared", "left"), [("", 1), (DECLARED, 0)])
def test_its_range_is_a_condition_where_it_is_not_declared(declared, left):
    text = find_problem("ball-and-hinged-rod").read_text(encoding="utf-8")
    [row] = [line for line in text.splitlines() if line.startswith('e   = "number')]
    found = derive(load_text(text.replace(row, declared or row)), simulation=False)
    [step] = [step for step in found.all_steps if step.id.startswith("restitution.")]
    verdict = step.certificate.verdict
    assert verdict.is_proved and len(verdict.open_obligations) == left
