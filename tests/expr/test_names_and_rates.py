"""dω/dt in a line, and what a printed name looks like."""

import pytest

from rbpsym.errors import ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.names import drawn_name
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import Drawn

NAMES = ["omega", "theta", "I", "alpha", "m", "g", "beta"]


@pytest.mark.parametrize(
    ("latex", "tree"),
    [
        (r"\alpha=d\omega/dt", t.equation(t.Sym("alpha"), t.Deriv(t.Sym("omega")))),
        (r"I d\omega/dt=m", t.equation(t.Mul((t.Sym("I"), t.Deriv(t.Sym("omega")))), t.Sym("m"))),
        (r"d\vec\beta/dt=0", t.equation(t.Deriv(t.Vec("beta")), t.ZERO)),
        (r"\partial\omega/\partial\theta", t.Deriv(t.Sym("omega"), "theta", 1, True)),
        (r"\int_0^\theta g d\theta", t.Integral(t.Sym("g"), "theta", t.ZERO, t.Sym("theta"))),
    ],
)
def test_derivatives_in_a_line(latex, tree):
    assert read_latex(latex, NAMES) == tree


@pytest.mark.parametrize("latex", [r"d\omega", r"d\omega/m", r"g d\omega"])
def test_a_differential_alone_is_refused(latex):
    with pytest.raises(ReadError):
        read_latex(latex, NAMES)


@pytest.mark.parametrize(
    ("latex", "found"),
    [
        (r"\vec{R}_{cm}", (Drawn("R", label="cm"), True)),
        (r"\vec R_{cm}", (Drawn("R", label="cm"), True)),
        (r"\mathcal{W}_{\theta}", (Drawn("W", script=True, label="θ"), False)),
        ("v'", (Drawn("v", primes=1), False)),
        (r"\Delta x", (Drawn("x", prefix="Δ"), False)),
        (r"\dot\theta", (Drawn("θ", dots=1), False)),
        (r"\mathcal{W}^c_T", None),
        (r"2x", None),
        (r"x+y", None),
        ("", None),
    ],
)
def test_how_a_printed_name_is_drawn(latex, found):
    assert drawn_name(latex) == found
