"""The impulse of a force has a letter that is nobody's: neither its own name with a hat, if that is taken, nor another's."""

from __future__ import annotations

import pytest

from rbpsym.derive import derive
from rbpsym.expr import tree as t
from tests.letters.renaming import Names, original, renamed, same_names
from tests.library.derived import NAMES

STRUCK = ("rod-caught-at-end", "cylinder-against-step")


@pytest.mark.parametrize("name", STRUCK)
def test_a_quantity_that_is_called_like_an_impulse_stays_itself(name):
    assert name in NAMES
    problem, own = original(name), same_names(name)
    forces = [e.name for e in problem.phases[-1].problem.constraints]
    hatted = [f"{force}_hat" for force in forces] + [f"{force}_hat_x" for force in forces]
    taken = dict(zip([q.name for q in problem.parameters if q.name not in problem.implicit], hatted, strict=False))
    found = derive(renamed(name, Names({**own.symbols, **taken}, own.things)), simulation=False)
    steps = [step for phase in found.phases for step in phase.begins]
    assert steps and all(step.certificate.verdict.is_proved for step in found.all_steps)
    named = {
        row.items[0].name
        for step in steps
        for row in _rows(step.statement)
        if isinstance(row.items[0], t.Sym) and row.ops[0] == "="
    }
    assert not named & set(taken.values())


def _rows(statement):
    return statement.rows if isinstance(statement, t.Relations) else (statement,)
