"""The 41 displayed equations of arXiv:2011.03355 and the names of their symbols."""

from pathlib import Path

NAMES = """
    m M g ell R k theta theta_0 theta_A theta_B omega omega_0 alpha beta E l_0
    E_k E_K E_p L L_rod L_disk r P_cm R_cm V_cm I_cm I_rod I_disk I_0 F_net N_w N_f W
    tau_net tau_cm tau_N vartheta_1 vartheta_2 v_prime r_prime p_prime x_cm y_cm r_p r_i
    cal_W cal_W_T cal_W_theta cal_W_nc cal_w_c cal_w_N cal_w_T cal_w_theta I_O_prime
""".split()

SPELLINGS = {
    r"\vec{F}^{ext}_i": "F_ext_i",
    r"\vec{F}^{ext}(\vec{r})": "F_ext",
    r"\vec{r}_{p'}": "r_p_prime",
    r"C_{pp'}": "C_p",
    r"\mathcal{W}^c_T": "cal_W_T_c",
    r"\mathcal{W}^{nc}_T": "cal_W_T_nc",
    r"\mathcal{W}^c_{\theta}": "cal_W_theta_c",
    r"\mathcal{W}^{nc}_{\theta}": "cal_W_theta_nc",
}


def equations() -> dict[int, str]:
    """The LaTeX of each displayed equation by its number."""
    blocks = Path(__file__).with_name("paper_equations.tex").read_text().split("%% ")[1:]
    return {int(number): body for number, body in (block.split("\n", 1) for block in blocks)}
