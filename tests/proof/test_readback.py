"""Law 2: the LaTeX of every step, read back by our own reader, passes the checkers of the step."""

from dataclasses import replace

import pytest

from rbpsym.document.notes import notation_of
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.latex.tokens import tokenize
from rbpsym.expr.source import SourceText
from rbpsym.proof.rules import certify
from rbpsym.typeset.latex import to_latex

pytestmark = pytest.mark.heavy(of=6)

ALWAYS = {"O", "C", "t", "r"}


class _Derived:
    def __init__(self, study):
        self.study = study


def test_what_is_printed_is_what_was_proved(draft):
    notation = notation_of(_Derived(draft.study))
    wrong = []
    for step in draft.steps:
        text = to_latex(step.statement, notation)
        variables = {node.var for node in t.walk(step.statement) if isinstance(node, t.Integral)}
        back = read_latex(text, t.names(step.statement) | ALWAYS | variables, notation=notation)
        verdict = certify(draft.context, replace(step, statement=back)).verdict
        if not verdict.is_proved:
            wrong.append((step.id, text, verdict))
    assert not wrong


def test_each_token_of_what_is_printed_has_a_meaning(draft):
    notation = notation_of(_Derived(draft.study))
    printed = {to_latex(step.statement, notation): step.statement for step in draft.steps}
    text = max((text for text in printed if len(text) < 200), key=len)
    names = t.names(printed[text]) | ALWAYS | {node.var for node in t.walk(printed[text]) if isinstance(node, t.Integral)}
    read_latex(text, names, notation=notation)
    for token in tokenize(SourceText(text), gaps=True)[:-1]:
        with pytest.raises(RbpsymError):
            read_latex(rf"{text[: token.start]} \zzz {text[token.end :]}", names, notation=notation)
