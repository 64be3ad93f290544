"""Whatever is typed, both readers answer with a tree or a sentence, and soon."""

from functools import partial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rbpsym.decide.domain import faults
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix, read_relation
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.expr.tree import Node
from tests.effort import at_most
from tests.expr.textbook import DIMENSION_OF, NAMES, ROWS

LATEX = symbol_table(NAMES - {"d"}, faults=partial(faults, dimensions=DIMENSION_OF))
PIECES = r"""
\frac \frac12 { } ( ) [ ] \left( \right) \left. \right. \right| \left\{ \right\} ^ _ ^2 _0 ' / + - = < \le
\cdot \times \sin \cos\omega t \sin^2 \theta \dot\theta \ddot x \vec{r} \hat k \int_0^\theta \int d\theta
\mathrm dx \partial \sum_i \sqrt \sqrt[3] | m g \ell R 2 3.5 , . \, \; \quad & \\ \begin{aligned}
\end{aligned} \text{and} \text{const} \Delta \mathcal W \label{a} \nonumber \to \input{/etc/passwd}
\write18{ls} \def\a{\a} \csname % # $ ~ é \u 𝜃 ​ а
""".split()
TYPED = (
    "m g ell theta θ ω₁ θ0 ½ ² ^ ** * / + - − × · √ ( ) [ ] | "
    "sin sin² cos sqrt 2 3.5 1,5 1e3 , . _ __ = < <= ' \" \\ ẋ θ̇ \t é 𝜃 а ​"
).split(" ")
latex = st.lists(st.sampled_from(PIECES), max_size=14).map(" ".join)
typed = st.lists(st.sampled_from(TYPED), max_size=14).map("".join)
broken = st.tuples(st.sampled_from([row[0] for row in ROWS]), st.integers(0, 60), st.sampled_from(PIECES)).map(
    lambda item: item[0][: item[1]] + item[2] + item[0][item[1] :]
)
few = settings(max_examples=250)


def answers(read, text: str) -> None:
    """The reader gives a tree, or a sentence with its place."""
    try:
        with at_most():
            assert isinstance(read(text), Node)
    except RbpsymError as error:
        assert 0 < len(error.what) < 400


@few
@given(latex | broken | st.text(max_size=40))
def test_latex(text):
    answers(lambda t: read_latex(t, LATEX), text)


@few
@given(typed | st.text(max_size=40))
def test_infix(text):
    answers(lambda t: read_infix(t, NAMES), text)
    answers(lambda t: read_relation(t, NAMES), text)


HOSTILE = {
    "macro": r"\def\a{\a}\a",
    "braces": "{" * 3000 + "m" + "}" * 3000,
    "tower": "9^{9^{9^9}}",
    "file": r"\input{/etc/passwd}",
    "shell": r"\write18{rm -rf /}",
    "megabyte": "m+" * 500_000,
    "zero width": "m\u200b+g",
    "look-alike": "\u0430+g",
    "dunder": "m.__class__",
    "factors": r"\sin" + " m" * 3000,
    "open questions": " ".join([r"\sin m n"] * 40),
    "slashes": "+".join(["m/n x"] * 60),
    "powers": "((((((m^{60})^{60})^{60})^{60})^{60})^{60})",
    "digits": "1" * 5000,
    "accents": r"\dot{" * 500 + "m" + "}" * 500,
    "subscripts": "m" + "_{m" * 900 + "}" * 900,
    "primes": "m" + "'" * 5000,
    "rows": r"m=g\\" * 1500,
    "bars": "|" * 3000,
    "spellings": r"\vec" * 2000,
}


@pytest.mark.parametrize("kind", HOSTILE)
@pytest.mark.parametrize("table", [LATEX, symbol_table(NAMES)], ids=["dimensions", "names"])
def test_hostile_latex_gets_a_sentence_soon(kind, table):
    with at_most(), pytest.raises(RbpsymError) as caught:
        read_latex(HOSTILE[kind], table)
    assert len(caught.value.what) < 200
