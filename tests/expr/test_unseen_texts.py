"""What texts that nobody of this project wrote print: read as what is meant, or as a part that has no value."""

import pytest

from rbpsym.claims.papers.draft import ANY
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.reader import latex_ways
from rbpsym.typeset.text import to_text


def read(latex):
    return latex_ways(latex, ANY, whole=True).trees[0]


@pytest.mark.parametrize(
    ("latex", "told"),
    [
        (r"y = Ysin\omega", "y = Y sin ω"),
        (r"x = -cos{(\phi)} + sin x", "x = −cos ϕ + sin x"),
        (r"y = \cos\frac23 t", "y = cos(⅔t)"),
        (r"y = \sin\frac{\pi}{4} g", "y = sin(π/4) g"),
        (r"F = \sin^{2n}\phi", "F = (sin ϕ)²ⁿ"),
        (r"a = b, \quad \alpha,\beta = 1,2,3", "a = b"),
        (r"a = 0 \quad (i = 1,2,\cdots,s),\quad b = 0", "a = 0\nb = 0"),
        (r"\frac12 r + a& {}+b \\ & = c", "½r + a + b = c"),
        (r"\frac{\rm{d}v}{\rm{dt}} = 0", "dv/dt = 0"),
        (r"\frac{\partial{}}{\partial{x}}Q = 0", "∂Q/∂x = 0"),
        (r"R - q c + D = 0 \\ -R + E - q c = 0", "R − qc + D = 0\n−R + E − qc = 0"),
        (r"I' = x_k{}^2", "I′ = xₖ²"),
        (r"x|_{t=0} = a|_{t=0} + c|_{t=0}", "x|_(t = 0) = a|_(t = 0) + c|_(t = 0)"),
        (r"W = 5 E_{\mathrm{dr}} + 5\,\mathrm{dm}", "W = 5E_dr + 5dm"),
        (r"a = -m \sin[2](\theta) \qc b = c \qand v \overset{!}{=} u", "a = −m sin² θ\nb = c\nv = u"),
        (r"a &= 0 & \text{slackness} \\ -b &= 0", "a = 0\n−b = 0"),
        (r"{\partial \over \partial x} f = (m\over 2) v", "∂f/∂x = (m/2) v"),
        (r"a = I_{zz}^{C1} \frac{d^2\theta}{dt^2}", "a = I_(zz,C₁) d²θ/dt²"),
        (r"\left\lbrace\begin{aligned} a &= b \end{aligned}\right. \& {\color{red} c = \underline{d + e}}", "a = b\nc = d + e"),
        (r"\theta = {\tan}^{-1}(a/b)", "θ = arctan(a/b)"),
        (r"J_{j} = x^1 + x^2 + d'_{\text A}", "Jⱼ = xₛᵤₚ₁ + xₛᵤₚ₂ + d′_A"),
        (r"I = \frac{c{E}_{0}^{2}}{2} - a \quad \checkmark", "I = cE₀²/2 − a"),
        (r"{e}^{+} = {}_{Z}^{A}{\text{X}}_{N} + {\bf{q}}", "eₚₗᵤₛ = X_(Z,AN) + q⃗"),
        (r"1.\quad v = a t", "v = at"),
        (r"v = 2(t^{\prime 2} + 1) + {}^W L", "v = 2(t′² + 1) + L_W"),
        (r"\mathbf{v} \mathbf{\cdot} \mathbf{w} = \frac{\partial^2 {}}{\partial {\theta}^2} T", "v⃗ · w⃗ = ∂²T/∂θ²"),
        (r"\left\{ \, \begin{aligned} a &= b \end{aligned} \right. \quad \lor \quad c = 2", "a = b\nc = 2"),
        (r"a = x_{n+\frac12} + L_{y^\prime}, &\quad \text{(2D)}", "a = xₙₚₗᵤₛ₁ₚₑᵣ₂ + L_yprime"),
        (r"x_{P/O'} = x'_{P/O} + I_{O'}", "x_PperOprime = x′_PperO + I_(O′)"),
        (r"A = \hat{\imath}\cdot\vec v", "A = î · v⃗"),
        (r"-a^* = -b^* \\ 0 = c^*", "−aₛₜₐᵣ = −bₛₜₐᵣ\n0 = cₛₜₐᵣ"),
        (r"a = b + \\ -c", "a = b − c"),
        (r"\frac{\partial y}{\partial x} = \frac{\partial z/\partial x}{\partial z/\partial y}", "∂y/∂x = (∂z/∂x)/(∂z/∂y)"),
        (r"a = \mathrm{i} 2\omega", "a = i · 2ω"),
        (r"u = \int_0^T v\ dt = b", "u = ∫₀^T vdt = b"),
        (r"\lefteqn{a + b =} \\ && c > d", "a + b = c > d"),
        (r"a = 0 \,, \quad \text{con } i = 1, 2, 3 \,.", "a = 0"),
        (r"a = 0, \qquad i,j\in\{1,2,3\}.", "a = 0"),
        (r"\Delta = a", "Δ = a"),
        (r"a = (2\pi)^3 2\omega + t_3 2c + \ell{+}1", "a = (2π)³ · 2ω + t₃ · 2c + ℓ + 1"),
        (r"a = b \qquad (b')", "a = b"),
        (r"a = b\;(\text{F61})", "a = b"),
        (r"a = b ~~~\text{vector form: } c = d", "a = b\nc = d"),
        (r"-a = b_j \quad j = x,y,z", "−a = bⱼ"),
        (r"\frac{d^2 r}{{dt'^2}} = a \quad {b = c}", "d²r/dt′² = a\nb = c"),
        (r"{ a = b } \ \ \ {\begingroup\color{red} c\endgroup = d}", "a = b\nc = d"),
        (r"a = \bm{\mathrm{\tau}} \cdot \vec b \times \vec c", "a = τ⃗ · (b⃗ × c⃗)"),
        (r"f = \odv{}{t} v + \int F \odif{y} + \cos\ab(\omega t)", "f = dv/dt + ∫F dy + cos(ωt)"),
        (r"F = \sum_i a_i + \sum_i b_i + c_{kin}", "F = ∑ᵢ aᵢ + ∑ᵢ bᵢ + cₖᵢₙ"),
        (r"I = \left[\frac13 r^3\right]^\frac{\ell}{2}_0", "I = [⅓r³]_(r = 0)^(r = ℓ/2)"),
        (r"e = 4\% \quad {\bf M}{\bf v}^+ = {\bf n}{\bf v}_i", "e = 0.04\nM⃗v⃗ₚₗᵤₛ = n⃗v⃗ᵢ"),
    ],
)
def test_is_read_as_it_is_meant(latex, told):
    tree = read(latex)
    assert to_text(tree).replace(" ", "") == told.replace(" ", "")
    assert not any(isinstance(part, t.Formal) for part in t.walk(tree))


@pytest.mark.parametrize(
    ("latex", "kind"),
    [
        (r"q = [\phi \quad \delta]", "brackets"),
        (r"p = ?", "asked"),
        (r"T = 20^\circ C", "measured"),
        (r"\vec x &: M \to N", ":"),
        (r"r \in [0, \infty)", "∈"),
        (r"S = \{(x, v) : x = v\}", "braces"),
        (r"\phi_k = \sum_{i=1}^{k} \theta_i", "sum"),
        (r"\nabla\cdot E = \rho", "dotted"),
        (r"p = P(x, y|b, u)", "|"),
        (r"a = \log x", "log"),
        (r"L = S[q(\cdot)]", "·"),
        (r"p = \sum m_i v_i", "sum"),
        (r"A = M(poids)", "run"),
        (r"n = \|a\|_2^2", "marked"),
        (r"\forall \vec x, \quad a = b", "∀"),
        (r"\vec a \upuparrows \vec b", "⇈"),
        (r"f'(a) = f(a + h)/h", "value"),
        (r"\operatorname{\Box} A = 0", "□"),
        (r"h = \left. v \right)_0 r", "at"),
        (r"\frac{\partial x^{i}}{\partial y^{j}} = 0", "differential"),
        (r"x + ... + y = 0", "…"),
        (r"t = a|_{x_0}^{x} - b|_{x_0}^{x}", "between"),
        (r"V = a + O(\theta^3)", "order"),
        (r"\frac{\tilde{\mathrm{d}} L}{\mathrm{d} t} = M", "seen from"),
        (r"\frac{\mathrm{d}^n f}{\mathrm{d} t^n} = 0", "differential"),
        (r"(\frac{a}{b})^+ - c = 0", "marked"),
        (r"a = \SI[per-mode=symbol]{0.03}{m}", "measured"),
        (r"A^\top b = c", "transposed"),
        (r"x^T S x = 0", "transposed"),
        (r"A^{\mathrm T} b = W^\dagger", "transposed"),
        (r"\frac{\partial L}{\partial \vec v} = p", "differential"),
        (r"\pdv{L}{q^i} = \frac{\partial}{\partial x^\mu}", "differential"),
        (r"x[n+1] = A x[n]", "value"),
        (r"f\left(\frac{a+b}{2}\right) = f(a)", "value"),
        (r"V = \cancel{m g} + b", "cancelled"),
        (r"A = \mqty(a & b \\ c & d)", "matrix"),
        (r"a = \unit[-2.3]{m}", "measured"),
        (r"P(A|B) = 1", "|"),
        (r"A = \{x \mid |x| < 1\}", "|"),
        (r"\delta_{ij} = \begin{cases} 1, & \text{si } i = j, \\ 0, & \text{si } i \ne j. \end{cases}", "cases"),
        (r"d = \left\{\begin{aligned} 1, a = b,\\ 0, a \ne b. \end{aligned}\right.", "cases"),
        (r"u = \int I\,d\nu\,d\Omega", "integral"),
        (r"\frac{\partial_z^j}{j!} a = 0", "∂"),
        (r"A \otimes_C B = 0", "⊗"),
    ],
)
def test_what_has_no_value_is_a_formal_part(latex, kind):
    assert kind in {part.kind for part in t.walk(read(latex)) if isinstance(part, t.Formal)}


OPEN = [
    r"v = \sqrt{22,24}", r"\partial_{[2} E_{3]} = 0", r"F^{01} = 3", r"a = b + \quad c = d",
    r"F = \sum_{n>0} f_n \cos n + g_n \sin n", r"L = \sum_{i\ne j} r_i F_{ij} + r_j F_{ji}",
]  # fmt: skip


def test_a_wide_gap_parts_the_cells_of_values_by_cases():
    tree = read(r"f = \begin{cases} a \quad h > 0 \\ b &\quad h < 0 \end{cases}")
    assert [len(part.parts) for part in t.walk(tree) if isinstance(part, t.Formal)] == [2, 2, 2]


@pytest.mark.parametrize("latex", OPEN)
def test_what_may_mean_something_else_is_refused(latex):
    with pytest.raises(RbpsymError):
        read(latex)
