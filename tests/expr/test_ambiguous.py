r"""What can be read in two ways: where nothing is known of the symbols it is marked or refused with its question; with a remark
that says what the symbols are, or in the other spelling, it is read as told.

The places at which a reader chooses: letters side by side (product, name, length), a bracket behind a name, what is raised, a
d, a δ, a slash, the reach of a function, of a derivative, of a sum and of an integral, units, decimal marks, signs.
"""

import pytest

from rbpsym.claims.papers.draft import ANY
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.formal import sentences
from rbpsym.expr.latex.reader import latex_ways, read_latex
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.typeset.text import to_text

SENTENCES = sentences()
D, SLASH, REACH = "is this d a differential, or a symbol?", "is this factor above or below the slash?", "function's argument"
RUN, VALUE, UNIT, RAISED = (SENTENCES[kind][0] for kind in ("run", "value", "spelled", "raised"))
ROWS = [  # what is written, the question, what is written instead ("": the same), the names of its symbols, what is read
    (r"2dn_c = m\lambda", D, "", "d n_c m lambda", "2d n_c = mλ"),
    (r"V = \pi r^2 d h", D, "", "V r d h", "V = πr²dh"),
    (r"x = (b + c)/d e", D, "x = (b + c)/(d e)", "x b c d e", "x = (b + c)/(de)"),
    (r"W = d(a + b)", D, "", "W d a b", "W = d(a + b)"),
    ("DA/OA = x", RUN, "", {"DA": "a", "OA": "b", "x": "x"}, "a/b = x"),
    ("|A_1P - B_1P| = c", RUN, "", {"A_1P": "a", "B_1P": "b", "c": "c"}, "|a − b| = c"),
    ("AB^2 = c", RUN, "", {"AB": "a", "c": "c"}, "a² = c"),
    ("KEx = c", RUN, "", {"KE": "a", "x": "x", "c": "c"}, "ax = c"),
    ("F = MG", RUN, "", "F M G", "F = MG"),
    ("x = mgh(1 + a)", RUN, "", "x m g h a", "x = mgh(1 + a)"),
    ("F = k(x - y)", VALUE, "", "F k x y", "F = k(x − y)"),
    (r"I = \frac{m}{k}(a + b)", VALUE, "", "I m k a b", "I = (m/k)(a + b)"),
    ("E = ab^i", RAISED, "", "E a b i", "E = abⁱ"),
    (r"x = \Delta y^\mu", RAISED, "", "x y mu", "x = (Δy)^μ"),
    ("v = 5 m", UNIT, "", "v m", "v = 5m"),
    ("g = 10 m/s^2", UNIT, "", "g m s", "g = 10m/s²"),
    (r"m\delta x = 0", SENTENCES["varied"][0], "", "m delta x", "mδx = 0"),
    ("[b][v] = x", SENTENCES["unit"][0], "b v = x", "b v x", "bv = x"),
    (r"x = \pm a", SENTENCES["±"][0], "x = -a", "x a", "x = −a"),
    (r"\frac{d}{dt} x y = a", SENTENCES["several"][0], r"\frac{d}{dt}(x y) = a", "x y a", "d/dt(xy) = a"),
    ("a/bc = x", SLASH, "a/(bc) = x", "a b c x", "a/(bc) = x"),
    ("1/2m = x", SLASH, r"\frac12 m = x", "m x", "½m = x"),
    (r"\sin x y = z", REACH, r"\sin(x) y = z", "x y z", "sin(x) y = z"),
    (r"\tan a/2 = z", REACH, r"\tan(a/2) = z", "a z", "tan(a/2) = z"),
    (r"\sin^{-1} x = y", "two ways", r"\arcsin x = y", "x y", "arcsin x = y"),
    (r"\sin x^2 = y", "raised to this power", r"\sin(x^2) = y", "x y", "sin(x²) = y"),
    (r"\sum_i a_i + b_i = x", "does this belong to the sum?", "", "", ""),
    (r"\int f dx g = h", "does this belong to the integral?", r"\int f g dx = h", "f g x h", "∫fg dx = h"),
    (r"\int a dx + b dx = c", "does this belong to the integral?", r"\int (a + b) dx = c", "a b x c", "∫(a + b) dx = c"),
    ("y = 1,5x", "is this a decimal comma", "y = 1.5x", "x y", "y = (3/2)x"),
    ("y = 1{,}500", "does it group thousands?", "y = 1500", "y", "y = 1500"),
    (r"\log x = y", SENTENCES["log"][0], r"\ln x = y", "x y", "ln x = y"),
    (r"a = W \text{ whence } b = c", "do these words part two formulas?", "a = W, b = c", "a W b c", "a = W\nb = c"),
    ("eval_B = c", RUN, "", {"eval_B": "e", "c": "c"}, "e = c"),
    ("x, y = 0", SENTENCES["list"][0], "x = y = 0", "x y", "x = y = 0"),
    (r"v\frac{Dv}{Dr} = a", SENTENCES["material"][0], "", "v D r a", "vDv/(Dr) = a"),
    ("u^{-1} = u^0", RAISED, "", "", ""),
    ("v^{1/2} = u^1", RAISED, "", "", ""),
    ("[D u]^n = x", RAISED, "", "", ""),
    (r"Sol_\phi(h) = x", RUN, "", "", ""),
]  # fmt: skip


def _questions(latex):
    """What is asked of each way of reading it."""
    try:
        found = latex_ways(latex, ANY, whole=True)
    except RbpsymError as error:
        return [error.what]
    formal = ([part for part in t.walk(tree) if isinstance(part, t.Formal) and part.kind in SENTENCES] for tree in found.trees)
    told = found.error.what if found.error else ""
    return [" ".join([*(SENTENCES[part.kind][0] for part in parts), told]) for parts in formal]


@pytest.mark.parametrize(("latex", "question"), [row[:2] for row in ROWS])
def test_what_can_be_read_in_two_ways_is_asked(latex, question):
    assert all(question in asked for asked in _questions(latex))


@pytest.mark.parametrize(("latex", "_", "instead", "names", "told"), [row for row in ROWS if row[4]])
def test_and_is_read_as_told(latex, _, instead, names, told):
    table = symbol_table(names.split() if isinstance(names, str) else names)
    assert to_text(read_latex(instead or latex, table)) == told


@pytest.mark.parametrize(
    ("latex", "told"),
    [
        (r"d = 2r, \quad 2d\theta = x", "d = 2r\n 2dθ = x"),  # the text says that d is a length
        (r"dW = F dx", "differential(W) = Fdifferential(x)"),
        (r"dA = dx dy", "differential(A) = differential(x)differential(y)"),
        (r"W = Fd\cos\theta", "W = Fd cos θ"),
        (r"\frac{d\sigma}{d\cos\theta} = x", "differential(σ)/differential(cos θ) = x"),
        (r"d/dt x = y", "dx/dt = y"),
        (r"\frac{dx dy}{dz} = y", "differential(x)differential(y)/differential(z) = y"),
        (r"a = b_c^d e", "a = raised(b_c, d) e"),
        (r"M\,R^2 = x", "MR² = x"),
        (r"a = b \text{ (damping)} \\ = c", "a = b = c"),
        ("a:b = c:d", "a/b = c/d"),
        ("c^{*2} = s^{\\prime 3}", "cₛₜₐᵣ² = s′³"),
        (r"\underset{\text{drag}}{F} = ma", "F_drag = ma"),
        (r"u = 0,\quad n = 1, \ldots, N_t - 1 \thinspace .", "u = 0"),
        (r"F_{\text{y}} = v_{lim} + u_{réel} + x_{\text{si}}", "F_y = vₗᵢₘ + u_réel + xₛᵢ"),
    ],
)
def test_what_the_text_decides(latex, told):
    found = to_text(latex_ways(latex, ANY, whole=True).trees[0])
    assert " ".join(found.split()) == " ".join(told.split())
