"""[notation] of a problem restyles its vectors and decimals in every format."""

from fractions import Fraction

import pytest

from rbpsym.courses import derive_course
from rbpsym.document.notes import course_notes
from rbpsym.document.phrases import problem_notation
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.statement.course import load_course
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_text
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.mathml import to_mathml
from rbpsym.typeset.text import to_text
from rbpsym.typeset.typst import to_typst

TEXT = find_problem("sliding-ladder").read_text(encoding="utf-8")
PRINTERS = {"latex": to_latex, "typst": to_typst, "mathml": to_mathml, "text": to_text}


def styled(marks):
    return problem_notation(load_text(TEXT.replace("[notation]", "[notation]\n" + marks)))


@pytest.mark.parametrize("printer", PRINTERS)
def test_vectors_and_decimals_are_restyled(printer):
    plain, other = styled(""), styled('vectors = "bold"\ndecimal = ","')
    assert (other.vector, other.decimal, other.glyph("theta_dot")) == ("bold", ",", plain.glyph("theta_dot"))
    for node in (t.Vec("F"), t.Num(Fraction(981, 100))):
        assert PRINTERS[printer](node, plain) != PRINTERS[printer](node, other)
    assert "," in PRINTERS[printer](t.Num(Fraction(981, 100)), other)


def test_a_mark_that_does_not_exist_is_refused():
    with pytest.raises(RbpsymError, match="vectors cannot be “wavy”"):
        styled('vectors = "wavy"')


def test_a_course_is_restyled_or_refused(tmp_path):
    file = tmp_path / "course.toml"
    text = '[notation]\nvectors = "{}"\n[[part]]\ntheory = "plane-motion"\n'
    file.write_text(text.format("bold"))
    assert course_notes(derive_course(load_course(file))).notation.vector == "bold"
    file.write_text(text.format("wavy"))
    with pytest.raises(RbpsymError, match="vectors cannot be “wavy”"):
        load_course(file)
