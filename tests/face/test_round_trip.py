"""Expressions of sympy are what they were after they have been ours; what is ours is equal after it was sympy's."""

from __future__ import annotations

import pytest
import sympy
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rbpsym.decide.equal import equal
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as n
from rbpsym.face.reading import tree_of
from rbpsym.face.writing import Alphabet, alphabet
from rbpsym.typeset.machine import to_machine
from tests.library.derived import NAMES, unsimulated

pytestmark = pytest.mark.heavy

M, ell, g = sympy.symbols("M ell g", positive=True)
beta = sympy.Symbol("beta", real=True)
t = sympy.Symbol("t")
theta = sympy.Function("theta")(t)
WORDS = Alphabet({each.name: each for each in (M, ell, g, beta, t)} | {"pi": sympy.pi}, frozenset({"theta"}), frozenset())
LEAVES = st.sampled_from([M, ell, g, beta, t, theta, theta.diff(t), theta.diff(t, 2), sympy.pi]) | st.builds(
    sympy.Rational, st.integers(-9, 9), st.integers(1, 9)
)
PLAIN = (n.Num, n.Sym, n.Add, n.Neg, n.Mul, n.Div, n.Pow, n.Sqrt, n.Fn, n.Group)
ONE_OF = st.sampled_from([sympy.sin, sympy.cos, sympy.tan, sympy.asin, sympy.acos, sympy.atan, sympy.exp, sympy.sqrt, sympy.Abs])


def grown(parts: st.SearchStrategy[sympy.Expr]) -> st.SearchStrategy[sympy.Expr]:
    return st.one_of(
        st.builds(sympy.Add, parts, parts, parts),
        st.builds(sympy.Mul, parts, parts, parts),
        st.builds(sympy.Pow, parts, st.sampled_from([-2, -1, 2, 3, sympy.Rational(1, 2), sympy.Rational(3, 2)])),
        st.builds(lambda function, part: function(part), ONE_OF, parts),
    )


EXPRESSIONS = st.recursive(LEAVES, grown, max_leaves=8)


def is_kept(e: sympy.Expr) -> bool:
    """No roots of roots of numbers: sympy writes these otherwise each time that it builds them anew."""
    strange = e.has(sympy.zoo, sympy.nan, sympy.oo, sympy.I, sympy.sign, sympy.re, sympy.arg)
    return not strange and not any(p.base.is_number and p.exp.is_Rational and p.exp.q > 2 for p in e.atoms(sympy.Pow))


@settings(max_examples=300, suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow])
@given(EXPRESSIONS.filter(is_kept))
def test_sympy_to_ours_and_back(expression: sympy.Expr) -> None:
    try:
        tree = tree_of(expression)
    except RbpsymError as error:
        assert error.what  # a sentence
        return
    assert WORDS.write(tree) == expression


@pytest.mark.parametrize("name", NAMES)
def test_every_step_of_the_library_is_a_relation(name: str) -> None:
    """As many relations as are asserted; what sympy reads of it is equal to what was printed."""
    derivation = unsimulated(name)
    for own in (derivation, *(phase.derivation for phase in derivation.phases)):
        words = alphabet(own.study, own.letters)
        for step in own.steps:
            found = words.relations(step.statement)
            asserted = [*n.relations(step.statement)]
            assert len(found) == len(asserted) > 0, step.id
            for (left, op, right), relation in zip(asserted, found, strict=True):
                assert len(relation.args) == (3 if op == "~" else 2)
                if all(isinstance(part, PLAIN) for side in (left, right) for part in n.walk(side)):
                    for side, written in zip((left, right), relation.args[-2:], strict=True):
                        assert equal(side, tree_of(written), own.study.assumptions).is_proved, (step.id, to_machine(side))
