"""Statics is told one unknown force at a time, torques about the points where most unknown forces meet."""

import pytest

from rbpsym.chapters.methods.statics import one_by_one
from rbpsym.field import names_in
from tests.library.derived import unsimulated

STILL = ("ladder-in-equilibrium", "step-ladder-with-cord", "wheel-over-kerb")


@pytest.mark.parametrize("name", STILL)
def test_each_balance_brings_one_unknown_force(name: str) -> None:
    study, known = unsimulated(name).study, set()
    for balance in one_by_one(study):
        assert len(balance.unknowns - known) == 1
        known |= balance.unknowns
        assert not balance.left
    assert known == {*study.system.unknowns}


def test_the_ladder_is_taken_about_its_foot() -> None:
    found = unsimulated("ladder-in-equilibrium")
    torque = next(step for step in found.steps if step.phrase == "statics.point")
    assert torque.slots["point"] == ["ladder.start"]
    assert {force.name for force in torque.slots["silent"].slots["forces"]} == {"N_f", "f"}
    assert names_in(found.letters.value(torque.statement.items[0])) & {*found.study.system.unknowns} == {"N_w"}
    assert all(step.certificate.verdict.is_proved for step in found.steps)


def test_what_moves_has_no_statics() -> None:
    assert one_by_one(unsimulated("sliding-ladder").study) == []


def test_the_tension_of_a_step_ladder_is_told_about_its_hinge() -> None:
    """Two lines: the whole gives the force of the floor, one half about the hinge, where two unknown forces meet, the tension."""
    found = one_by_one(unsimulated("step-ladder-with-cord").study)
    [told] = [balance for balance in found[:2] if "T" in balance.unknowns]
    assert told.label.endswith(".end") and len(told.bodies) == 1 and not told.unknowns & {"F_x", "F_y"}
