"""Our own notes read back: every displayed formula of the LaTeX file passes the checkers of its step; one of an answer, whose
steps are certified in a draft of their own, says what its certified step says."""

from dataclasses import replace

import pytest

from rbpsym.claims.papers.walk import read_paper
from rbpsym.document.model import Display, parts
from rbpsym.document.notes import notation_of, notes
from rbpsym.document.notes_question import in_known_forms
from rbpsym.document.writers import writer
from rbpsym.expr import tree as t
from rbpsym.expr.latex.reader import read_latex
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import same
from rbpsym.proof.rules import certify
from tests.library.derived import answers_to

pytestmark = pytest.mark.heavy(of=6)

ALWAYS = {"O", "C", "t", "r"}


def _rows(node):
    return [row for part in node.rows for row in _rows(part)] if isinstance(node, t.Relations) else [node]


def test_every_display_of_the_file_is_proved(whole_draft, tmp_path):
    draft = whole_draft
    derivation = replace(draft.derivation, phases=(), simulation=None)
    document = notes(derivation, "en", "full")
    file = tmp_path / "notes.tex"
    file.write_text(writer("tex")(document), encoding="utf-8")
    shown = {d.label: d.node for d in parts(document) if isinstance(d, Display) and d.label}
    found = {f.labels[0]: f.latex for f in read_paper(file).displayed if f.labels}
    assert found.keys() == shown.keys()
    assert len(found) >= 5  # statics has few
    known = in_known_forms(answers_to(draft.study), draft.steps)
    answers = {row for told in known for step in told.steps for row in _rows(step.statement)}
    for label, latex in found.items():
        _read_back(draft, derivation, answers, label, shown[label], latex)


def _read_back(draft, derivation, answers, label, node, latex):
    """The formula is read with the names that it may hold; each step that it shows is certified again."""
    variables = {part.var for part in t.walk(node) if isinstance(part, t.Integral)}
    back = read_latex(latex.strip(), t.names(node) | ALWAYS | variables, notation=notation_of(derivation))
    printed, read = _rows(node), _rows(back)
    assert len(printed) == len(read), label
    left = set(range(len(printed)))
    for step in draft.steps:
        rows = _rows(step.statement)
        if all(row in printed for row in rows):
            places = [printed.index(row) for row in rows]
            statement = read[places[0]] if len(places) == 1 else t.Relations(tuple(read[k] for k in places))
            assert certify(draft.context, replace(step, statement=statement)).verdict.is_proved, (label, latex)
            left -= set(places)
    for place in [place for place in left if printed[place] in answers]:
        ends = [(printed[place].items[k], read[place].items[k]) for k in (0, -1)]
        assert all(mine == again or same(scalar(mine), scalar(again)) for mine, again in ends), (label, latex)
        left.remove(place)
    assert not left, (label, latex)
