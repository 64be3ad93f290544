"""A body that stands on two points: one friction, whose limit rests on both normal forces."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.errors import StatementError
from rbpsym.mechanics.study import Study
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.typeset.machine import to_machine

CRATE = problem_files()["crate-on-truck"].read_text(encoding="utf-8")
WRONG = {
    "which does not exist": ('beside   = "N_f"', 'beside   = "N_g"'),
    "no smooth contact of the same body": ('type  = "contact"', 'type  = "guide"'),
    "no smooth contact": ('line  = "y = c/2"', 'line  = "y = c/2"\ncoefficient = "mu"'),
    "with the same surface": ('line  = "y = c/2"', 'line  = "y = c/3"'),
}


@pytest.mark.parametrize("says", WRONG)
def test_what_cannot_stand_beside_it_is_told(says: str) -> None:
    old, new = WRONG[says]
    assert old in CRATE
    with pytest.raises(StatementError, match=says):
        load_text(CRATE.replace(old, new))


def test_the_friction_that_is_needed_rests_on_both_normal_forces() -> None:
    [need] = Study(load_problem(problem_files()["crate-on-truck"])).friction_needs
    assert need.normals == ("N_r", "N_f") and str(need.ratio) == str(need.needed)
    [found] = ask(load_text(CRATE), "friction coefficient needed at N_r")
    assert found.text == "A/g" and found.verdict.is_proved


def test_with_one_normal_force_alone_it_would_slip_elsewhere() -> None:
    """At most μ N_r: another limit than that of both, so that the one asked for is not that of one contact."""
    alone = CRATE.replace('beside   = "N_f"\n', "")
    both, one = (ask(load_text(text), "largest A for which it does not slip")[0] for text in (CRATE, alone))
    assert to_machine(both.nodes[0]) == "mu*g" and to_machine(one.nodes[0]) != "mu*g"
