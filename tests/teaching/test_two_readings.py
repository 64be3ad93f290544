"""Typed answers that can be read in two ways: the one with the right dimension is meant, else it is asked; decimals."""

from __future__ import annotations

from functools import cache

import pytest

from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.mechanics.study import Study
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
from rbpsym.teaching.grading.answer import grade_answer
from rbpsym.teaching.grading.formula import Sought, judge_formula
from rbpsym.teaching.grading.ground import GradingGround, ground_of


@cache
def rod() -> GradingGround:
    return ground_of(Study(load_problem(find_problem("rod-pendulum"))))


BY_DIMENSION = [  # typed, key: one reading has the right dimension, and is told
    ("√3g/ℓ", "sqrt(3*g/ell)"),
    ("√2gℓ", "sqrt(2*g*ell)"),
    ("2π√L/g", "2*pi*sqrt(ell/g)"),
    ("sqrt 2gl", "sqrt(2*g*ell)"),
    ("sqrt2gl", "sqrt(2*g*ell)"),
    ("√2gl", "sqrt(2*g*ell)"),
    ("√3g/2ℓ", "sqrt(3*g/(2*ell))"),
    ("sqrt3g/2l", "sqrt(3*g/(2*ell))"),
    ("2π√2ℓ/3g", "2*pi*sqrt(2*ell/(3*g))"),
    ("(2gl)^1/2", "sqrt(2*g*ell)"),
    (r"(2g\ell)^1/2", "sqrt(2*g*ell)"),
    ("1/2ω", "1/(2*theta_dot)"),
    (r"1/2\omega", "1/(2*theta_dot)"),
    ("3/2l", "3/(2*ell)"),
    ("3g/2l", "3*g/(2*ell)"),
    ("π/2ω", "pi/(2*theta_dot)"),
]


@pytest.mark.parametrize(("typed", "key"), BY_DIMENSION)
def test_the_reading_with_the_right_dimension_is_meant(typed: str, key: str) -> None:
    found = grade_answer(typed, key, rod())
    assert found.status.value == "right"
    assert [remark.key for remark in found.remarks] == ["read as"]


@pytest.mark.parametrize(
    ("typed", "key"),
    [
        ("1/2π√(g/l)", "1/(2*pi)*sqrt(g/ell)"),
        ("θ^1/3", "theta^(1/3)"),
        ("√2θ", "sqrt(2*theta)"),
        ("√2gl(1-cosθ)", "sqrt(2*g*ell*(1-cos(theta)))"),
        ("√2gl sinθ", "sqrt(2*g*ell*sin(theta))"),
        ("√3g/ℓ(cosθ-cosθ_0)", "sqrt(3*g/ell*(cos(theta)-cos(theta_0)))"),
        ("√θ/3", "sqrt(theta/3)"),
        ("1/2θ", "1/(2*theta)"),
    ],
)
def test_what_dimensions_do_not_tell_is_asked(typed: str, key: str) -> None:
    found = grade_answer(typed, key, rod())
    assert found.status.value == "invalid"
    assert "two ways" in found.remarks[0].slots["why"]


@pytest.mark.parametrize(
    ("typed", "key"),
    [
        ("1/2 M ω^2 l^2", "M*theta_dot**2*ell**2/2"),
        ("√2M", "M*sqrt(2)"),
        ("θ^2/3", "theta**2/3"),
        ("√3/2", "sqrt(3)/2"),
        ("√(2gl)M", "M*sqrt(2*g*ell)"),
    ],
)
def test_the_usual_reading_is_right_where_it_is_right(typed: str, key: str) -> None:
    found = grade_answer(typed, key, rod())
    assert (found.status.value, found.remarks) == ("right", ())


@pytest.mark.parametrize(("typed", "key"), [("1/2 M ω^2 l^2", "M*theta_dot**2*ell**2/3"), ("√2gl", "sqrt(3*g*ell)")])
def test_what_is_wrong_in_each_reading_is_wrong(typed: str, key: str) -> None:
    assert grade_answer(typed, key, rod()).status.value == "wrong"


@pytest.mark.parametrize(
    "typed",
    [
        "ω = √(3g/ℓ) ≈ 5.42 rad/s",
        "√(3g/ℓ) = 5.42 rad/s",
        "ω = √3g/ℓ ≈ 5.42 s^-1",
        r"$\omega=\sqrt{3g/\ell}\approx 5.42\,\mathrm{rad/s}$",
        "√(3g/ℓ) ≈ 5.42",
    ],
)
def test_a_number_behind_a_formula_is_not_judged_for_it(typed: str) -> None:
    found = grade_answer(typed, "sqrt(3*g/ell)", rod())
    assert found.status.value == "right"
    assert "number beside" not in [remark.key for remark in found.remarks]


@pytest.mark.parametrize(("typed", "key"), [("√(3g/ℓ) ≈ 5.42 m", "sqrt(3*g/ell)"), ("π/4 ≈ 0.9", "pi/4")])
def test_a_number_that_does_not_agree_is_told(typed: str, key: str) -> None:
    assert [remark.key for remark in grade_answer(typed, key, rod()).remarks] == ["number beside"]


@pytest.mark.parametrize("typed", ["ω = √(g/ℓ) ≈ 5.42 rad/s", "ω = 5.42 rad/s", "Mg ≈ 5.42 N"])
def test_a_right_number_makes_no_formula_right(typed: str) -> None:
    assert grade_answer(typed, "sqrt(3*g/ell)", rod(), target="theta_dot").status.value != "right"


@pytest.mark.parametrize(
    ("typed", "key"),
    [
        ("0.333Mℓ²", "M*ell**2/3"),
        ("3.14ℓ²", "pi*ell**2"),
        ("0.33Mℓ²", "M*ell**2/3"),
        ("arcsin(0.667 sin θ)", "asin(2/3*sin(theta))"),
    ],
)
def test_a_rounded_decimal_gets_a_sentence_and_a_teacher(typed: str, key: str) -> None:
    found = grade_answer(typed, key, rod())
    assert [remark.key for remark in found.remarks] == ["rounded"]
    assert found.is_for_teacher
    assert not found.credit


def test_other_decimals_are_exact_or_wrong() -> None:
    assert grade_answer("0.5Mℓ²", "M*ell**2/2", rod()).status.value == "right"
    assert [remark.key for remark in grade_answer("0.35Mℓ²", "M*ell**2/3", rod()).remarks] == ["factor"]


# --- integrals, in a blank that holds one


@cache
def ladder() -> Sought:
    ground = ground_of(Study(load_problem(find_problem("sliding-ladder"))))
    integrand, low, high = (read_infix(text, ground.book.names) for text in ("ell*N_f*cos(theta)", "theta_0", "theta"))
    return Sought(t.Integral(integrand, "theta", low, high), ground)


@pytest.mark.parametrize(
    "typed",
    [
        "∫_{θ0}^{θ} ℓ N_f cosθ dθ",
        "l∫_θ0^θ N_f cos θ dθ",
        "-∫_θ^θ0 l N_f cos θ dθ",
        "Integral(ell*N_f*cos(theta), (theta, theta_0, theta))",
        "integrate(l*N_f*cos(theta), theta, theta_0, theta)",
        "int(N_f*l*cos(theta), theta=theta_0..theta)",
        "Integrate[l N_f Cos[θ],{θ,θ0,θ}]",
        r"\int_{\theta_0}^{\theta} \ell N_f\cos\theta\,d\theta",
        r"\int_{\theta_0}^{\theta} d\theta\, \ell N_f\cos\theta",
        "M g l (sin θ - sin θ0 - 3 sin θ0 (sin²θ - sin²θ0) + 3 (sin³θ - sin³θ0))/4",  # carried out
    ],
)
def test_an_integral_is_right_typed_or_carried_out(typed: str) -> None:
    assert judge_formula(typed, ladder()).status.value == "right"


@pytest.mark.parametrize(
    "typed",
    [
        "∫_θ0^θ l N_f sin θ dθ",
        "∫_0^θ l N_f cos θ dθ",
        "2∫_θ0^θ l N_f cos θ dθ",
        "ℓ N_f (sin θ - sin θ0)",  # the force is no constant
        "M g l (sin θ - sin θ0 - 3 sin θ0 (sin²θ - sin²θ0) + 2 (sin³θ - sin³θ0))/4",
    ],
)
def test_another_integral_is_wrong(typed: str) -> None:
    assert judge_formula(typed, ladder()).status.value == "wrong"


@pytest.mark.parametrize("typed", ["∫ l N_f cos θ dθ", "Integral(l*N_f, q, 0, 1)", "Integral(l*N_f)"])
def test_an_integral_without_its_parts_gets_a_sentence(typed: str) -> None:
    assert "Integral(f, theta, a, b)" in judge_formula(typed, ladder()).remarks[0].slots["why"]


# --- powers with a variable exponent


@pytest.mark.parametrize(
    ("typed", "key", "positive", "real"),
    [
        ("(a^b)^c", "a^(b*c)", "right", "undecided"),
        ("(a^2)^b", "a^(2*b)", "right", "undecided"),
        ("2*a^b", "a^b*2", "right", "right"),
        ("2^(a+b)", "2^a*2^b", "right", "right"),
    ],
)
def test_powers_of_what_may_be_negative_are_not_called_equal(typed: str, key: str, positive: str, real: str) -> None:
    for sign, wanted in (("positive", positive), ("real", real)):
        assert grade_answer(typed, key, dict.fromkeys("abc", sign)).status.value == wanted
