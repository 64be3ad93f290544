"""How names are drawn."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rbpsym.expr.glyphs import Glyph, Notation, glyph, notation_for
from rbpsym.expr.tree import Deriv, Sym, Vec
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.text import to_text
from tests.expr.printers import PRINTERS

DRAWN = {
    "theta": (r"\theta", "θ"),
    "theta_0": (r"\theta_0", "θ₀"),
    "ell": (r"\ell", "ℓ"),
    "lambda": (r"\lambda", "λ"),
    "phi": (r"\phi", "ϕ"),
    "varphi": (r"\varphi", "φ"),
    "N_w": ("N_w", "N_w"),
    "I_rod": (r"I_{\mathrm{rod}}", "I_rod"),
    "I_cm": (r"I_{\mathrm{cm}}", "I_cm"),
    "theta_dot": (r"\dot{\theta}", "θ̇"),
    "theta_ddot": (r"\ddot{\theta}", "θ̈"),
    "theta_1_dot": (r"\dot{\theta}_1", "θ̇₁"),
    "theta_dot_1": (r"\dot{\theta}_1", "θ̇₁"),
    "V_cm": (r"V_{\mathrm{cm}}", "V_cm"),
    "W_T": ("W_T", "W_T"),
    "W_theta": (r"W_{\theta}", "W_θ"),
    "W_T_N_w": ("W_{T,N_w}", "W_(T,N_w)"),
    "W_theta_N_w": (r"W_{\theta,N_w}", "W_(θ,N_w)"),
    "W_T_f_2": ("W_{T,f_2}", "W_(T,f₂)"),
    "W_f_2": ("W_{f,2}", "W_(f,2)"),
    "W_f_cm": (r"W_{f,\mathrm{cm}}", "W_(f,cm)"),
    "W_T_1": ("W_{T,1}", "W_(T,1)"),
    "L_disk_O": (r"L_{\mathrm{disk},O}", "L_(disk,O)"),
    "vartheta_1": (r"\vartheta_1", "ϑ₁"),
    "cal_W_theta": (r"\mathcal{W}_{\theta}", "𝒲_θ"),
    "cal_w_c": (r"\mathpzc{w}_c", "𝓌_c"),
    "K_rod_rot": (r"K_{\mathrm{rod},\mathrm{rot}}", "K_(rod,rot)"),
    "Delta_x": (r"\Delta x", "Δx"),
    "Delta_E_k": (r"\Delta E_k", "ΔEₖ"),
    "Delta_0": (r"\Delta_0", "Δ₀"),
    "r_prime": ("r'", "r′"),
    "r_cm_prime": (r"r_{\mathrm{cm}}'", "r′_cm"),
    "I_O_prime": ("I_{O'}", "I_(O′)"),
    "F_net": (r"F_{\mathrm{net}}", "Fₙₑₜ"),
    "x1": ("x_1", "x₁"),
    "m12": ("m_{12}", "m₁₂"),
    "N_A_x": ("N_{A,x}", "N_(A,x)"),
    "load": (r"\mathrm{load}", "load"),
    "n_hat": (r"\hat{n}", "n̂"),
    "x_bar": (r"\bar{x}", "x̄"),
}


@pytest.mark.parametrize(("name", "latex", "text"), [(n, *d) for n, d in DRAWN.items()])
def test_a_name_is_drawn(name, latex, text):
    assert (to_latex(Sym(name)), to_text(Sym(name))) == (latex, text)


@given(name=st.from_regex(r"[A-Za-z_][A-Za-z0-9_]{0,12}", fullmatch=True))
@settings(max_examples=200)
def test_any_identifier_prints(name):
    for printer in PRINTERS.values():
        assert printer(Sym(name)).strip()


def test_aliases_draw_one_name_as_another():
    notation = notation_for(["d"], {"theta_dot": "omega", "theta_ddot": "alpha"})
    assert to_latex(Sym("theta_dot"), notation) == r"\omega"
    assert to_latex(Deriv(Sym("theta_dot")), notation) == r"\frac{\mathrm{d}\omega}{\mathrm{d}t}"


def test_vectors_have_an_arrow_or_are_bold():
    assert to_latex(Vec("R_cm")) == r"\vec{R}_{\mathrm{cm}}"
    assert to_latex(Vec("R_cm"), Notation(vector="bold")) == r"\boldsymbol{R}_{\mathrm{cm}}"


def test_glyphs_are_values():
    assert glyph("theta_0") == Glyph("θ", subs=(Glyph("0", "number"),))
