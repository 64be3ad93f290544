"""What stands over a letter is the mark that it is meant to be, in every format, by the name that Unicode gives it."""

import re
import unicodedata
from xml.etree import ElementTree

import pytest

from rbpsym.expr.tree import Sym, Vec
from rbpsym.typeset.boxes import Accent, Letter
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.mathml import render as mathml
from rbpsym.typeset.mathml import to_mathml
from rbpsym.typeset.omml import formula, to_omml
from rbpsym.typeset.omml import render as omml
from rbpsym.typeset.typst import to_typst

NAMED = {
    "vec": ("ARROW",), "hat": ("CIRCUMFLEX",), "bar": ("MACRON", "OVERLINE"), "tilde": ("TILDE",),
    "check": ("CARON",), "dot": ("DOT ABOVE",), "ddot": ("DIAERESIS",), "dddot": ("THREE DOTS ABOVE",),
}  # fmt: skip


def mark_of_mathml(markup: str) -> str:
    """The sign over the letter."""
    root = ElementTree.fromstring(markup)
    over = root if root.tag.endswith("mover") else next(part for part in root.iter() if part.tag.endswith("mover"))
    return over[1].text


def mark_of_omml(markup: str) -> str:
    return re.search(r'<m:acc><m:accPr><m:chr m:val="(.)"/>', markup)[1]


@pytest.mark.parametrize("kind", NAMED)
def test_the_mark_over_a_letter(kind):
    box = Accent(kind, Letter("x"))
    for sign in (mark_of_mathml(mathml(box)), mark_of_omml(formula(omml(box)))):
        name = unicodedata.name(sign)
        assert any(word in name for word in NAMED[kind]) or (kind, sign) == ("tilde", "~"), (kind, name)
        assert ("DOT ABOVE" in name) is (kind == "dot")


@pytest.mark.parametrize(("name", "kind", "latex"), [("x_dot", "dot", r"\dot"), ("x_ddot", "ddot", r"\ddot")])
def test_rates_have_as_many_dots_as_they_have_derivatives(name, kind, latex):
    for sign in (mark_of_mathml(to_mathml(Sym(name))), mark_of_omml(to_omml(Sym(name)))):
        assert any(word in unicodedata.name(sign) for word in NAMED[kind])
    printed = to_latex(Sym(name))
    assert re.match(re.escape(latex) + r"(?![a-z])", printed), printed
    assert re.search(rf"(?<![a-z])dot{'.double' if kind == 'ddot' else ''}(?![.a-z])|{kind}", to_typst(Sym(name)))


def test_a_vector_has_an_arrow():
    for sign in (mark_of_mathml(to_mathml(Vec("r"))), mark_of_omml(to_omml(Vec("r")))):
        assert "ARROW" in unicodedata.name(sign)
