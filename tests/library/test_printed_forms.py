"""No step of a problem that ships is printed in a form that a careful author would mend, or wider than the page."""

import re

import pytest

from rbpsym.document.breaking import lines
from rbpsym.document.notes import notation_of
from rbpsym.document.writers.latex import COLUMN
from rbpsym.expr import tree as t
from rbpsym.expr.latex.reader import read_latex
from rbpsym.typeset.latex import to_latex
from tests.library.derived import NAMES, derived
from tests.library.suspicious import SUSPICIONS, suspicions

ALONE = re.compile(r"\\left\(\s*\\?[A-Za-z]+(?:_\w|_\{[^{}]*\})?\s*\\right\)")


def shown(name):
    """Each row of each step: its id and the relation."""
    found = derived(name)
    steps = [*found.steps, *(s for phase in found.phases for s in (*phase.begins, *phase.derivation.steps))]
    for step in steps:
        for row in step.statement.rows if isinstance(step.statement, t.Relations) else (step.statement,):
            yield step.id, row


@pytest.mark.parametrize("name", NAMES)
def test_the_forms_are_those_of_a_careful_author(name):
    notation = notation_of(derived(name))
    met = [(id, *found) for id, row in shown(name) for found in suspicions(row)]
    assert not [(id, what, to_latex(part, notation)) for id, what, part in met]
    assert not [id for id, row in shown(name) if ALONE.search(to_latex(row, notation))]


@pytest.mark.parametrize("name", NAMES)
def test_no_line_is_wider_than_the_page(name):
    notation = notation_of(derived(name))
    wide = {id for id, row in shown(name) if max(line.width for line in lines(row, notation, COLUMN)) > COLUMN}
    assert not wide


SPOILED = {
    "nested_below": r"\frac{g}{\frac{3g}{\ell} - \ell}",
    "fractions_on_both_sides_of_a_bracket": r"\frac{1}{\ell}(\frac{3k}{M} - g)",
    "needless_one": r"1 \cdot g",
    "double_minus": r"-(-g - \ell)",
    "all_negative_bracket": r"(-g - \ell) M",
    "uncancelled": r"\frac{M g}{M \ell}",
    "square_below_root": r"\sqrt{4 g}",
    "root_over_its_radicand": r"\frac{\sqrt{3 g \ell}}{\ell}",
    "leading_minus_below": r"\frac{g}{-M + m}",
    "factor_twice": r"\ell \ell",
    "two_fractions": r"\frac{g}{\ell} \frac{M}{m}",
    "untold_tangent": r"\frac{\sin^2 \theta}{\cos \theta}",
}


@pytest.mark.parametrize("name", SUSPICIONS)
def test_each_suspicion_is_raised(name):
    names = ("g", "ell", "k", "m", "M", "theta")
    assert name in {found for found, _ in suspicions(read_latex(SPOILED[name], names))}
    assert not list(suspicions(read_latex(r"\frac{3 (2 k - M g \ell)}{2 M \ell^2} \sin\theta", names)))
