"""Typst's math is read as Typst prints it: what we print as Typst comes back as the same tree."""

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.notation.latex_reader import read_latex
from rbpsym.notation.typst import to_typst
from rbpsym.notation.typst_reader import typst_to_latex

NAMES = {
    r"\omega": "omega", r"\theta": "theta", r"\ell": "ell", "g": "g", "m": "m", r"v_{\text{cm}}": "v_cm", "f": "f", "x": "x",
    r"\dot x": "v", r"\ddot\theta": "a",
}  # fmt: skip
ROWS = [
    ("omega^2 = (3 g)/(2 ell) (sin theta - sin x)", r"\omega^2 = \frac{3g}{2\ell}(\sin\theta - \sin x)"),
    ("1/2 m v_\"cm\"^2 <= x", r"\frac12 m v_{\text{cm}}^2 \le x"),
    ("sqrt(x)/2 != root(3, x)", r"\frac{\sqrt x}{2} \ne \sqrt[3]{x}"),
    ("x/g/m = e^(-x/g)", r"\frac{\frac{x}{g}}{m} = e^{-\frac{x}{g}}"),
    ("dot.double(theta) = -abs(x) cos(theta)/ell", r"\ddot\theta = -|x| \frac{\cos(\theta)}{\ell}"),
    ("2(x)/g = dot(x) dot m", r"2\frac{x}{g} = \dot x \cdot m"),
]


@pytest.mark.parametrize(("typst", "latex"), ROWS)
def test_it_binds_as_typst_binds(typst, latex):
    assert read_latex(typst_to_latex(typst), NAMES) == read_latex(latex, NAMES)


@pytest.mark.parametrize("latex", [latex for _, latex in ROWS])
def test_what_is_printed_comes_back(latex):
    tree = read_latex(latex, NAMES)
    again = read_latex(typst_to_latex(to_typst(tree)), NAMES)
    assert to_typst(again) == to_typst(tree)


@pytest.mark.parametrize("text", ["(x", "x_", "x/", "frac(x", "frac(x)", "(" * 500, "vec(x", "nothing(x)"])
def test_what_is_not_whole_is_refused(text):
    with pytest.raises(RbpsymError):
        read_latex(typst_to_latex(f"{text} = x"), NAMES)
