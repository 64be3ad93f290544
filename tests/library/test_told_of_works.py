"""What is said of works and bounds holds of the very system."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.expr import tree as t
from tests.library.derived import NAMES, problem, unsimulated


@pytest.mark.parametrize("name", NAMES)
def test_works_that_are_told_to_cancel_are_those_of_bodies_on_which_work_is_done(name):
    """A pin at the centre of a disk does no work on it, whatever it does to the other body."""
    found = unsimulated(name)
    for part in (found, *(phase.derivation for phase in found.phases)):
        told = [step for step in part.steps if step.phrase.startswith("work.cancels.")]
        works = part.study.works if told else ()
        for step in told:
            force = step.id.removeprefix("workless.")
            worked = {one.on for one in works if one.force == force and (one.translational.parts or one.rotational.parts)}
            assert {body.name for body in step.slots["bodies"]} <= worked, step.id


@pytest.mark.parametrize("name", NAMES)
def test_a_work_is_introduced_by_its_path_or_is_a_fact(name):
    """The step that says what a work of both kinds comes to was taken for its definition, and said nothing."""
    found = unsimulated(name)
    for part in (found, *(phase.derivation for phase in found.phases)):
        by = {step.id: {str(row.items[0].name) for row in t.chains(step.statement) if isinstance(row.items[1], t.PathIntegral)}
              for step in part.steps}  # fmt: skip
        for letter, (id, _) in part.letters.introduced.items():
            assert letter not in part.letters.works or id == f"def.{letter}" or letter in by.get(id, ()), (letter, id)


BOUNDS = (
    ("smallest P for which it tips", "divides"),
    ("P for which A = m*g", "vanishes_for"),
    ("largest P for which it does not slip", "holds_for"),
)


@pytest.mark.parametrize(("question", "phrase"), BOUNDS)
def test_a_bound_of_the_opposite_is_not_said_to_hold_so_far(question, phrase):
    [found] = ask(problem("box-pushed-at-top"), question)
    assert found.steps[-1].phrase == f"ask.found.{phrase}"
