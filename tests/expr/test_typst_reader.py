"""Typst's math is read as Typst prints it: what we print as Typst comes back as the same tree."""

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.typst_reader import typst_to_latex
from rbpsym.typeset.typst import to_typst

NAMES = {
    r"\omega": "omega", r"\theta": "theta", r"\ell": "ell", "g": "g", "m": "m", r"v_{\text{cm}}": "v_cm", "f": "f", "x": "x",
    r"\dot x": "v", r"\theta_1": "theta_1", r"\ddot\theta": "a",
}  # fmt: skip
ROWS = [
    ("omega^2 = (3 g)/(2 ell) (sin theta - sin x)", r"\omega^2 = \frac{3g}{2\ell}(\sin\theta - \sin x)"),
    ("1/2 m v_\"cm\"^2 <= x", r"\frac12 m v_{\text{cm}}^2 \le x"),
    ("sqrt(x)/2 != root(3, x)", r"\frac{\sqrt x}{2} \ne \sqrt[3]{x}"),
    ("x/g/m = e^(-x/g)", r"\frac{\frac{x}{g}}{m} = e^{-\frac{x}{g}}"),
    ("dot.double(theta) = -abs(x) cos(theta)/ell", r"\ddot\theta = -|x| \frac{\cos(\theta)}{\ell}"),
    ("2(x)/g = dot(x) dot m", r"2\frac{x}{g} = \dot x \cdot m"),
]

PACKAGES = [  # what physica adds, and what only forms the page
    ("pdv(f, x) = dv(f, x, 2)", r"\frac{\partial f}{\partial x} = \frac{d^2 f}{dx^2}"),
    ("diaer(theta) = dv(,t) (omega)", r"\ddot\theta = \frac{d}{dt}(\omega)"),
    ("integral_0^x m dd(x) = difference(x)", r"\int_0^x m\,dx = \Delta x"),
    ("m = underbrace(x + g, \"known\") #h(2em) (3.1)", r"m = x + g"),
    ("m = integral_0^theta_1 f dif x + theta_1^2", r"m = \int_0^{\theta_1} f dx + \theta_1^2"),
    ("x = g ==> m = g", r"x = g \Rightarrow m = g"),
    ("mat(delim: \"[\", x, m; g, f) = x", r"\begin{bmatrix} x & m \\ g & f \end{bmatrix} = x"),
]


@pytest.mark.parametrize(("typst", "latex"), PACKAGES)
def test_packages_are_read(typst, latex):
    given = [read_latex(text, NAMES, whole=True) for text in (typst_to_latex(typst), latex)]
    assert given[0] == given[1]


@pytest.mark.parametrize("text", ["pdv(f) = x", "dv(f, x, g, 2) = x", "difference(x + g) = x", "vb x = g", "x bar g = x"])
def test_what_typst_would_print_otherwise_is_refused(text):
    with pytest.raises(RbpsymError):
        read_latex(typst_to_latex(text), NAMES)


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


def test_a_factorial_is_of_what_its_script_is_attached_to():
    assert typst_to_latex("x^n! + M_s! + a/k!") == r"x^{n}! + M_{s}! + \frac{a}{k!}"
