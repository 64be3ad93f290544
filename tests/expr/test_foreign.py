r"""What physicists write: forms and packages are read as what they mean, or refused with what to write instead."""

import pytest

from rbpsym.claims.papers.draft import ANY
from rbpsym.errors import RbpsymError
from rbpsym.expr.latex.reader import latex_ways, read_latex
from rbpsym.typeset.text import to_text

NAMES = {
    **{name: name for name in ("x", "v", "m", "g", "F", "a", "b", "k", "T", "t", "N", "R", "I")},
    r"\theta": "theta", r"\omega": "omega", r"\vec r": "r", r"\vec F": "F_v", r"\sum F_x": "sum_F_x", r"v_{+}": "v_plus",
    r"F_{\max}": "F_max", r"F^{\text{ext}}": "F_ext", r"v^-": "v_minus", r"x_{i+1}": "x_next", r"v_1": "v_1",
    r"I_\perp": "I_perp",    r"\vec{AB}": "AB", r"x^{(1)}": "x_first",
}  # fmt: skip

SAME = [
    (r"\bigg( a + b \bigg) = \Biggl\{ k \Biggr\}", "(a+b) = k"),
    (r"\therefore a = b \therefore -k = g", r"a=b, \quad -k = g"),
    (r"a = b \implies k = g \iff x = F", r"a = b \Rightarrow k = g \Leftrightarrow x = F"),
    (r"a = b \quad \text{for small } x", r"a = b \quad x \ll F"),
    (r"a = b \intertext{so that} k = g", "a=b, k=g"),
    (r"\boxed{a} = \textcolor{red}{b}", "a=b"),
    (r"\theta = 30^\circ", r"\theta = 30\frac{\pi}{180}"),
    (r"\theta = \ang{45} + 30°", r"\theta = 45\frac{\pi}{180} + 30\frac{\pi}{180}"),
    (r"\theta = 30^{\circ}", r"\theta = 30\frac{\pi}{180}"),
    (r"\dv{x}{t} = \dv[2]{x}{t}", r"\frac{dx}{dt} = \frac{d^2x}{dt^2}"),
    (r"\dv{t} \qty(m v) = \derivative{x}{t}", r"\frac{d}{dt}(m v) = \frac{dx}{dt}"),
    (r"\pdv{T}{v} = \partialderivative{T}{x}", r"\frac{\partial T}{\partial v} = \frac{\partial T}{\partial x}"),
    (r"\frac{\partial^2 T}{\partial x \partial v} = a", r"\frac{\partial}{\partial x}\frac{\partial T}{\partial v} = a"),
    (r"\frac{d (m v)}{dt} = \frac{d m v}{dt}", r"\frac{d}{dt}(m v) = \frac{d}{dt}(m v)"),
    (r"\abs{x} = \left\lvert a \right\rvert", "|x| = |a|"),
    (r"a \equiv b := k", "a = b = k"),
    (r"a \simeq b", r"a \approx b"),
    (r"{v}_{1} = v_1", "v_1 = v_1"),
    (r"a = {b \over k}", r"a = \frac{b}{k}"),
    (r"a = \underbrace{m g}_{\text{weight}}", "a = m g"),
    (r"\vec F = \mathbf{0}", r"\vec F = 0"),
    (r"\vec r = (a, b)", r"\vec r = a\hat{i} + b\hat{j}"),
    (r"\vec r = \begin{pmatrix} a \\ b \end{pmatrix}", r"\vec r = a\hat{i} + b\hat{j}"),
    (r"\int_0^T \frac{dt}{x} = \int_0^T \frac{1}{x} dt", r"\int_0^T \frac{1}{x} dt = \int_0^T \frac{1}{x} dt"),
    (r"\int_0^T a + t~dt = k", r"\int_0^T (a + t) dt = k"),
    (r"a = b \quad (i = 1, 2, \ldots, N)", "a = b"),
    (r"a = b, \qquad i=1,2", "a = b"),
    (r"a = b \qquad \text{(Newton's second law)}", "a = b"),
    (r"a = b \quad \Aboxed{\therefore k &= g}", "a=b, k=g"),
    (r"\begin{array}{l l} a = b \\ k = g \end{array}", "a=b, k=g"),
    (r"\begin{array}{r@{}c@{}l} a &=& b \end{array}", "a=b"),
    (r"F = m a \rightarrow a = \frac{F}{m}", r"F = m a \implies a = \frac{F}{m}"),
    (r"a = \\ = b", "a = b"),
    (r"a = b \\ \therefore k = g \\ = F", "a=b, k=g=F"),
    (r"\vec r = \left[\begin{array}{c} a \\ b \end{array}\right]", r"\vec r = \begin{bmatrix} a \\ b \end{bmatrix}"),
    (r"\int_a^b x \text{d}t = k", r"\int_a^b x dt = k"),
    (r"\int_B x^2 dm = \large I", r"\int_{\text{B}} x^2 dm = I"),
    (r"a = b \textrm{ for } i = 1,\ldots,n", "a = b"),
    (r"a = sin(\theta) + m cos\theta", r"a = \sin(\theta) + m\cos\theta"),
    (r"a = b\text{.}", "a = b"),
    (r"a = b \quad (i = k+1, \cdots, 3N-k)", "a = b"),
    (r"a = b, \quad i = 1, ..., n", "a = b"),
    (r"a = x × b · k", r"a = x \times b \cdot k"),
    (r"v = \cfrac{{\rm d} x}{{\rm d} t}", r"v = \frac{dx}{dt}"),
    (r"a = b ~~ {\rm for} ~ k > g", r"a = b \quad \text{for } k > g"),
    (r"a = b \rm\ and \rm\ k = \rm\sin\theta", r"a = b, k = \sin\theta"),
    (r"\left\{ \begin{array}{l} a = b \\ k = g \end{array} \right.", "a=b, k=g"),
    (r"\begin{aligned} x &: \quad a = b \\ \text{along the plane:} & k = g \end{aligned}", "a=b, k=g"),
    (r"\sum F_x: a = b", "a = b"),
    (r"a &= b & & \text{the force} \\ k &= g & & \text{a weight}", "a=b, k=g"),
    (r"a = b \; (\rightarrow)", "a = b"),
    (r"a = \ln \cos^2 x", r"a = \ln(\cos^2 x)"),
    (r"\log_a x = b", r"\frac{\ln x}{\ln a} = b"),
    (r"a = \num{8.3e-5} b + \num{-3} + \num{.5}", "a = 0.000083 b - 3 + 0.5"),
    (r"a = b \qq{so} k = g", r"a = b, k = g"),
    (r"a = b \qquad m=0,1,2,\dots \\ k = g", "a=b, k=g"),
    (r"a = b\:\:\mbox{for}\:\:\: i=1,2,\cdots,n.", "a = b"),
    (r"a &= b\quad&\text{(junction)}\\ k &= g\quad&\text{(loop)}", "a=b, k=g"),
    (r"a &= b&&\text{the force}\\ &= k", "a=b=k"),
    (r"a = b.......... (2)\\ k = g", "a=b, k=g"),
    (r"\vb*{r} = \va*{F} + \vec{{r}}", r"\vec r = \vec F + \vec r"),
    (r"\vec r \wedge \vec F = \vec r \land \vec F", r"\vec r \times \vec F = \vec r \times \vec F"),
    (r"x = g2\theta m", r"x = g \cdot 2\theta m"),
    (r"\int_0^T \abs{x}^2 \dd{x} = k", r"\int_0^T |x|^2 dx = k"),
    (r"\int_a^b kx dx = \left[\frac{1}{2}kx^2\right]_a^b", r"\int_a^b kx dx = [\frac12 kx^2]_{x=a}^{x=b}"),
    (r"m[x^2]_{x=a}^{x=b} = k", r"m \cdot [x^2]_{x=a}^{x=b} = k"),
    (r"\sum_{i=1}^{i=N} -m = k", r"\sum_{i=1}^{N} (-m) = k"),
    (r"a^b(T)^k = a^b T^k", "a^b (T)^k = a^b T^k"),
    (r"\left[x^2\right]_{x = 0} = a", r"\left. x^2 \right|_{x = 0} = a"),
    (r"a = 2 b, i = 1, 2, \ldots, n", "a = 2 b"),
    (r"a = b \quad i, k = 1, 2, \ldots, n", "a = b"),
    (r"a = b \quad \textcircled{1} \\ ②\ k = g", "a=b, k=g"),
    (r"a = b \xrightarrow[x]{k = \frac{g}{m}} k = g \leadsto b = m", "a=b, k=g, b=m"),
    (r"\longrightarrow a = b \quad \longrightarrow \quad k = g \quad \longrightarrow", "a=b, k=g"),
    (r"a = b \qquad \text{dove} \quad m = x \text{ e } v = a", "a=b, m=x, v=a"),
    (r"\sum F_x = 0: \quad a - b = 0", r"\sum F_x = 0, a - b = 0"),
    (r"a = \cos^{\frac{3}{2}}(x)", r"a = (\cos x)^{3/2}"),
    (r"a = b, i = 1,2,\dots,2 n \Leftrightarrow k = g", "a=b, k=g"),
    (r"a = b \quad \text{pour } x > k", r"a = b \quad \text{for } x > k"),
]  # fmt: skip


def read(latex):
    """The text of the tree."""
    return to_text(read_latex(latex, NAMES))


@pytest.mark.parametrize(("written", "meant"), SAME)
def test_it_is_read_as_what_it_means(written, meant):
    assert read(written) == read(meant)


@pytest.mark.parametrize("symbol", [s for s, name in NAMES.items() if len(name) > 1])
def test_every_subscript_and_superscript_names(symbol):
    assert read(f"{symbol} = a") == read("a = a").replace("a", to_text(read_latex(symbol, NAMES)), 1)


REFUSED = [
    (r"x = \pm a", "two formulas"),
    (r"x = a + \cdots + b", "dots stand for"),
    (r"x \propto a", "nothing that can be computed"),
    (r"x = \SI{9.8}{m/s^2}", "unit"),
    (r"x = \qty{9.8}{\metre}", "unit"),
    (r"dx = v dt", "Write rates"),
    (r"x = \begin{pmatrix} a & b \\ k & g \end{pmatrix}", "each row"),
    (r"x = k(a, b + g)", "a value of a function"),
    (r"T = \sum_{i=0}^N m", "only a sum over all"),
    (r"a = b \quad \text{(for small angles)}", "a condition"),
    (r"a = b \quad \text{at the start}", "a condition"),
    (r"x = \foo", "newcommand"),
    (r"x \to \infty", "no value"),
    (r"\oint a dx = 0", "one integral"),
    (r"a = b + ^2 v", "a number or symbol is expected"),
    (r"a = 1{,}250 k + 1.25", "decimal mark, or does it group"),
    (r"a = 1{,}250 k + 12.000 g", "decimal mark, or does it group"),
]


@pytest.mark.parametrize(("latex", "told"), REFUSED)
def test_it_is_refused_with_what_to_write(latex, told):
    with pytest.raises(RbpsymError, match=told) as caught:
        read(latex)
    assert caught.value.instead


FORMAL = {  # read whole, without a value
    r"x = a \pm b": "x = a + ±(b)",
    r"\sum_{i=1}^3 m_i v_i = 0": "(m₁v₁ + m₂v₂ + m₃v₃) = 0",
    r"\sum_{i=0}^n i x_i = \sum_{j\neq i}^{N} F_{ij}": "sum(ixᵢ, i = 0, n) = sum(Fᵢⱼ, j ≠ i, N)",
    r"\sum_{i=1}^2 m_{i+1} = M": "sum(mᵢₚₗᵤₛ₁, i = 1, 2) = M",
    r"dU = T dS - p dV": "differential(U) = Tdifferential(S) − pdifferential(V)",
    r"f(x, y+1, 0) = F(\sin v, k) = H(0, k)": "value(f, list(x, y + 1, 0)) = value(F, list(sin v, k)) = value(H, list(0, k))",
    r"\begin{bmatrix} a & b\\ c & k\end{bmatrix} x = 0": "matrix(row(a, b), row(c, k)) x = 0",
    r"F = \begin{cases} a & x > 0 \\ b & \text{otherwise} \end{cases}": "F = cases(row(a, x > 0), row(b, otherwise))",
    r"\boldsymbol{\nabla} \cdot \vec F = -\nabla U": "∇ · F⃗ = −∇U",
    r"\int_C \vec F\cdot d\vec r = 0": "integral(F⃗ · differential(r⃗), C) = 0",
    r"\frac{dU}{dx}\bigg|_{x=a}(x-a) = \left.f\right|_0^1": "dU/dx|_(x = a)(x − a) = between(f, 0, 1)",
    r"{}^N\bar{v}^P = \langle a, b\rangle + \langle v^2\rangle": "v̄_(N,P) = list(a, b) + mean(v²)",
    r"= a + n!": "continued = a + factorial(n)",
    r"\lim_{\Delta t\to 0} \frac{\Delta p}{\Delta t} = F": "limit(Δp/(Δt), Δt → 0) = F",
    r"c = \tr(U)^2 - \tr(U^2)": "c = raised(value(tr, U), 2) − value(tr, U²)",
    r"x \propto U(x)": "∝(x, value(U, x))",
    r"g_k(t - t_k)^2 = q^i e^{\frac{a}{b}(x)}": "raised(value(gₖ, t − tₖ), 2) = raised(q, i) exp(value(a/b, x))",
    r"\phi([X, Y]) = \frac{\partial f}{\partial x}(a)": "value(ϕ, brackets(X, Y)) = value(∂f/∂x, a)",
    r"\forall x, y \in M, x^{-1} y = f(0) e^0": "     ∀(x, ∈(y, M))\nx⁻¹y = value(f, 0) e⁰",
    r"\{ \begin{pmatrix} a \\ b \end{pmatrix}, c \} = A_{i;j} \to^{P} (a, b)":
        "braces(matrix(row(a), row(b)), c) = A_isemicolonj → list(a, b)",
    r"a = b = ": "a = b = unfinished",
    r"a = b \quad \text{ruotato di } x \text{ nel piano}": "a = b\n  condition(ruotato di x nel piano)",
    r"a = \sum_{i\in A} m_i + f_{j\ne k}": "a = sum(mᵢ, ∈(i, A)) + fⱼₙₑₖ",
    r"L = \SI{2.5}{m/s^2}": "L = measured(5/2, m/s^2)",
    r"L = \SI{-8.3e-5}{m}": "L = measured(−0.000083, m)",
    r"T = F h(\hat y) + \overline{v^2}": "T = F value(h, ŷ) + accented(bar, v²)",
    r"\frac{d}{dt} a b = \sum \frac12 m v^2": "d/dt(several(ab)) = sum(½mv²)",
    r"\vec v = \omega\times\vec r + \int\mathrm{d}^3 r\, k": "v⃗ = crossed(ω, r⃗) + ∫k ddifferential(r, 3)",
    r"\lim_{v<<c} K = \lim_{\delta t\to 0} x": "limit(K, ≪(v, c)) = limit(x, varied(δ, t) → 0)",
    r"U(x) - U(y) = -W(x)": "value(U, x) − value(U, y) = −value(W, x)",
    r"E[X^2] = F(t + \Delta t)": "value(E, X²) = value(F, t + Δt)",
    r"a = \binom{n}{k}": "a = binomial(n, k)",
    r"|\psi\rangle = \langle a|H|b\rangle \ket{b}": r"state(|\psi\rangle) = state(\langle a|H|b\rangle) state(b)",
    r"\left[\frac{dr}{dt}\right]_{S_0} = v": "marked(dr/dt, S0) = v",
    r"a &= b, & c &= k \\ &= g": "        a = b\n        c = k\ncontinued = g",
    r"a = b \quad \text{if $\vec{r}$ is fixed}": "a = b\n  condition(if $\\vec{r}$ is fixed)",
    r"a \gg b << c": "≫(a, ≪(b, c))",
    r"F = \left\{\begin{array}{rl} -A,& t<0\\ A,& t>0\end{array}\right.": "F = cases(row(−A, t < 0), row(A, t > 0))",
    r"\left(\frac{d^2}{dt^2} + k\right) x = \det A": "(d²/dt²(operator) + k) x = detA",
}


@pytest.mark.parametrize("latex", FORMAL)
def test_what_has_no_value_is_read_whole_and_said_where_a_value_is_wanted(latex):
    first, *_ = latex_ways(latex, ANY, whole=True).trees
    assert to_text(first) == FORMAL[latex]
    if "sum_{i=1}^3" not in latex:
        with pytest.raises(RbpsymError) as caught:
            latex_ways(latex, ANY)
        assert caught.value.instead


def test_what_is_upright_or_primed_is_no_product():
    (tree,) = latex_ways(r"v = a^{\prime 2} + 3{\rm\ m/s}", ANY, whole=True).trees
    assert to_text(tree) == "v = a′² + 3 m/s"


@pytest.mark.parametrize(("latex", "told"), [
    (r"^N\bar{v}^{G/O} = a + ^N\bar\omega^C", "v̄_(N,GperO) = a + ω̄_(N,C)"),
])  # fmt: skip
def test_marks_before_and_behind_a_name_are_no_powers(latex, told):
    assert to_text(latex_ways(latex, ANY).trees[0]) == told


@pytest.mark.parametrize(("latex", "told"), [
    (r"a = \omega^2(t) R + r^2(\Delta V)^2", "a = value(ω², t) R + raised(value(r², ΔV), 2)"),
    (r"T = h(\hat k) + x^2(y + z)", "T = value(h, k̂) + value(x², y + z)"),
    (r"Im(z) = Cov(X, y) + f{\left(x \right)}", "value(Im, z) = value(run(C, o, v), list(X, y)) + value(f, x)"),
    (r"mgh(1 - x) = nAve + Re_\tau", "value(run(m, g, h), 1 − x) = run(n, A, v, e) + Re_τ"),
    (r"p = const + \pi(x) + ABC", "p = const + value(π, x) + run(A, B, C)"),
    (r"\hat n \cdot \vec F = m \cdot \vec a", "dotted(n̂, F⃗) = dotted(m, a⃗)"),
    (r"q \cdot c = F \times d + 2 \cdot 3a", "dotted(q, c) = crossed(F, d) + 2 · 3a"),
    (r"g^{22} = O(n) + O(x^2)", "raised(g, 22) = value(O, n) + order(x²)"),
    (r"r!(n - r)! = \overline{u'w'}", "factorial(r) factorial(n − r) = accented(bar, u′w′)"),
    (r"M = \begin{pmatrix} 1\\ & 1\end{pmatrix}", "M = matrix(row(1), row(, 1))"),
    (r"\partial_X^\mu = a", "raised(∂(X), μ) = a"),
    (r"\Delta V(t) = EPE_{\text{in}}", "value(ΔV, t) = run(E, P, Eᵢₙ)"),
    (r"a = b^* \quad\quad c = u^*", "a = bₛₜₐᵣ\nc = uₛₜₐᵣ"),
    (r"\frac{\partial}{\partial x^2} f = \frac{\partial f}{\partial x^2}",
     "differential(f, differential(raised(x, 2))) = differential(f)/differential(raised(x, 2))"),
])  # fmt: skip
def test_of_what_nothing_is_known_no_power_and_no_product_is_said(latex, told):
    assert to_text(latex_ways(latex, ANY, whole=True).trees[0]) == told


@pytest.mark.parametrize("latex", [r"S = \int_0^1 p dq - H dt", r"x = a + f|_0^1", r"x = \int_0^1 r dr~e^{-r^2}"])
def test_how_far_a_sign_reaches_is_not_guessed(latex):
    with pytest.raises(RbpsymError, match=r"belong to the integral|how much of this sum"):
        latex_ways(latex, ANY, whole=True)


@pytest.mark.parametrize("latex", [r"m d = a", r"m d \sin\theta = a", r"\frac{d}{2} = a", r"d^2 = a", r"k d_1 = a"])
def test_a_distance_d_is_no_differential(latex):
    """It is unknown here, and said to be so; bound, it is read."""
    with pytest.raises(RbpsymError, match=r"unknown symbol|a differential alone"):
        read(latex)
    assert "d" in to_text(read_latex(latex, {**NAMES, "d": "d", "d_1": "d_1"}))
