"""The general theory and the comparison of the two pendulums."""

import pytest

from rbpsym.chapters.theory import THEORIES, TheoryWriter
from rbpsym.chapters.theory_works import potential_energy
from rbpsym.claims.comparison import compare_problems
from rbpsym.expr import tree as t
from rbpsym.expr.latex.reader import read_latex
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import STANDARD
from rbpsym.statement.course import CoursePart
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.typeset.latex import to_latex


@pytest.mark.parametrize("name", sorted(THEORIES))
def test_every_step_of_the_theory_is_proved_twice(name):
    lesson = THEORIES[name]()
    assert [s.id for s in lesson.steps if not s.certificate.verdict.is_proved] == []
    assert all("by_particles" in s.certificate.checks for s in lesson.steps)
    assert {"angular_momentum", "torque", "energy", "fixed_torque", "work_energy", "ideal_pivot"} <= {
        s.id for s in lesson.steps
    }


BOXED = {  # the theorems; what leads to them and what follows from them at once has no box
    "turning", "angular_momentum", "torque", "euler", "energy", "steiner", "fixed_torque", "translational_work",
    "rotational_work", "work_energy", "fixed_axis_work", "works_and_potential", "ideal_pivot",
}  # fmt: skip


@pytest.mark.parametrize("name", sorted(THEORIES))
def test_the_theorems_are_results(name):
    steps = THEORIES[name]().steps
    assert {s.id for s in steps if s.is_result} == BOXED
    assert all(s.level == STANDARD and s.cites == () for s in steps)


def test_only_about_a_fixed_point_the_centre_moves_on_a_circle():
    writer = TheoryWriter()
    statement = t.equation(t.Vec("V_cm"), t.Cross(t.Vec("omega"), t.Vec("R_cm")))
    writer.add("tried", statement)
    writer.add("tried", statement, fixed=True)
    assert [step.certificate.verdict.is_proved for step in writer.steps] == [False, True]


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


def test_potential_energy_with_the_wrong_sign_is_refuted():
    writer = TheoryWriter()
    potential_energy(writer)
    right = t.Add((t.Sym("cal_W_nc"), t.Neg(t.Delta(t.Sym("E_p")))))
    wrong = t.Add((t.Sym("cal_W_nc"), t.Delta(t.Sym("E_p"))))
    for side, proved in ((right, True), (wrong, False)):
        writer.add("tried", t.equation(t.Add((t.Sym("cal_W_T"), t.Sym("cal_W_theta"))), side), "theory_rates")
        assert writer.steps[-1].certificate.verdict.is_proved is proved


def test_the_square_of_a_vector_is_drawn_without_its_arrow_and_read_as_the_square():
    squared = t.Pow(t.Vec("V_cm"), t.TWO)
    assert to_latex(squared) == r"V_{\mathrm{cm}}^2"
    context = TheoryWriter().context
    assert context.value(read_latex(to_latex(squared), ["V_cm"])) == context.value(squared)


BOTH = t.Add((t.Sym("cal_W_T"), t.Sym("cal_W_theta")))
EACH = t.Sum(t.PathIntegral(t.Vec("F_ext_i"), t.Vec("r_i")))
SPREAD = t.BodyIntegral(t.Cross(t.Vec("r_prime"), t.Deriv(t.Vec("F_ext"), "m")))
ORBITAL = t.Cross(t.Vec("R_cm"), t.Vec("F_net"))
ABOUT_O = t.Integral(t.Dot(t.Vec("tau_net"), t.Unit("z")), "varphi", t.Sym("varphi_A"), t.Sym("varphi_B"))


def _turning(moment: str) -> t.Node:
    return t.Delta(t.Group(t.mul(t.HALF, t.Sym(moment), t.Pow(t.Vec("omega"), t.TWO))))


@pytest.mark.parametrize(
    ("statement", "rule", "fixed"),
    [
        (t.equation(EACH, t.Sym("cal_W_T")), "theory_rates", False),
        (t.equation(SPREAD, ORBITAL), "theory_identity", False),
        (t.equation(SPREAD, t.Add((t.Vec("tau_cm"), t.Neg(ORBITAL)))), "theory_identity", False),
        (t.equation(ABOUT_O, _turning("I_cm")), "theory_rates", True),
        (t.equation(ABOUT_O, _turning("I_O")), "theory_rates", False),
        (t.equation(t.Add((t.Sym("cal_W_T_nc"), t.Sym("cal_W_theta_nc"))), t.ZERO), "theory_rates", False),
    ],
)
def test_what_is_only_half_of_a_theorem_is_refuted(statement, rule, fixed):
    writer = TheoryWriter()
    potential_energy(writer)
    writer.add("tried", statement, rule, fixed=fixed)
    assert not writer.steps[-1].certificate.verdict.is_proved


def test_the_sum_over_the_forces_is_both_works():
    writer = TheoryWriter()
    writer.add("tried", t.equation(EACH, BOTH), "theory_rates")
    assert writer.steps[-1].certificate.verdict.is_proved


def test_an_integral_over_what_is_spread_is_written_with_its_own_differential_and_read_back():
    assert to_latex(SPREAD) == r"\int_{\Omega} \vec{r}' \times d\vec{F}_{\mathrm{ext}}"
    assert read_latex(to_latex(SPREAD), ["r_prime", "F_ext"]) == SPREAD
