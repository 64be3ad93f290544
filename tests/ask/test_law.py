"""The questions that problems of the library ask themselves keep the law of answers; what no rule says is not proved."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import Refused, own_answers
from rbpsym.ask.concluded import concluded
from rbpsym.ask.finding import Finding, needed
from rbpsym.ask.parameters import finding
from rbpsym.ask.seen import scene
from rbpsym.decide.verdict import proved
from rbpsym.field.scalar import symbol
from rbpsym.mechanics.at_start import study_of
from rbpsym.statement.library import find_problem, problem_files
from rbpsym.statement.loader import load_problem
from tests.ask.law import one_value_a_letter
from tests.ask.test_unseen import HERE

pytestmark = pytest.mark.heavy

ASKING = [name for name in problem_files() if "question = " in problem_files()[name].read_text(encoding="utf-8")]


@pytest.mark.parametrize("name", ASKING)
def test_what_a_problem_asks_is_answered_by_law(name: str) -> None:
    assert not [one for one in own_answers(study_of(load_problem(find_problem(name)))) if isinstance(one, Refused)]


def test_what_no_rule_says_is_not_proved() -> None:
    world = scene(Asked(load_problem("rod-pendulum")))
    for found in (Finding(proved("so it seems"), values=(symbol("M"),)), Finding(proved("so it seems"), says="yes", holds=True)):
        assert not concluded(world, "M", found).verdict.is_proved


@pytest.mark.parametrize("how", ["for b << c", "with c = b"])
def test_each_component_is_stated_by_its_own_ground(how: str) -> None:
    text = f"force A on plate when swinging begins {how}"
    world, found = finding(Asked(load_problem(HERE / "plate-pins.toml")), text)
    assert concluded(world, text, found).verdict.is_proved
    assert not concluded(world, text, replace(found, values=found.values[::-1])).verdict.is_proved


@pytest.mark.parametrize("name", ASKING)
def test_an_answer_has_just_the_steps_that_it_needs(name: str) -> None:
    """Each step leads to the answer, or to one that asks for something of the motion before; each has an id of its own, and a
    premise that is no fact is a step before."""
    for found in own_answers(study_of(load_problem(find_problem(name)))):
        assert found.steps, found.question.text
        ids = [step.id for step in found.steps]
        assert len(ids) == len(set(ids)), found.question.text
        ends = [found.steps[-1].id, *(step.id for step in found.steps if step.obligations)]
        assert {step.id for step in needed([*found.steps], *ends)} == set(ids), found.question.text
        one_value_a_letter(found)
        for k, step in enumerate(found.steps):
            assert not {id for id in step.reasons if id in ids[k:]}, (found.question.text, step.id)
