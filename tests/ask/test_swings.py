"""Periods of swings of any size, by complete elliptic integrals."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
from scipy.integrate import solve_ivp

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.chapters import course
from rbpsym.decide import enclosure
from rbpsym.decide.signs import sign
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field import elliptic
from rbpsym.field.calculus import derivative
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.field.scalar import symbol
from rbpsym.mechanics.numbers import number, sample
from rbpsym.proof.draft import Draft
from rbpsym.proof.rules import certify
from rbpsym.statement.loader import load_text
from rbpsym.typeset.machine import to_machine
from tests.ask.test_answers import asked

PUSHED = """
[parameters]
m = "mass"
ell = "length"
g = "acceleration"
w = "angular velocity"
[coordinates.theta]
start = "0"
speed = "w"
[bodies.rod]
shape = "rod"
mass = "m"
length = "ell"
start = "O"
angle = "theta - pi/2"
[interactions.W]
type = "gravity"
[constraints.F]
type = "pivot"
point = "rod.start"
"""
BLOWN = """
[interactions.B]
type = "force"
on = "rod.cm"
force = ["m*A", "0"]
"""
TILTED = PUSHED.replace('speed = "w"\n', "").replace('w = "angular velocity"', 'A = "acceleration"') + BLOWN
CYCLOID = """
[parameters]
m = "mass"
R = "length"
g = "acceleration"
[coordinates.theta]
start = "theta_0"
range = ["-pi", "pi"]
[bodies.bead]
shape = "particle"
mass = "m"
center = ["R*(theta + sin(theta))", "R*(1 - cos(theta))"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "guide"
point = "bead.center"
curve = ["R*(theta + sin(theta))", "R*(1 - cos(theta))"]
"""
BOOKS = [
    ("rod-pendulum", "exact period of theta", "4*sqrt(2*ell/(3*g))*elliptic_k(sin(theta_0/2)**2)"),
    ("rod-pendulum", "time until theta = 0", "sqrt(2*ell/(3*g))*elliptic_k(sin(theta_0/2)**2)"),
    ("rod-pendulum", "time until theta = -theta_0", "2*sqrt(2*ell/(3*g))*elliptic_k(sin(theta_0/2)**2)"),
    ("rod-pendulum", "exact period of theta in the limit theta_0 -> 0", "2*pi*sqrt(2*ell/(3*g))"),
    ("rod-pendulum", "ratio of exact period of theta to period of theta", "2*elliptic_k(sin(theta_0/2)**2)/pi"),
    ("kater-pendulum", "period of large swings of theta", "4*sqrt((k**2 + h_1**2)/(g*h_1))*elliptic_k(sin(theta_0/2)**2)"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "question", "told"), BOOKS)
def test_periods_are_those_of_the_books(name: str, question: str, told: str) -> None:
    one = asked(name)
    found = answered(one, question)
    assert found.verdict.is_proved
    gap = found.values[0] / scalar(read_infix(told, one.whole.names))
    assert is_zero(gap * gap - 1)


def test_a_swing_that_is_pushed_swings_under_a_condition_that_is_told() -> None:
    found = answered(Asked(load_text(PUSHED)), "exact period of theta")
    assert found.verdict.is_proved
    [condition] = found.valid
    assert to_machine(condition) == "6*g - ell*w**2 > 0"


@pytest.mark.parametrize("text", [PUSHED, TILTED, CYCLOID], ids=["pushed", "tilted", "cycloid"])
def test_the_motion_has_the_period(text: str) -> None:
    one = Asked(load_text(text))
    told, numbers = answered(one, "exact period of theta"), sample(one.problem)
    assert told.verdict.is_proved
    gained = one.first.dynamics.accelerations["theta_ddot"]

    def rates(time: float, state) -> tuple[float, float]:
        return state[1], number(gained, {**numbers, "theta": state[0], "theta_dot": state[1]})

    start = one.first.system.scope.start
    begin = [number(start[name], numbers) for name in ("theta", "theta_dot")]
    period = number(told.values[0], numbers)
    end = solve_ivp(rates, (0, period), begin, rtol=1e-11, atol=1e-12).y[:, -1]
    assert end == pytest.approx(begin, abs=1e-7)
    half = solve_ivp(rates, (0, period / 2), begin, rtol=1e-11, atol=1e-12).y[:, -1]
    assert half != pytest.approx(begin, abs=1e-2)


def test_a_bead_on_a_cycloid_takes_the_same_time_from_everywhere() -> None:
    """Huygens, Horologium oscillatorium II, 25; on another curve it does not."""
    one = Asked(load_text(CYCLOID))
    for question, wanted in (("time until theta = 0", "pi*sqrt(R/g)"), ("exact period of theta", "4*pi*sqrt(R/g)")):
        found = answered(one, question)
        assert found.verdict.is_proved and [to_machine(node) for node in found.valid] == ["theta_0 != 0"]
        assert is_zero((found.value / scalar(read_infix(wanted, ["R", "g"]))) ** 2 - 1)
    assert answered(one, "does exact period of theta depend on theta_0").holds_so is False
    with pytest.raises(RbpsymError):
        answered(Asked(load_text(CYCLOID.replace("sin(theta)", "sin(theta)/2"))), "exact period of theta")


@pytest.mark.parametrize("quarters", [1, 2, 4])
@pytest.mark.parametrize("name", ["rod-pendulum", "cycloid"])
def test_another_time_is_not_proved(name: str, quarters: int) -> None:
    draft = Draft(Asked(load_text(CYCLOID)).first if name == "cycloid" else asked(name).first)
    course.swing(draft, "theta", quarters)
    step = draft.steps[-1]
    assert step.certificate.verdict.is_proved
    left, right = step.statement.items
    wrong = replace(step, statement=t.equation(left, t.mul(t.TWO, right)))
    assert not certify(draft.context, wrong).verdict.is_proved
    assert not certify(draft.context, replace(step, statement=t.equation(left, t.neg(right)))).verdict.is_proved
    if height := step.data["height"]:
        assert not certify(draft.context, replace(step, data={**step.data, "height": height * 2})).verdict.is_proved
    other = 2 if quarters == 4 else 4
    assert not certify(draft.context, replace(step, data={**step.data, "quarters": other})).verdict.is_proved


@pytest.mark.parametrize(("name", "why"), [
    ("bead-on-turning-hoop", "no period that is known"), ("torsion-pendulum", ""), ("elastic-pendulum", "not known"),
])  # fmt: skip
def test_what_is_no_such_swing_says_so(name: str, why: str) -> None:
    if not why:  # its period is that of small oscillations
        assert answered(asked(name), "exact period of theta").verdict.is_proved
        return
    with pytest.raises(RbpsymError, match=why):
        answered(asked(name), "exact period of theta")


@pytest.mark.parametrize("m", ["-2", "0", "1/3", "9/10", "999999/1000000"])
def test_the_integrals_are_those_of_mpmath(m: str) -> None:
    exact, size = Fraction(m), float(Fraction(m))
    assert elliptic.first(size) == pytest.approx(float(mpmath.ellipk(size)), rel=1e-14)
    assert elliptic.second(size) == pytest.approx(float(mpmath.ellipe(size)), rel=1e-14)
    with mpmath.workdps(100):
        value = mpmath.ellipk(mpmath.mpf(exact.numerator) / exact.denominator)
        low, high = (mpmath.mpf(end.numerator) / end.denominator for end in enclosure.ends(enclosure.elliptic_k(exact)))
        assert low <= value <= high and high - low < mpmath.mpf(10) ** -40


def test_no_integral_beyond_the_modulus_one() -> None:
    for m in (1, 2):
        with pytest.raises(ValueError, match="less than 1"):
            elliptic.first(m)
        with pytest.raises(enclosure.Outside):
            enclosure.elliptic_k(Fraction(m))


def test_derivatives_and_signs() -> None:
    names = ["x"]
    for kind, known in (("elliptic_k", mpmath.ellipk), ("elliptic_e", mpmath.ellipe)):
        value = scalar(read_infix(f"{kind}(x**2)", names))
        slope = number(derivative(value, "x"), {"x": 0.6})
        assert slope == pytest.approx(float(mpmath.diff(lambda x, k=known: k(x * x), 0.6)), rel=1e-10)
        assert sign(value + symbol("x") ** 2, asked("rod-pendulum").first.assumptions).kind == "positive"
