"""What a language brings to formulas: names of functions and of bodies, printed and read back."""

from __future__ import annotations

import pytest
import typst

from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation, renamed
from rbpsym.expr.infix import read_infix
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.mathml import to_mathml
from rbpsym.typeset.omml import to_omml
from rbpsym.typeset.text import to_text
from rbpsym.typeset.typst import to_typst

SPANISH = Notation(
    functions={"sin": "sen", "asin": "arcsen"}, names={"rod": "varilla", "rod_1": "péndulo_1"}, decimal=","
)
THETA = t.Sym("theta")
FORMULA = t.Mul((t.Sym("W_rod_1"), t.Pow(t.Fn("sin", THETA), t.TWO), t.Fn("asin", t.Sym("I_rod"))))


def test_what_is_printed_is_read_back() -> None:
    latex = to_latex(FORMULA, SPANISH)
    assert r"\operatorname{sen}^2\theta" in latex
    assert r"\text{péndulo}" in latex
    assert r"\mathrm{varilla}" in latex
    assert read_latex(latex, symbol_table(["theta", "W_rod_1", "I_rod"], SPANISH)) == FORMULA


def test_every_format_prints_the_names_of_the_language() -> None:
    for text in (to_mathml(FORMULA, SPANISH), to_omml(FORMULA, SPANISH), to_text(FORMULA, SPANISH)):
        assert "sen" in text
        assert "sin" not in text
    assert typst.compile(f"$ {to_typst(FORMULA, SPANISH)} $".encode()).startswith(b"%PDF")


def test_whole_parts_of_a_name_are_renamed_the_longest_first() -> None:
    assert renamed("W_rod_1", SPANISH.names) == "W_péndulo_1"
    assert renamed("W_rod_2", SPANISH.names) == "W_varilla_2"
    assert renamed("W_rods", SPANISH.names) == "W_rods"


@pytest.mark.parametrize(
    "text",
    [
        r"\operatorname{sen}\theta",
        r"\sen\theta",
        r"\mathrm{sen}(\theta)",
        r"{\rm sen}\,\theta",
        r"\operatorname*{sen} \theta",
    ],
)
def test_spanish_functions_are_read_in_latex(text: str) -> None:
    assert read_latex(text, symbol_table(["theta"])) == t.Fn("sin", THETA)


@pytest.mark.parametrize(("word", "name"), [("sen", "sin"), ("tg", "tan"), ("cotg", "cot"), ("arcsen", "asin")])
def test_spanish_functions_are_read_as_they_are_typed(word: str, name: str) -> None:
    assert read_infix(f"{word}(theta)", ["theta"]) == t.Fn(name, THETA)
    assert read_latex(rf"\{word}\theta", symbol_table(["theta"])) == t.Fn(name, THETA)


def test_an_upright_label_may_be_called_like_a_function() -> None:
    assert read_latex(r"I_{\mathrm{sec}}", symbol_table(["I_sec"])) == t.Sym("I_sec")
