"""Only what is used: each line of standard notes is a conclusion, or a later line of the page rests on it or refers to it."""

import pytest

from rbpsym.document.chapters import in_page_order
from rbpsym.document.needless import owed_by
from rbpsym.document.notes import shown_steps
from rbpsym.document.used import led_to
from rbpsym.expr import tree as t
from rbpsym.proof.forms import lettered
from rbpsym.proof.step import Step
from tests.library.derived import FOLLOWED, unsimulated

MEANS = {  # rules of steps that are no ends in themselves, by chapter
    "momentum": {"angular_momentum"},
    "energy": {"kinetic_energy", "potential", "identity", "balance", "solution"},
    "oscillations": {"linearization", "rest"},
}


def on_page(name: str) -> list[Step]:
    found = unsimulated(name)
    shown = shown_steps(found, "standard")
    return [step for step in found.steps if step.id in shown]


@pytest.mark.parametrize("name", FOLLOWED)
def test_what_is_shown_is_needed_by_a_later_line(name: str) -> None:
    steps, page = unsimulated(name).steps, on_page(name)
    for step in page:
        if step.rule in MEANS.get(step.chapter, ()) and not step.is_result:
            later = [other.id for other in page if other is not step and step.id in led_to(steps, other.reasons)]
            assert later, f"{step.id} is shown, and nothing on the page rests on it"


@pytest.mark.parametrize("name", FOLLOWED)
def test_no_box_says_what_does_not_change(name: str) -> None:
    found = unsimulated(name)
    coordinates = set(found.study.system.coordinates)
    is_moving = any(step.phrase == "torque.solved" for step in found.steps)
    for step in found.steps:
        if step.is_result and step.rule == "first_integral":
            right = t.renamed(step.statement.items[-1], lettered(found.steps))
            assert coordinates & t.names(right), step.id
        if step.is_result and step.phrase == "torque.solved_zero":
            assert not is_moving, step.id


@pytest.mark.parametrize("name", FOLLOWED)
def test_full_notes_leave_nothing_of_the_standard_out(name: str) -> None:
    found = unsimulated(name)
    assert shown_steps(found, "brief") <= shown_steps(found, "standard") <= shown_steps(found, "full")


@pytest.mark.parametrize("name", FOLLOWED)
def test_no_condition_is_said_twice_on_a_page(name: str) -> None:
    found = unsimulated(name)
    told = owed_by(in_page_order(found.steps), shown_steps(found, "standard"), found.study.assumptions)
    every = [node for nodes in told.values() for node in nodes]
    assert len(every) == len(set(every))


def test_what_a_page_owes_is_said_where_it_is_needed_first() -> None:
    found = unsimulated("falling-spool")
    told = owed_by(in_page_order(found.steps), shown_steps(found, "standard"), found.study.assumptions)
    first, *others = [id for id in (step.id for step in in_page_order(found.steps)) if id in told]
    assert not others, "h + y > 0 holds for all that follows"
    assert found.steps[0].id == first
