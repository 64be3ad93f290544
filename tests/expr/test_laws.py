"""Laws of notation: every printer prints every formula; what is printed reads back."""

import re

import pytest
from hypothesis import HealthCheck, example, given, settings

from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import DEFAULT, Notation, notation_for
from rbpsym.expr.infix import read_infix, read_relation
from rbpsym.expr.latex.reader import read_latex
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.machine import to_machine
from tests.expr.printers import PRINTERS
from tests.expr.samples import RELATIONS, SAMPLES, SCALARS
from tests.expr.trees import NAMES, scalars
from tests.expr.values import close

law = settings(max_examples=250, suppress_health_check=list(HealthCheck))
NOTATIONS = {
    "default": DEFAULT,
    "aliases": notation_for([], {"theta_dot": "omega", "theta_ddot": "alpha"}),
    "bold, upright d, decimal comma": Notation(vector="bold", differential="upright", decimal=","),
}
UGLY = re.compile(r"[+-] -|- \+|(?<![\d.^])\b1 (\\cdot|\\frac|\\ell|\\theta|\\omega|[a-zA-Z(])|\\cdot -|--")


def quantities(node):
    """All names that a formula mentions, variables and bodies included."""
    kinds = ("var", "wrt", "body", "index")
    bound = {getattr(part, kind) for part in t.walk(node) for kind in kinds if hasattr(part, kind)}
    return t.names(node) | bound


@pytest.mark.parametrize("printer", PRINTERS)
@pytest.mark.parametrize("notation", NOTATIONS)
def test_every_printer_prints_in_every_notation(printer, notation):
    for tree in SAMPLES.values():
        assert PRINTERS[printer](tree, NOTATIONS[notation]).strip()


def test_every_node_type_has_a_sample():
    used = {type(part) for tree in SAMPLES.values() for part in t.walk(tree)}
    kinds = {kind for kind in vars(t).values() if isinstance(kind, type) and issubclass(kind, t.Node)}
    assert kinds - used == {t.Node, t.Formal}  # what is formal is read, and told in a text (test_foreign.py), never printed


@pytest.mark.parametrize("printer", PRINTERS)
@given(tree=scalars)
@settings(law, max_examples=100)
def test_every_printer_prints_random_formulas(printer, tree):
    assert PRINTERS[printer](tree).strip()


@pytest.mark.parametrize("notation", NOTATIONS)
@pytest.mark.parametrize("name", SAMPLES)
def test_latex_of_samples_reads_back(notation, name):
    tree, style = SAMPLES[name], NOTATIONS[notation]
    printed = to_latex(tree, style)
    back = read_latex(printed, quantities(tree), notation=style)
    assert to_latex(back, style) == printed


@pytest.mark.parametrize("name", SCALARS)
def test_latex_of_samples_keeps_the_value(name):
    assert close(read_latex(to_latex(SCALARS[name]), t.names(SCALARS[name])), SCALARS[name])


@pytest.mark.parametrize("name", SAMPLES)
def test_rows_read_back(name):
    tree = SAMPLES[name]
    back = read_latex(to_latex(t.Relations((tree,))), quantities(tree))
    assert to_latex(back) == to_latex(tree)


@given(tree=scalars)
@example(t.Mul((t.Fn("sin", t.Sym("theta")), t.Sym("m"))))
@law
def test_latex_of_random_formulas_keeps_the_value(tree):
    assert close(read_latex(to_latex(tree), NAMES), tree)


@given(tree=scalars)
@law
def test_latex_without_needless_parentheses_reads_back(tree):
    printed = to_latex(read_latex(to_latex(tree), NAMES))
    assert to_latex(read_latex(printed, NAMES)) == printed


@given(tree=scalars)
@law
def test_latex_is_clean(tree):
    assert not UGLY.search(to_latex(tree)), to_latex(tree)


@pytest.mark.parametrize("name", SCALARS)
def test_infix_of_samples_reads_back(name):
    tree = SCALARS[name]
    back = read_infix(to_machine(tree), t.names(tree))
    assert close(back, tree)


@pytest.mark.parametrize("name", ["order", "range", "near", "unequal", "split", "names"])
def test_relations_read_back(name):
    tree = RELATIONS[name]
    assert to_machine(read_relation(to_machine(tree), t.names(tree))) == to_machine(tree)


@given(tree=scalars)
@law
def test_infix_of_random_formulas_keeps_the_value(tree):
    assert close(read_infix(to_machine(tree), NAMES), tree)


@given(tree=scalars)
@law
def test_infix_is_printed_the_same_after_reading(tree):
    once = to_machine(read_infix(to_machine(tree), NAMES))
    assert to_machine(read_infix(once, NAMES)) == once


@given(tree=scalars)
@law
def test_spans_cover_the_source(tree):
    text = to_machine(tree)
    for part in t.walk(read_infix(text, NAMES)):
        start, end = part.span
        assert 0 <= start < end <= len(text)
        assert not isinstance(part, t.Sym) or text[start:end] == part.name
