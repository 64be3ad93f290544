"""Of a body that a slanting contact holds, each equation of Newton holds the forces of one direction alone."""

from __future__ import annotations

import pytest

from rbpsym.expr import tree as t
from tests.library.derived import derived


@pytest.mark.parametrize("name", ["ring-on-incline", "cylinder-off-cylinder"])
def test_the_normal_force_and_the_friction_stand_in_equations_of_their_own(name: str) -> None:
    derivation = derived(name)
    [step] = [step for step in derivation.steps if step.phrase == "newton_euler.along"]
    unknown = set(derivation.study.system.unknowns)
    rows = [t.names(row) & unknown for row in t.rows(step.statement)]
    assert len(rows) == 3 and all(len(row) == 1 for row in rows) and rows[0] != rows[1]


def test_along_a_curve_the_force_of_the_guide_drops_out():
    """One balance with the tangent, without a condition, in place of two components that hold the force."""
    derivation = derived("bead-on-parabola")
    [step] = [step for step in derivation.chapter("motion") if step.rule == "balance"]
    assert step.phrase == "torque.push.path" and "N" not in t.names(step.statement)
    assert step.certificate.verdict.is_proved and all(duty.is_discharged for duty in step.certificate.verdict.obligations)
