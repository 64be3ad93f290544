"""Random formulas: rewritten by true identities they are PROVED, changed they are REFUTED."""

from __future__ import annotations

from fractions import Fraction

import mpmath
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import equal
from rbpsym.decide.verdict import PROVED, REFUTED
from rbpsym.expr import tree as t
from tests.decide.numeric import NoValue, at_witness, number

quickly = settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much])
NAMES = ("m", "ell", "x", "alpha", "beta")
GIVEN = Assumptions({"m": "positive", "ell": "positive"})
M, ELL, X, A, B = map(t.Sym, NAMES)
leaves = st.sampled_from([M, ELL, X, t.ONE, t.TWO, t.Num(Fraction(2, 3)), t.Fn("sin", A), t.Fn("cos", B)])


def _grown(inner: st.SearchStrategy) -> st.SearchStrategy:
    return st.one_of(
        st.lists(inner, min_size=2, max_size=3).map(lambda parts: t.Add(tuple(parts))),
        st.lists(inner, min_size=2, max_size=2).map(lambda parts: t.Mul(tuple(parts))),
        inner.map(t.Neg),
        inner.map(lambda part: t.Pow(part, t.TWO)),
        st.tuples(inner, st.sampled_from([M, ELL, t.Add((M, ELL))])).map(lambda pair: t.Div(*pair)),
        st.sampled_from([A, B, t.Add((A, B)), t.Mul((t.TWO, A))]).map(lambda angle: t.Fn("cos", angle)),
    )


formulas = st.recursive(leaves, _grown, max_leaves=6)
rooted = st.one_of(
    formulas,
    formulas.map(lambda part: t.Sqrt(t.Add((t.Pow(part, t.TWO), M)))),
    st.tuples(formulas, st.sampled_from([M, ELL, t.Mul((M, ELL)), t.Div(M, ELL)])).map(
        lambda pair: t.Mul((pair[0], t.Sqrt(pair[1])))
    ),
)

REWRITINGS = {
    "add and subtract": lambda f: t.Add((f, M, t.Neg(M))),
    "multiply and divide": lambda f: t.Div(t.Mul((f, t.Add((M, ELL)))), t.Add((ELL, M))),
    "times one": lambda f: t.Mul((f, t.Add((t.Pow(t.Fn("sin", A), t.TWO), t.Pow(t.Fn("cos", A), t.TWO))))),
    "difference of squares": lambda f: t.Div(
        t.Add((t.Pow(f, t.TWO), t.Neg(t.Pow(t.Add((M, ELL)), t.TWO)), t.Mul((t.Add((f, M, ELL)), M)),
               t.Mul((t.Add((f, M, ELL)), ELL)))), t.Add((f, M, ELL))),
    "double angle": lambda f: t.Add((f, t.Fn("sin", t.Mul((t.TWO, A))),
                                     t.Neg(t.Mul((t.TWO, t.Fn("sin", A), t.Fn("cos", A)))))),
    "half angle": lambda f: t.Mul(
        (f, t.Add((t.Fn("cos", A), t.Mul((t.TWO, t.Pow(t.Fn("sin", t.Div(A, t.TWO)), t.TWO))))))),
    "roots": lambda f: t.Div(t.Mul((f, t.Sqrt(M), t.Sqrt(ELL))), t.Sqrt(t.Mul((ELL, M)))),
    "root of a square": lambda f: t.Mul((f, t.Div(t.Sqrt(t.Pow(t.Add((M, ELL)), t.TWO)), t.Add((M, ELL))))),
    "exponentials": lambda f: t.Mul((f, t.Fn("exp", X), t.Fn("exp", t.Neg(X)))),
    "twice negative": lambda f: t.Neg(t.Neg(f)),
}  # fmt: skip
CHANGES = {
    "one more": lambda f: t.Add((f, t.ONE)),
    "a little more": lambda f: t.Add((f, t.Num(Fraction(1, 10**6)))),
    "a term more": lambda f: t.Add((f, t.Mul((M, t.Fn("sin", A))))),
    "a root more": lambda f: t.Add((f, t.Sqrt(M))),
}


@quickly
@given(rooted, st.lists(st.sampled_from(sorted(REWRITINGS)), min_size=1, max_size=3))
def test_rewritten_is_proved(formula: t.Node, ways: list[str]) -> None:
    other = formula
    for way in ways:
        other = REWRITINGS[way](other)
    assume(equal(formula, formula, GIVEN).kind is PROVED)
    verdict = equal(formula, other, GIVEN)
    assume("identically zero" not in verdict.reason)
    assert verdict.kind is PROVED, (formula, other, str(verdict))


@quickly
@given(rooted, st.sampled_from(sorted(REWRITINGS)), st.sampled_from(sorted(CHANGES)))
def test_changed_is_refuted(formula: t.Node, way: str, change: str) -> None:
    other = CHANGES[change](REWRITINGS[way](formula))
    assume(equal(formula, formula, GIVEN).kind is PROVED)
    verdict = equal(formula, other, GIVEN)
    assume("identically zero" not in verdict.reason)
    assert verdict.kind is REFUTED, (formula, other, str(verdict))
    point = at_witness(verdict.witness)
    assert abs(number(formula, point) - number(other, point)) > mpmath.mpf(10) ** -30


@quickly
@given(rooted, rooted)
def test_a_verdict_is_never_wrong(left: t.Node, right: t.Node) -> None:
    """Two formulas that have nothing to do with each other."""
    verdict = equal(left, right, GIVEN)
    for k in range(1, 4):
        point = {name: mpmath.mpf(k * place + 1) / 7 for place, name in enumerate(NAMES, 1)}
        try:
            same = abs(number(left, point) - number(right, point)) < mpmath.mpf(10) ** -30
        except NoValue:
            continue
        assert same or verdict.kind is not PROVED


@quickly
@given(rooted)
def test_absolute_value_and_root_of_a_square(formula: t.Node) -> None:
    assert equal(t.Sqrt(t.Pow(formula, t.TWO)), t.Abs(formula), GIVEN).kind is not REFUTED
    verdict = equal(t.Sqrt(t.Pow(formula, t.TWO)), formula, GIVEN)
    if verdict.is_refuted:
        assert number(formula, at_witness(verdict.witness)) < 0
