"""The general theory and the comparison of the two pendulums."""

import pytest

from rbpsym.derivation.theory import THEORIES
from rbpsym.mechanics.study import Study
from rbpsym.statement.course import CoursePart
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.verify.comparison import compare_problems


@pytest.mark.parametrize("name", sorted(THEORIES))
def test_every_step_of_the_theory_is_proved_twice(name):
    lesson = THEORIES[name]()
    assert [s.id for s in lesson.steps if not s.certificate.verdict.is_proved] == []
    assert all("by_particles" in s.certificate.checks for s in lesson.steps)
    assert {"angular_momentum", "torque", "energy", "fixed_torque", "work_energy", "ideal_pivot"} <= {
        s.id for s in lesson.steps
    }


@pytest.fixture(scope="module")
def comparison():
    studies = [Study(load_problem(problem_files()[name])) for name in ("rod-and-disk-fixed", "rod-and-disk-free")]
    return compare_problems(*studies, CoursePart("comparison", coordinate="theta", limit="R"))


def test_the_comparison_is_proved_with_its_reason(comparison):
    assert [s.id for s in comparison.steps if not s.certificate.verdict.is_proved] == []
    ids = {s.id for s in comparison.steps}
    assert {"order", "ratio", "spin.free.disk", "spin.bound.disk", "limit"} <= ids


def test_the_order_is_less(comparison):
    [order] = [s for s in comparison.steps if s.id == "order"]
    assert order.statement.ops == ("<",)
