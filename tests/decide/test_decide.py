"""Verdicts: obligations, witnesses, vectors, comparisons, and what must not be proved."""

from __future__ import annotations

import subprocess
import sys
from fractions import Fraction

import pytest

from rbpsym.decide.assumptions import Assumptions, positive
from rbpsym.decide.domain import Condition
from rbpsym.decide.equal import compare, equal, refuted_only_where
from rbpsym.decide.verdict import PROVED, REFUTED, UNDECIDED, all_of, proved, undecided
from rbpsym.errors import ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import Meanings
from rbpsym.field.scalar import PI, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.field.vector import EX, Space
from tests.decide.rows import names_in, read_assumptions

X, THETA = t.Sym("x"), t.Sym("theta")


def decide(left: str, right: str, assuming: str = ""):
    """The verdict on two typed formulas."""
    names = names_in(f"{left} {right}")
    return equal(read_infix(left, names), read_infix(right, names), read_assumptions(assuming, names))


def test_division_leaves_an_obligation() -> None:
    verdict = decide("x/x", "1")
    assert verdict.is_proved
    assert [duty.relation for duty in verdict.open_obligations] == [t.relation(X, "!=", t.ZERO)]


def test_an_obligation_is_discharged() -> None:
    verdict = decide("x/x", "1", "positive")
    assert verdict.obligations and not verdict.open_obligations


@pytest.mark.parametrize(
    ("left", "assuming", "open_ones"),
    [
        ("1/cos(theta)", "0 < theta < pi/2", 0),
        ("1/cos(theta)", "0 < theta < pi", 1),
        ("tan(theta)", "", 1),
        ("sqrt(x)", "", 1),
        ("sqrt(x**2 + 1)", "", 0),
        ("sqrt(1 - cos(theta))", "", 0),
        ("ln(x)", "nonnegative x", 1),
        ("asin(x)", "", 1),
        ("asin(x)", "-1 < x < 1", 0),
        ("x**(-2)", "nonzero x", 0),
        ("x/(x**2 - 2*x + 2)", "", 0),
        ("1/2", "", 0),
        ("x/(m + M)", "positive m M", 0),
        ("x/(m - M)", "positive m M", 1),
    ],
)
def test_obligations_of_a_formula(left: str, assuming: str, open_ones: int) -> None:
    assert len(decide(left, left, assuming).open_obligations) == open_ones


def test_witness_is_small_and_readable() -> None:
    verdict = decide("sin(2*theta)", "sin(theta)")
    assert isinstance(verdict.witness.left, Fraction) and isinstance(verdict.witness.right, Fraction)
    assert str(verdict) == "REFUTED: at cos(theta) = 4/5, sin(theta) = 3/5: left = 24/25, right = 3/5"


def test_half_angles_in_a_witness() -> None:
    assert "cos(theta/2)" in str(decide("sin(theta/2)", "sin(theta)/2"))


@pytest.mark.parametrize(
    ("left", "right", "assuming"),
    [
        # true wherever a generic point lies, false at an isolated point of the domain
        ("sqrt(x**2*(x - 1)) + sqrt((x - 1)**2)", "sqrt(x**2*(x - 1)) + x - 1", ""),
        ("sqrt(-x**2) + sqrt((x - 1)**2)", "x - 1 + sqrt(-x**2)", ""),
        ("sqrt(x) + sqrt(-x*y) + sqrt(y**2)", "sqrt(x) + sqrt(-x*y) - y", ""),
        ("sqrt(x) + sqrt(x*y) + abs(y)", "sqrt(x) + sqrt(x*y) + y", ""),
        ("sqrt(x*y) + abs(y)", "sqrt(x*y) + y", "nonnegative x"),
        ("sqrt(-x**2 - y**2) + abs(x - 1)", "sqrt(-x**2 - y**2) + x - 1", ""),
        # nothing to prove: no point of the domain
        ("ln(-x**2)", "ln(-x**2) + 1", ""),
        ("sqrt(-1)", "sqrt(-1)*2", ""),
    ],
)
def test_isolated_points_are_not_forgotten(left: str, right: str, assuming: str) -> None:
    assert decide(left, right, assuming).kind is not PROVED


def test_an_identically_vanishing_denominator_proves_nothing() -> None:
    for text in ("x/(cos(2*x) - 1 + 2*sin(x)**2)", "x/(sin(x)**2 + cos(x)**2 - 1)", "x*(x - x)**(-1)"):
        assert decide(text, text).kind is UNDECIDED


def test_scope_gives_names_their_meaning() -> None:
    inertia = symbol("m") * symbol("R") ** 2 * Fraction(1, 2)
    scope = Meanings(scalars={"I": inertia}, vectors={"r": Space(EX * symbol("R"))})
    m, radius = t.Sym("m"), t.Sym("R")
    half = t.Div(t.Mul((m, t.Pow(radius, t.TWO))), t.TWO)
    assert equal(t.Sym("I"), half, scope=scope).is_proved
    assert equal(t.Dot(t.Vec("r"), t.Vec("r")), t.Pow(radius, t.TWO), scope=scope).is_proved
    assert equal(t.Vec("r"), t.Mul((radius, t.Unit("x"))), scope=scope).is_proved
    assert equal(t.Vec("r"), t.Mul((radius, t.Unit("y"))), scope=scope).is_refuted


def test_a_vector_is_no_scalar() -> None:
    with pytest.raises(ReadError):
        equal(t.Unit("x"), t.ONE)
    assert equal(t.Add((t.Unit("x"), t.Neg(t.Unit("x")))), t.ZERO).is_proved


def test_a_point_that_satisfies_a_relation_between_ranges() -> None:
    theta, start = symbol("theta"), symbol("theta_0")
    given = Assumptions(ranges={"theta": (lift(0), start), "theta_0": (lift(0), PI * Fraction(1, 2))})
    assert compare(sine(theta), sine(start), given).is_proved
    assert compare(cosine(theta), cosine(start), given).is_refuted
    assert compare(sine(theta) ** 2 + cosine(theta) ** 2, lift(1), given).is_refuted
    assert compare(sine(theta) ** 2 + cosine(theta) ** 2, lift(1), given, strict=False).is_proved


def test_the_free_disk_swings_faster() -> None:
    m, big, ell, radius, g = map(symbol, ["m", "M", "ell", "R", "g"])
    given = positive("m", "M", "ell", "R", "g")
    pull, inertia = g * ell * (m / 2 + big), m * ell**2 / 3 + big * ell**2
    fixed, free = pull / (inertia + big * radius**2 / 2), pull / inertia
    assert compare(fixed, free, given).is_proved
    assert compare(free, fixed, given).is_refuted
    assert compare(fixed, free, given.without("M")).kind is not PROVED


def test_verdicts_together() -> None:
    assert all_of([proved("a"), undecided("b")]).kind is UNDECIDED
    assert all_of([undecided("b"), decide("x", "y")]).kind is REFUTED
    assert all_of([proved("a"), proved("a")]) == proved("a")


def test_too_large_is_undecided() -> None:
    names = [f"x{k}" for k in range(12)]
    big = read_infix(f"({' + '.join(names)})**12", names)
    verdict = equal(big, t.Add((big, t.Num(1))))
    assert verdict.kind is UNDECIDED and ("beyond" in verdict.reason or "terms" in verdict.reason)


def test_sympy_is_not_imported() -> None:
    code = "import rbpsym.decide.equal, rbpsym.decide.radicals, sys; sys.exit('sympy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.parametrize(
    ("integrand", "lower", "upper"),
    [
        (t.Div(t.ONE, t.Pow(X, t.TWO)), t.Neg(t.ONE), t.ONE),
        (t.Div(t.ONE, t.Pow(X, t.TWO)), t.Neg(t.Sym("a")), t.Sym("a")),
        (t.Div(t.ONE, t.Pow(t.Fn("cos", X), t.TWO)), t.ZERO, t.Sym("pi")),
        (t.Div(t.ONE, t.Pow(t.Fn("sin", X), t.TWO)), t.ONE, t.Mul((t.TWO, t.Sym("pi")))),
        (t.Div(t.ONE, t.Pow(t.Add((X, t.Neg(t.ONE))), t.TWO)), t.ZERO, t.TWO),
    ],
)
def test_no_integral_goes_through_a_pole(integrand: t.Node, lower: t.Node, upper: t.Node) -> None:
    """Whatever it is said to be: the antiderivative at the ends, too."""
    integral = t.Integral(integrand, "x", lower, upper)
    for said in (t.ZERO, t.Neg(t.TWO), t.Neg(t.Div(t.TWO, t.Sym("a"))), integral):
        assert not equal(integral, said, positive("a")).is_proved


def test_an_integral_beside_a_pole_is_proved_with_its_obligation() -> None:
    verdict = equal(t.Integral(t.Div(t.ONE, t.Pow(X, t.TWO)), "x", t.ONE, t.TWO), t.Div(t.ONE, t.TWO), positive("a"))
    assert verdict.is_proved
    assert verdict.obligations and not verdict.open_obligations


def test_a_relation_is_refuted_only_where_the_conditions_hold():
    """Conditions that say nothing of one quantity alone, so that no assumption can be made of them."""
    a, b, given = symbol("a"), symbol("b"), positive("a", "b")
    less, more = ((Condition(t.ZERO, ">", way * (a**3 - a * b**2)),) for way in (-1, 1))
    assert compare(a, b, given).is_refuted
    with refuted_only_where(more):
        assert compare(a, b, given).is_refuted
    with refuted_only_where(less):
        assert compare(a, b, given).kind is UNDECIDED
    assert compare(a, b, given).is_refuted
