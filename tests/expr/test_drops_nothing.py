"""The reader drops nothing: each token has its meaning, and what has none or two is refused with a sentence."""

from dataclasses import replace
from functools import partial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rbpsym.decide.domain import faults
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.latex.tokens import tokenize
from rbpsym.expr.source import SourceText
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.typeset.text import to_text
from tests.expr.paper import equations
from tests.expr.test_paper import TABLE as PAPER
from tests.expr.textbook import CALCULUS, DIMENSION_OF, NAMES, ROWS

MOVING = frozenset("t x y r theta phi U E N F T tau".split())
CONSTANT = frozenset(NAMES) - MOVING - {f"{name}_{tail}" for name in MOVING for tail in ("dot", "ddot")}
KNOWN = symbol_table(NAMES - {"d"}, faults=partial(faults, dimensions=DIMENSION_OF))
VARYING = replace(KNOWN, varies=lambda name: name not in CONSTANT)
WITH_D = symbol_table(NAMES, faults=partial(faults, dimensions=DIMENSION_OF))

MEANT = {
    # rows that go on are joined
    r"U &= -mg x\cos\theta \\ &+ 17mg x": "U = −mgx cos θ + 17mgx",
    r"U &= -mg x\cos\theta \\ &- 17mg x": "U = −mgx cos θ − 17mgx",
    r"U = mg x \\ - 17mg x": "U = mgx − 17mgx",
    r"17g + b\ddot\theta \\ + \ddot x\cos\theta - \ddot x\cos\theta = 0": "17g + bθ̈ + ẍ cos θ − ẍ cos θ = 0",
    r"U = \begin{aligned}[t] mgx \\ + mgy \end{aligned}": "U = mgx + mgy",
    r"U &= mg x \\ &- 17mg x = E": "U = mgx − 17mgx = E",
    r"U = mg x, \\ + 17mg x": "U = mgx + 17mgx",
    r"x = \left( a + b \right. \\ \left. - r \right) \theta": "x = (a + b − r) θ",
    r"x = \left[ a + \left( b \right. \right. \\ \left. \left. - r \right) \right] \theta": "x = (a + (b − r)) θ",
    r"\ddot y = g \quad \\ \ddot x = -g \quad \\": "ÿ = g\nẍ = −g",
    r"x &= a t^2 \\ &\qquad {}+ h \\ &= y": "x = at² + h = y",
    r"x = (a + b \\ - r) \theta": None,
    r"\begin{array}{rcl} \ddot y &=& g \\ &=& -2g \end{array}": "ÿ = g = −2g",
    # relations side by side are separate
    r"\ddot y = \frac23 g\quad\quad \ddot x = -\frac g9": "ÿ = ⅔g\nẍ = −g/9",
    r"\ddot y = \frac23 g \; \ddot x = -\frac g9": "ÿ = ⅔g\nẍ = −g/9",
    r"\ddot y = g; \ddot x = g": "ÿ = g\nẍ = g",
    r"\ddot y &= g & \ddot x &= g": "ÿ = g\nẍ = g",
    r"\ddot y &= g \\ -\ddot x &= g": " ÿ = g\n−ẍ = g",
    r"\frac{\partial E}{\partial x} = 0 \quad \frac{\partial E}{\partial\dot x} = 0": "∂E/∂x = 0\n∂E/∂ẋ = 0",
    # what depends on what
    r"x(t) = \frac12 a t^2": "x = ½at²",
    r"U(\theta) = mg x": "U = mgx",
    r"U(x, \dot x) = mg x": "U = mgx",
    r"\tau = N(x)": "τ = Nx",
    r"g(m + M) = F": "g(m + M) = F",
    r"\frac{U}{N}(x) = r": "U/N = r",
    r"\frac{U}{N}(x) = r^2": "(U/N)x = r²",
    r"\frac{d}{dt} M\dot x = 0": "d/dt(Mẋ) = 0",
    r"\frac{d}{dt} R\theta = R\omega": "d/dt(Rθ) = Rω",
    r"\frac{d}{dt} \frac12 m v_0 x = U": "d/dt(½mv₀x) = U",
    r"\frac{d}{dt} (x) \dot x = 0": "(dx/dt)ẋ = 0",
}
REFUSED = {
    r"U &= -mg x\cos\theta \\ 17mg x": "nothing says how it goes on",
    r"U = -mg x\cos\theta, 12mg x": "nothing says how it goes on",
    r"a = b \quad r": "nothing says how it goes on",
    r"\ddot y = g \quad -\ddot x = g": "one formula, or are these two",
    r"\ddot y = g \\ -\ddot x = g": "one formula, or are these two",
    r"\ddot y &= g & \ddot x &= g \\ &= a & &= a": "what stands on the left",
    r"x = (h + b \\ r)": "product",
    r"x = h - \\ - b": "a sign begins the next",
    r"\left(\begin{array}{cc} h & -b \\\\ b & h \end{array}\right)": "environment",
    r"\begin{array}{cc} h & -b \end{array}": "“&”",
    r"\ddot x = h, \quad x = 0, \theta": "",
    r"\ddot x = h, \quad x = 0, 1": "",
    r"\ddot x = h, \quad x = h + 1, b": "",
    r"x = 0.65~m": "a unit",
    r"\ddot x = 9.81\;m/s^2 \\ x = h": "a unit",
    r"x = \int_h^b \vec\tau\cdot d\vec r": "which places",
    r"x = \int_B h dx": "limits do not fit",
    r"x = \begin{cases} h \\ -b \end{cases}": "environment",
    r"\theta(0) = 0": "value of a function",
    r"\dot\theta(0) = 0": "value of a function",
    r"U(0) = 0": "value of a function",
    r"g(0) = 0": "value of a function",
    r"U(\theta_0) = mg x": "value of a function",
    r"\frac{x}{r}(\theta) = \phi": "a product, or a value of a function",
    r"\frac{d}{dt} x\dot x = 0": "how much of this product",
    r"\frac{d}{dt} x/\ell = 0": "how much of this product",
    r"1{,}470 = 1.47": "decimal mark",
    r"x = 1,5": "decimal comma",
}


@pytest.mark.parametrize("latex", [latex for latex, text in MEANT.items() if text])
def test_it_is_read_as_meant(latex):
    assert to_text(read_latex(latex, VARYING)) == MEANT[latex]


@pytest.mark.parametrize("latex", REFUSED)
def test_what_has_no_or_two_meanings_is_refused(latex):
    with pytest.raises(RbpsymError) as caught:
        read_latex(latex, VARYING)
    assert REFUSED[latex] in str(caught.value)
    assert caught.value.place.column


@pytest.mark.parametrize(
    "between",
    [r"\qquad", r"\text{ for }", r", \quad"],
)
def test_a_side_condition_is_a_condition(between):
    found = read_latex(rf"\ddot y = g {between} 0\le\theta<\pi.", VARYING)
    assert [to_text(row) for row in found.rows] == ["ÿ = g"]
    assert [to_text(row) for row in found.conditions] == ["0 ≤ θ < π"]


def test_an_inequality_beside_another_is_a_claim():
    assert not read_latex(r"x < y, \quad y < r", VARYING).conditions


def test_a_decimal_comma_where_it_is_declared():
    declared = replace(KNOWN, comma=True)
    assert read_latex("1{,}470", declared) == read_latex("1.47", declared)
    assert read_latex("1{,}5", KNOWN) == read_latex("1.5", KNOWN)


def test_v_of_theta_is_no_product():
    found = read_latex(r"U(\theta) = U\theta", VARYING)
    assert found.items == (t.Sym("U"), t.Mul((t.Sym("U"), t.Sym("theta"))))


# --- the law: nothing may be put in the place of a token, or be taken away, without its being seen

FORMULAS = [
    *((latex, PAPER) for latex in equations().values()), *((latex, WITH_D) for latex, _ in ROWS),
    *((latex, KNOWN) for latex, _ in CALCULUS), *((latex, VARYING) for latex in MEANT),
]  # fmt: skip
PAGE = ("gap", "row", "begin")  # what only forms the page; a word that joins relations is a row too
NEUTRAL = frozenset((r"\rm", "&", r"\cdot", r"\times", "*", ",", ".", ";", r"\left.", r"\right."))


def without(latex, token, instead=""):
    return f"{latex[: token.start]} {instead} {latex[token.end :]}"


def outcome(latex, table):
    try:
        return read_latex(latex, table)
    except RbpsymError:
        return None


@pytest.mark.parametrize(("latex", "table"), FORMULAS, ids=[latex for latex, _ in FORMULAS])
def test_each_token_has_a_meaning(latex, table):
    meant = read_latex(latex, table)
    for token in tokenize(SourceText(latex), gaps=True)[:-1]:
        assert outcome(without(latex, token, r"\zzz"), table) is None, token
        of_function = r"U(x, \dot x)" in latex and token.text == r"\dot"  # what U depends on is not its value
        if token.kind not in PAGE and token.text not in NEUTRAL and not of_function:
            assert outcome(without(latex, token), table) != meant, token


TERMS = st.lists(
    st.sampled_from([r"mg x", r"\frac12 k x^2", r"U\cos\theta", r"(m + M) g x", r"\frac{E}{2}"]), min_size=1, max_size=4
)
SIGNS = st.sampled_from(["+", "-"])
BREAKS = st.sampled_from([" ", r" \\ &", r" \\ &\qquad ", r"\nonumber \\[2pt] & {}", r" \\ \quad &"])
PARTS = st.sampled_from([r" \\ ", r", \quad ", r"\quad ", r" ; ", r" \text{ and } ", ", ", r"\;\;", r" \\ \quad "])
RELATIONS = st.lists(st.tuples(st.sampled_from(["U", "E", r"\tau"]), TERMS), min_size=1, max_size=3)


@settings(max_examples=150)
@given(RELATIONS, st.data())
def test_rows_that_go_on_are_joined_and_relations_side_by_side_are_parted(relations, data):
    alone, shown = [], []
    for left, terms in relations:
        signs = [data.draw(SIGNS) for _ in terms[1:]]
        plain = f"{left} = {terms[0]}" + "".join(f" {sign} {term}" for sign, term in zip(signs, terms[1:], strict=True))
        broken = f"{left} &= {terms[0]}" + "".join(
            f"{data.draw(BREAKS)}{sign} {term}" for sign, term in zip(signs, terms[1:], strict=True)
        )
        alone, shown = [*alone, read_latex(plain, VARYING)], [*shown, broken]
    display = shown[0] + "".join(data.draw(PARTS) + row for row in shown[1:])
    found = read_latex(rf"\begin{{aligned}} {display} \end{{aligned}}.", VARYING)
    assert list(found.rows if isinstance(found, t.Relations) else [found]) == alone
