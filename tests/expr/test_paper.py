"""The paper's 41 displayed equations are read, link by link, and print to what was read."""

import pytest

from rbpsym.expr import tree as t
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.text import to_text
from tests.expr.paper import NAMES, SPELLINGS, equations
from tests.expr.samples import INERTIA, LEVER, ell, g, mul, sin, th

TABLE = symbol_table(NAMES, spellings=SPELLINGS)


def rows(tree):
    return tree.rows if isinstance(tree, t.Relations) else (tree,)


@pytest.mark.parametrize("number", equations())
def test_an_equation_is_read_and_reads_back(number):
    tree = read_latex(equations()[number], TABLE)
    assert all(isinstance(row, t.Chain) for row in rows(tree))
    printed = to_latex(tree)
    assert to_latex(read_latex(printed, [*NAMES, *SPELLINGS.values()])) == printed


def test_all_right_hand_sides_are_read():
    trees = [row for text in equations().values() for row in rows(read_latex(text, TABLE))]
    assert len(equations()) == 41
    assert sum(len(row.ops) for row in trees) == 61


def test_the_equation_of_motion_has_the_tree_of_its_form():
    found = read_latex(equations()[12], TABLE)
    expected = t.Neg(mul(t.Div(mul(g, ell, LEVER), INERTIA), sin(th)))
    assert found == t.equation(t.Sym("alpha"), t.Deriv(th, "t", 2), expected)


READ = {
    4: "𝒲_θ = ∫_(θ_A)^(θ_B) τ⃗ₙₑₜ · k̂ dθ = ΔE_K",
    5: "L⃗ = ∫_Ω r⃗′ × dp⃗′ = ∫_Ω (r⃗ + R⃗_cm) × d/dt(r⃗ + R⃗_cm) dm = R⃗_cm × P⃗_cm + I_cm ω⃗",
    9: "E_K = ½ ∫_Ω v′² dm = ½M V_cm² + ½ I_cm ω²",
    14: "−gℓ(m/2 + M) cos θ + ½(mℓ²/3 + Mℓ² + MR²/2) ω² = E",
    15: "ω(gℓ(m/2 + M) sin θ + (mℓ²/3 + Mℓ² + MR²/2) α) = 0",
    17: "τ⃗ₙₑₜ = −(mgℓ/2) sin θ k̂ − τ⃗_N",
    25: "−(Mgℓ + mgℓ/2) cos θ + ½(Mℓ² + mℓ²/3) ω² = const",
    30: "𝒲_θ = ∫_θ₀^θ ℓ(N_w sin θ − N_f cos θ) dθ = −𝓌_c",
    36: "𝓌_θ = 𝓌_T = ∫_θ₀^θ k(2ℓ cos θ − l₀) ℓ sin θ dθ",
}


@pytest.mark.parametrize("number", READ)
def test_what_was_read(number):
    assert to_text(read_latex(equations()[number], TABLE)) == READ[number]
