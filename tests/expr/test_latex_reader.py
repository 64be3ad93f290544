"""What papers write, and what the LaTeX reader refuses."""


import pytest

from rbpsym.errors import RbpsymError
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.expr.tree import Abs, BodyIntegral, Integral, Mul, Pow, Sym, Vec, Word, relation
from rbpsym.typeset.text import to_text
from tests.effort import at_most

SYMBOLS = """m M g ell R theta theta_0 theta_dot theta_ddot phi omega omega_0 I_cm I_O_prime N_w r
    r_prime V_cm F_net Delta_x cal_W_T t T k x y""".split()  # fmt: skip

READ = {
    r"g(m + M)": "g(m + M)",
    r"\frac12 M V_{cm}^2": "½M V_cm²",
    r"\frac 1 2 m": "½m",
    r"\tfrac{1}{2} m": "½m",
    r"\dot\theta^2": "θ̇²",
    r"\ddot{\theta}\,m": "θ̈m",
    r"V_\mathrm{cm} + V_{\text{cm}}": "V_cm + V_cm",
    r"\sin^2\theta + \cos ^{2} \theta": "sin² θ + cos² θ",
    r"\sin\left(2\theta\right)": "sin 2θ",
    r"\sin{\theta} m": "sin(θ) m",
    r"\omega^2_0": "ω₀²",
    r"\omega_0^2": "ω₀²",
    r"r'^2 + r^{\prime 2}": None,
    r"I_{O'}": "I_(O′)",
    r"\vec{r}\hspace{0.01cm}^{'} \times \vec F_{net}": "r⃗′ × F⃗ₙₑₜ",
    r"\vec{r}\cdot\vec{r} + 2\cdot 3": "r⃗ · r⃗ + 2 · 3",
    r"2 \times 3": "2 · 3",
    r"\|\vec r\| + |m| + ||\vec r|| + \left|\frac mM\right|": "|r⃗| + |m| + |r⃗| + |m/M|",
    r"m\hat{\imath} + M \hat j": "m î + M ĵ",
    r"\int_0^\theta d\theta\, g\ell(m + M) - k": "∫₀^θ gℓ(m + M) dθ − k",
    r"\int_{0}^{\theta} m\, d\theta": "∫₀^θ m dθ",
    r"\int\limits_0^\theta (x + y)\,\mathrm{d}\theta": "∫₀^θ (x + y) dθ",
    r"\frac{d\theta}{dt}": "dθ/dt",
    r"\frac{d^2 \theta}{d t^2}": "d²θ/dt²",
    r"\frac{\partial T}{\partial \dot\theta}": "∂T/∂θ̇",
    r"\Delta x + \Delta m": "Δx + Δm",
    r"M R^2/2": "MR²/2",
    r"9.81\,m": "9.81m",
    r"\sqrt{2 g \ell}": "√(2gℓ)",
    r"θ + ½": None,
    r"\mathcal W_T": "𝒲_T",
    r"e = 1": None,
    r"x = m,": "x = m",
    r"x = m, \quad y = k": "x = m\ny = k",
    r"x = m, \quad\text{so that}\quad y = k.": "x = m\ny = k",
    r"\left( m + M \right. \\ &\qquad {}+ \left. k \right) g": "(m + M + k) g",
    r"\left( m + M \right. \\ \left. + k \right) g": "(m + M + k) g",
    r"\sqrt[3]{x}": "x¹ᐟ³",
    r"\sqrt[2]{x}": "√x",
    r"x &= m \\ &= M \nonumber": "x = m = M",
    r"x < m \le M": "x < m ≤ M",
}


@pytest.mark.parametrize("latex", [latex for latex, text in READ.items() if text])
def test_meaning(latex):
    assert to_text(read_latex(latex, SYMBOLS)) == READ[latex]


def test_trees():
    m, th, r = Sym("m"), Sym("theta"), Vec("r")
    assert read_latex(r"\int_\Omega dm\, r^2", SYMBOLS) == BodyIntegral(Pow(Sym("r"), read_latex("2", [])))
    assert read_latex(r"\int_\theta^m d\theta", SYMBOLS) == Integral(read_latex("1", []), "theta", th, m)
    assert read_latex(r"|\vec r|", SYMBOLS) == Abs(r)
    assert read_latex(r"m = \text{const}", SYMBOLS) == relation(m, "=", Word("const"))
    assert read_latex(r"m^c k", {r"m^c": "m_c", "k": "k"}) == Mul((Sym("m_c"), Sym("k")))


def test_d_is_a_symbol_where_the_problem_says_so():
    assert read_latex(r"\frac{d x}{d t}", ["d", "x", "t"]).num == Mul((Sym("d"), Sym("x")))


def test_every_token_has_a_part_in_the_tree_or_an_error():
    table = symbol_table(SYMBOLS)
    for extra in ("+", r"\alpha", "q", "^", "_", "}", r"\foo", "&x", "!", "#", "$", "%", "@", r"\begin{foo}", '"'):
        with pytest.raises(RbpsymError):
            read_latex(rf"m g {extra}", table)


REFUSED = {
    "": "ends too early",
    "m +": "ends too early",
    r"\foo": "“\\foo”",
    r"q": "unknown symbol “q”",
    r"\theta_3": "Did you mean",
    r"\frac{m}{": "ends too early",
    r"(m": "never closed",
    r"m)": "not expected",
    r"\int m": "no differential",
    r"\int_0 m\,d\theta": "do not fit",
    r"\sin": "needs its argument",
    r"\sin\theta m": "function's argument",
    r"\sin\theta/2": "function's argument divided",
    r"\sin^{-1}\theta": "in two ways",
    r"m/M k": "above or below",
    r"2/M k": "above or below",
    r"m & k": "“&” is not expected here",
    r"2 3": None,
    r"\frac{d\theta}{dt^2}": "orders above and below",
    r"\begin{matrix} m \end{matrix}": "environment",
    r"m % comment": "percent",
    r"m $": "dollar",
    "m\u200b": "zero width space",
    r"\sqrt[1]{m}": "from 2 to 64",
    r"\sqrt[n]{m}": "from 2 to 64",
    r"x_{}^2": "is empty",
    r"m^{99}": "beyond 64",
    r"[m]_0^1": "which variable",
}


@pytest.mark.parametrize("latex", [latex for latex, part in REFUSED.items() if part])
def test_refused_with_a_sentence(latex):
    with pytest.raises(RbpsymError) as caught:
        read_latex(latex, SYMBOLS)
    assert REFUSED[latex] in str(caught.value)
    assert caught.value.place.column


HOSTILE = {
    "long": "m" * 9000,
    "braces": "{" * 3000 + "m" + "}" * 3000,
    "open": "{" * 7000,
    "fractions": r"\frac{1}{" * 800 + "m" + "}" * 800,
    "digits": "1" * 5000,
    "powers": "{" * 50 + "m^{60}" + "}^{60}" * 50,
    "subscripts": "m" + "_{m" * 2000 + "}" * 2000,
    "primes": "q" + "'" * 5000,
    "products": "m " * 3500,
    "accents": r"\vec{" * 1000 + "m" + "}" * 1000,
    "bars": "|" * 5000,
    "integrals": r"\int " * 1000,
}


@pytest.mark.parametrize("kind", HOSTILE)
def test_hostile_input_is_refused_quickly(kind):
    with at_most(), pytest.raises(RbpsymError) as caught:
        read_latex(HOSTILE[kind], SYMBOLS)
    assert len(caught.value.what) < 200


def test_two_symbols_that_are_printed_alike():
    with pytest.raises(RbpsymError, match="printed alike"):
        read_latex("W_{1,2}", ["W_1_2", "W_12"])


BRACKETS = [r"[m] = g", r"x = [m]", r"x[0] = g", r"g = m x[1]", r"g = x^{2}[1] m", r"m[x] = g", r"g = 2 m_{a}[x]"]


@pytest.mark.parametrize("latex", BRACKETS)
def test_a_unit_or_index_in_brackets_is_no_factor(latex):
    names = {"m": "m", "g": "g", "x": "x", "m_a": "m_a"}
    with pytest.raises(RbpsymError):
        read_latex(latex, names)
    assert read_latex(latex, names, whole=True)


@pytest.mark.parametrize("latex", [r"g = 9.8 \, \frac{m}{s^2}", r"g = 9.8\frac{m}{s^{2}} \\ x = m", r"g = 9.81~m/s^2."])
def test_a_decimal_with_letters_of_units_is_asked_for(latex):
    with pytest.raises(RbpsymError, match="unit"):
        read_latex(latex, {"m": "m", "g": "g", "s": "s", "x": "x"})


def test_a_limit_may_name_its_variable():
    names = {"x": "x", "y": "y", "m": "m"}
    assert read_latex(r"y = \int_{x=0}^{x=m} x\,dx", names) == read_latex(r"y = \int_0^m x\,dx", names)
    with pytest.raises(RbpsymError, match="another variable"):
        read_latex(r"y = \int_{y=0}^{m} x\,dx", names)
