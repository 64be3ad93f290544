"""Further formulas of physics texts: each is read as what is meant, or refused with a sentence."""

import pytest

from rbpsym.algebra.evaluate import scalar
from rbpsym.equality.decide import scalars_equal
from rbpsym.errors import RbpsymError
from rbpsym.notation.infix import read_infix
from rbpsym.notation.latex_reader import read_latex
from tests.notation.textbook import NAMES, ROWS


def test_the_table_is_large():
    assert len(ROWS) >= 150
    assert len({latex for latex, _ in ROWS}) == len(ROWS)


@pytest.mark.parametrize(("latex", "meant"), ROWS, ids=[row[0] for row in ROWS])
def test_it_is_read_as_meant(latex, meant):
    if meant == "!":
        with pytest.raises(RbpsymError):
            scalar(read_latex(latex, NAMES))
        return
    verdict = scalars_equal(scalar(read_latex(latex, NAMES)), scalar(read_infix(meant, NAMES)))
    assert verdict.is_proved, verdict
