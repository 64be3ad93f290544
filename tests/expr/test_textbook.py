"""Further formulas of physics texts: each is read as what is meant, or refused with a sentence."""

from functools import partial

import pytest

from rbpsym.decide.domain import faults
from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.field.evaluate import Meanings, scalar
from rbpsym.field.scalar import symbol
from tests.expr.textbook import CALCULUS, DIMENSION_OF, NAMES, REFUSED, ROWS

WITHOUT_D = symbol_table(NAMES - {"d"}, faults=partial(faults, dimensions=DIMENSION_OF))
TABLE = symbol_table(NAMES, faults=partial(faults, dimensions=DIMENSION_OF))
RATES = {n: symbol(f"{n}_dot") for n in ("theta", "phi", "x", "y", "r")}
RATES |= {f"{n}_dot": symbol(f"{n}_ddot") for n in RATES}
MOTION = Meanings(rates=RATES)


def test_the_table_is_large():
    assert len(ROWS) >= 220
    assert len({latex for latex, _ in ROWS}) == len(ROWS)
    assert len(REFUSED) < 15


@pytest.mark.parametrize(("latex", "meant"), ROWS, ids=[row[0] for row in ROWS])
def test_it_is_read_as_meant(latex, meant):
    verdict = scalars_equal(scalar(read_latex(latex, TABLE), MOTION), scalar(read_infix(meant, NAMES)))
    assert verdict.is_proved, verdict


@pytest.mark.parametrize(("latex", "meant"), CALCULUS, ids=[row[0] for row in CALCULUS])
def test_calculus_is_read_as_meant(latex, meant):
    verdict = scalars_equal(scalar(read_latex(latex, WITHOUT_D), MOTION), scalar(read_infix(meant, NAMES)))
    assert verdict.is_proved, verdict


@pytest.mark.parametrize("latex", REFUSED)
def test_what_is_open_is_refused_with_a_caret(latex):
    with pytest.raises(RbpsymError) as caught:
        read_latex(latex, TABLE)
    assert caught.value.place.column


AMBIGUOUS = [r"\cos\omega t", r"\sin\theta m", r"\cos\theta(1+x)", r"g/4\ell", r"\sin\theta/2", r"\sin\theta_{0}m"]


@pytest.mark.parametrize("latex", AMBIGUOUS)
def test_without_dimensions_nothing_is_guessed(latex):
    with pytest.raises(RbpsymError):
        read_latex(latex, NAMES)
