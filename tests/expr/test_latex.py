"""LaTeX, sentence by sentence as a textbook would set it."""

import pytest

from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Relations
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.text import to_text
from tests.expr.samples import CALCULUS, RELATIONS, SCALARS, VECTORS

SYMBOLS = "m M g ell R theta theta_0 theta_1 theta_2 omega t x y k".split()

TYPED = {
    "-3*g*cos(theta)/(4*ell)": (r"-\frac{3 g \cos\theta}{4 \ell}", "−3g cos θ/(4ℓ)"),
    "m - -g": ("m + g", "m + g"),
    "m*g*ell": (r"m g \ell", "mgℓ"),
    "sin(theta)": (r"\sin\theta", "sin θ"),
    "cos(2*theta)": (r"\cos 2 \theta", "cos 2θ"),
    "sin(theta_1 - theta_2)": (r"\sin(\theta_1 - \theta_2)", "sin(θ₁ − θ₂)"),
    "sin(theta)^2": (r"\sin^2\theta", "sin² θ"),
    "sin(m*g/2)": (r"\sin\frac{m g}{2}", "sin(mg/2)"),
    "sin(theta)*m": (r"\sin(\theta) m", "sin(θ) m"),
    "m*sin(theta)": (r"m \sin\theta", "m sin θ"),
    "sin(theta)*cos(theta)": (r"\sin\theta \cos\theta", "sin θ cos θ"),
    "1*m": ("m", "m"),
    "m*1": ("m", "m"),
    "2*3": (r"2 \cdot 3", "2 · 3"),
    "m*2": (r"m \cdot 2", "m · 2"),
    "(m + M)*g": ("(m + M) g", "(m + M) g"),
    "(m/2 + M)*g": (r"\left( \frac{m}{2} + M \right) g", "(m/2 + M) g"),
    "(m + M)/2": (r"\frac{m + M}{2}", "(m + M)/2"),
    "(m + M)^2": ("(m + M)^2", "(m + M)²"),
    "m - (g - k)": ("m - (g - k)", "m − (g − k)"),
    "m*(-g)": ("m (-g)", "m(−g)"),
    "-(m*g)": ("-m g", "−mg"),
    "1/2*m": (r"\frac{1}{2} m", "½m"),
    "2*(1/2)": (r"2 \cdot \frac{1}{2}", "2 · ½"),
    "sqrt(2*g/ell)": (r"\sqrt{\frac{2 g}{\ell}}", "√(2g/ℓ)"),
    "x^(1/2)": ("x^{1/2}", "x¹ᐟ²"),
    "x^(-1)": ("x^{-1}", "x⁻¹"),
    "theta_0^2": (r"\theta_0^2", "θ₀²"),
    "(x^2)^3": ("(x^2)^3", "(x²)³"),
    "(-x)^2": ("(-x)^2", "(−x)²"),
    "abs(x)": (r"\lvert x \rvert", "|x|"),
    "exp(-t)": (r"\exp(-t)", "exp(−t)"),
    "asin(x)": (r"\arcsin x", "arcsin x"),
    "9.81*m": ("9.81 m", "9.81m"),
    "3/4*m": (r"\frac{3}{4} m", "¾m"),
}


@pytest.mark.parametrize("typed", TYPED)
def test_typed_formulas_are_set(typed):
    tree = read_infix(typed, SYMBOLS)
    assert (to_latex(tree), to_text(tree)) == TYPED[typed]


SET = {
    "second derivative": r"\frac{d^2\theta}{dt^2}",
    "derivative": r"\frac{d}{dt}(\theta - \theta_0)",
    "work": r"-\int_{\theta_0}^{\theta} g \ell \left( \frac{m}{2} + M \right) \sin\theta \, d\theta",
    "integral of sum": r"\int_{\theta_0}^{\theta} (N_w \sin\theta - N_f \cos\theta) \, d\theta",
    "bracket": r"\left[ \frac{1}{2} \dot{\theta}_1^2 \right]_{\theta_0}^{\theta}",
    "bracket between": r"\left[ \cos\theta \right]_{\theta = 0}^{\theta = \pi/2}",
    "inertia": r"\int_{\Omega} r^2 \, dm",
    "torque work": r"\int\tau \, d\varphi",
    "partial": r"\frac{\partial T}{\partial\dot{\theta}}",
    "limit": r"\lim_{R \to 0}\omega \ell",
    "at": r"\left. N_w \right|_{\theta = \theta_0}",
}


@pytest.mark.parametrize("name", SET)
def test_calculus_is_set(name):
    assert to_latex(CALCULUS[name]) == SET[name]


def test_vectors_are_set():
    assert to_latex(VECTORS["work"]) == r"\int(\vec{N}_w + \vec{N}_f) \cdot d\vec{R}_{\mathrm{cm}}"
    assert to_latex(VECTORS["torque"]) == r"\sin\theta \, \hat{k}"
    assert to_latex(VECTORS["components"]) == r"m \, \hat{\imath} - M \, \hat{\jmath}"


def test_a_chain_is_set_in_rows():
    rows = (r"\alpha &= \frac{d^2\theta}{dt^2}", r"&= -\frac{3 g}{4 \ell} \cos\theta")
    assert to_latex(Relations((RELATIONS["alpha"],))) == rf"\begin{{aligned}} {rows[0]} \\ {rows[1]} \end{{aligned}}"


def test_the_ladder_in_one_line_of_text():
    assert to_text(SCALARS["ladder"]) == "−(3g/(4ℓ)) cos θ"
