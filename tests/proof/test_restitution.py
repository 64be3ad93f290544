"""A coefficient of restitution is no more than 1, or energy would be gained: a page says so where nothing declared does."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rbpsym.derive import derive
from rbpsym.proof.rules import certify
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_text
from tests.library.derived import unsimulated

DECLARED = 'e = { dimension = "number", range = ["0", "1"] }'


@pytest.mark.parametrize(("declared", "left"), [("", 1), (DECLARED, 0)])
def test_its_range_is_a_condition_where_it_is_not_declared(declared, left):
    text = find_problem("ball-and-hinged-rod").read_text(encoding="utf-8")
    [row] = [line for line in text.splitlines() if line.startswith('e   = "number')]
    found = derive(load_text(text.replace(row, declared or row)), simulation=False)
    [step] = [step for step in found.all_steps if step.id.startswith("restitution.")]
    verdict = step.certificate.verdict
    assert verdict.is_proved and len(verdict.open_obligations) == left


@pytest.mark.parametrize("name", ["superball", "box-against-ridge", "ball-against-free-rod", "rod-dropped-on-rough-floor"])
def test_a_blow_follows_from_its_laws(name: str) -> None:
    """No step on a blow rests on what the letters of speeds and impulses turn out to be: they mean nothing by themselves."""
    [phase] = unsimulated(name).phases
    for step in phase.begins:
        told = {id for id in step.premises if id.startswith("def.") and not id.startswith("def.K")}
        assert not told or step.rule in ("kept_until", "end_state"), (step.id, told)
        if step.rule in ("jump", "impulse", "restitution"):
            assert any(id.startswith(("law.blow.", "law.parting.")) for id in step.premises), step.id
    wrong = replace(phase.begins[-2], premises=())
    assert not certify(phase.letters, wrong).verdict.is_proved
