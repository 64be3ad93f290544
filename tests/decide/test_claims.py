"""Claims made at random of functions, roots and ranges: no verdict that arithmetic contradicts."""

from __future__ import annotations

import random

import pytest

from rbpsym.decide.equal import equal
from rbpsym.decide.verdict import Verdict
from rbpsym.expr.infix import read_infix
from tests.decide.numeric import SIGNS, NoValue, at_witness, fulfils, mpmath, some_points, typed
from tests.decide.rows import names_in, read_assumptions
from tests.effort import MANY, at_most

NAMES = ["a", "b", "x", "y"]
PIECES = ["x", "y", "a", "b", "2", "3", "1/2", "(x + y)", "(x - y)", "(1 - x)", "(x**2 + 1)", "cos(a)", "sin(a)", "cos(a/2)",
          "sin(2*a)", "cos(a - b)", "tan(a)", "sqrt(x)", "sqrt(2)", "(1 + cos(a))", "(1 - sin(a))", "exp(x)", "abs(x)",
          "(x**2 - y**2)", "(1 - cos(a)*cos(b))", "pi"]  # fmt: skip
CLAIMS = [
    ("sqrt(({p})**2)", "{p}"), ("sqrt(({p})**2)", "abs({p})"), ("sqrt({p})*sqrt({q})", "sqrt(({p})*({q}))"),
    ("sqrt(({p})/({q}))", "sqrt({p})/sqrt({q})"), ("sqrt(({p})**2*({q}))", "({p})*sqrt({q})"),
    ("ln(({p})*({q}))", "ln({p}) + ln({q})"), ("ln(({p})**2)", "2*ln({p})"), ("exp(ln({p}))", "{p}"),
    ("asin(sin({p}))", "{p}"), ("acos(cos({p}))", "{p}"), ("acos(cos({p}))", "abs({p})"), ("atan(tan({p}))", "{p}"),
    ("sqrt(1 - cos({p}))", "sqrt(2)*sin(({p})/2)"), ("sqrt(1 + cos({p}))", "sqrt(2)*cos(({p})/2)"),
    ("sqrt(1 + sin({p}))", "sin(({p})/2) + cos(({p})/2)"), ("sqrt(1 - sin({p})**2)", "cos({p})"),
    ("({p})/({p})", "1"), ("abs(({p})*({q}))", "abs({p})*abs({q})"), ("abs({p} + {q})", "abs({p}) + abs({q})"),
    ("sqrt({p} + {q} + 2*sqrt(({p})*({q})))", "sqrt({p}) + sqrt({q})"), ("asin({p}) + acos({p})", "pi/2"),
    ("sqrt({p} + {q} - 2*sqrt(({p})*({q})))", "sqrt({p}) - sqrt({q})"), ("sin(acos({p}))", "sqrt(1 - ({p})**2)"),
    ("cos(2*atan({p}))", "(1 - ({p})**2)/(1 + ({p})**2)"), ("acos(-({p}))", "pi - acos({p})"),
    ("atan({p}) + atan(1/({p}))", "pi/2"), ("asin({p})", "atan(({p})/sqrt(1 - ({p})**2))"),
    ("({p})**(3/2)", "({p})*sqrt({p})"), ("tan(({p})/2)", "sqrt((1 - cos({p}))/(1 + cos({p})))"),
    ("tan(({p})/2)", "sin({p})/(1 + cos({p}))"), ("exp({p})*exp({q})", "exp({p} + {q})"), ("{p}", "{q}"),
    ("sqrt(exp({p}))", "exp(({p})/2)"), ("ln(exp({p}))", "{p}"), ("ln(sqrt({p}))", "ln({p})/2"),
]  # fmt: skip
GIVEN = [
    "", "positive x y", "positive x; 0 < a < pi/2", "nonnegative x; nonzero y", " < x < 0; -pi/2 < a < pi/2",
    "0 < x < 1; 0 < y < x; 0 < a < pi; 0 < b < a", "-1 < x < 1; pi/2 < a < pi", "1 < x < ;  < y < 0; -pi < a < pi",
]  # fmt: skip


def some_formula(source: random.Random) -> str:
    """A piece, or two of them joined."""
    p, q = source.choice(PIECES), source.choice(PIECES)
    return source.choice([p, p, f"{p}*{q}", f"({p} + {q})", f"({p} - {q})", f"{p}/{q}"])


def verdict_on(left: str, right: str, given: str) -> Verdict:
    return equal(read_infix(left, NAMES), read_infix(right, NAMES), read_assumptions(given, NAMES))


def check(verdict: Verdict, left: str, right: str, given: str) -> None:
    """Points contradict no proof; a witness fulfils what is given, and the sides differ there."""
    if verdict.is_refuted:
        fixed = at_witness(verdict.witness)
        point = {**some_points(given, NAMES, 1, seed=1)[0], **fixed}
        parts = [part for part in given.split(";") if set(names_in(part)) - SIGNS.keys() <= fixed.keys()]
        assert fulfils(";".join(parts), NAMES, point)
        sides = verdict.witness.left, verdict.witness.right
        for text, told in zip((left, right), sides, strict=True):
            low = getattr(told, "lower", told)
            try:
                assert mpmath.almosteq(typed(text, point), low.numerator / mpmath.mpf(low.denominator), 1e-15, 1e-15)
            except NoValue:  # a radicand that is exactly zero there, and a little less in mpmath
                continue
    elif verdict.is_proved:
        for point in some_points(given, NAMES, 8, seed=len(left)):
            try:
                a, b = typed(left, point), typed(right, point)
            except NoValue:
                continue
            assert mpmath.almosteq(a, b, 1e-25, 1e-25), (left, right, given, point)


@pytest.mark.parametrize("place", range(len(CLAIMS)), ids=[f"{a} = {b}" for a, b in CLAIMS])
def test_no_verdict_is_contradicted(place: int) -> None:
    source = random.Random(place)
    for _ in range(8):
        p, q, given = some_formula(source), some_formula(source), source.choice(GIVEN)
        left, right = (side.format(p=p, q=q) for side in CLAIMS[place])
        check(verdict_on(left, right, given), left, right, given)


@pytest.mark.parametrize("given", [" < x < 0", "0 < x < ", "-1 < x < 0", "0 < x < 1", " < x < -1"])
def test_a_bound_of_zero_is_a_bound(given: str) -> None:
    """A range that ends at 0 is not taken for no range."""
    verdict = verdict_on("abs(x) - x", "1", given)
    assert verdict.is_refuted
    assert fulfils(given, ["x"], at_witness(verdict.witness))


@pytest.mark.parametrize(
    ("left", "right", "given"),
    [
        ("exp(exp(x))*exp(cos(a)/(x - y))", "exp(exp(x) + cos(a)/(x - y))", "1 < x < "),
        ("exp(exp(exp(x)))", "1", "1 < x < "),
        ("exp(x**9)", "exp(x**9) + 1/x", "positive x"),
        (
            "tan((x + y + 2 + (x - y)**3)/2)",
            "sqrt((1 - cos(x + y + 2 + (x - y)**3))/(1 + cos(x + y + 2 + (x - y)**3)))",
            "",
        ),
        ("sqrt(1 - sin((x**2 - y**2)*(x**2 + 1) + x)**2)", "cos((x**2 - y**2)*(x**2 + 1) + x)", ""),
        ("sqrt(1 + sin(3 - cos(a)*cos(b)))", "sin((3 - cos(a)*cos(b))/2) + cos((3 - cos(a)*cos(b))/2)", "0 < b < pi"),
        ("acos(cos(cos(a) + sin(1 + cos(a))))", "abs(cos(a) + sin(1 + cos(a)))", "pi/2 < a < pi"),
    ],
)
def test_no_claim_takes_forever(left: str, right: str, given: str) -> None:
    with at_most(MANY):
        check(verdict_on(left, right, given), left, right, given)
