"""Near misses: what was meant is found, decided, and told."""

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.diagnosis import diagnosis
from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Claim, Meaning, Outcome, Printed, Setting
from rbpsym.claims.run import Worlds
from rbpsym.frozen import replace
from rbpsym.statement.library import library_folder

FILE = load_claims(library_folder() / "claims" / "paper.toml")
CLAIMS = {claim.id: claim for claim in FILE.claims}
CHECKER = Checker(Worlds(library_folder() / "claims"), diagnosis)
INERTIA = r"\frac{m\ell^2}{3}+M\ell^2+\frac{MR^2}{2}"
ROWS = [
    ("eq-12", rf"\alpha=\frac{{g\ell(\frac m2+M)}}{{{INERTIA}}}\sin\theta", "sign"),
    ("eq-12", rf"\alpha=-\frac{{g\ell(\frac m2+M)}}{{{INERTIA}}}\cos\theta", "sin in place of cos"),
    ("eq-12", r"\alpha=-\frac{g\ell(\frac m2+M)}{\frac{m\ell^2}{3}+M\ell^2}\sin\theta", "term MR²/2 is missing"),
    ("eq-12", rf"\alpha=-\frac{{g\ell(m+M)}}{{{INERTIA}}}\sin\theta", "factor 1/2"),
    ("eq-12", r"\alpha=-\frac{g\ell(\frac m2+M)}{\frac{m\ell^2}{3}+M\ell+\frac{MR^2}{2}}\sin\theta", "exponent of ℓ"),
    ("eq-12", r"\alpha=-\frac{g\ell(\frac M2+m)}{\frac{M\ell^2}{3}+m\ell^2+\frac{mR^2}{2}}\sin\theta", "exchanged"),
    ("eq-22", rf"\alpha=-\frac{{g\ell(\frac m2+M)}}{{{INERTIA}}}\sin\theta", "is too much"),
    ("eq-34", r"\alpha=-\frac{3g}{2\ell}\cos\theta", "4 in place of 2"),
    ("eq-34", r"\alpha=-\frac{4\ell}{3g}\cos\theta", "upside down"),
    ("eq-31", r"\mathpzc{w}_c=\frac16M\ell^2\omega^2", "sign"),
    ("eq-30", r"\mathcal{W}_{\theta}=\int_{\theta_0}^\theta d\theta\,\ell(N_w\sin\theta+N_f\cos\theta)", "sign of N_f"),
    ("eq-19", r"\vec L_{disk}=\frac{MR^2}{2}\vec\beta", "it holds about disk.cm"),
    ("eq-6", r"\vec\tau_{net}=\vec R_{cm}\times\vec F_{net}", "I_cm α⃗ is missing"),
    ("eq-33", r"\frac12M\ell^2\omega^2+Mg\ell\sin\theta=E", "factor 4/3"),
    ("eq-37", r"\mathpzc{w}_T=-k\ell^2(\sin\theta-\cos\theta_0)^2", "cos in place of sin"),
    ("velocity-of-cm", r"\vec V_{cm}=\vec R_{cm}\times\vec\omega", "order of the vector product"),
    ("eq-11", r"\vec\tau_{net}=-g(\frac{m\ell}{2}+MR)\sin\theta\hat k", "in place of R"),
]


@pytest.mark.parametrize(("name", "latex", "words"), ROWS, ids=[f"{row[0]}: {row[2]}" for row in ROWS])
def test_a_near_miss_is_named(name, latex, words):
    claim = CLAIMS[name]
    found = CHECKER.check(
        claim if claim.right is None else type(claim)(claim.id, claim.setting, claim.printed), Printed(latex)
    )
    assert found.outcome is Outcome.REFUTED
    assert words in found.diagnosis


@pytest.mark.parametrize(
    ("latex", "told"),
    [
        (r"\alpha = -\frac{3g}{2\ell}\theta", r"in fact it holds to first order in θ: write \approx"),
        (r"V = \frac12 Mg\ell(1-\cos\theta)", "is V the potential energy, up to a constant?"),
        (r"V = -Mg\ell\cos\theta", "factor"),
        (r"V = \frac12 Mg(\ell-\ell\cos\theta)", "is V the potential energy, up to a constant?"),
        (r"V = -\frac12 Mg\ell\sin(\theta)", "cos in place of sin"),
    ],
)
def test_what_is_true_if_it_is_said_otherwise_is_no_near_miss(latex, told):
    symbols = {r"\alpha": Meaning("acceleration of theta"), "V": Meaning("potential energy")}
    checker = Checker(Worlds(), diagnosis)
    found = checker.check(Claim("c", Setting("s", "rod-pendulum", symbols=symbols), Printed(latex)))
    assert found.outcome is Outcome.REFUTED and told in found.diagnosis


def test_no_repair_makes_both_sides_vanish():
    """No (ℓ − x)² with x = ℓ, and no a + b = b."""
    symbols = {"L": Meaning("Lagrangian, up to a constant"), "x": Meaning("ell"), "r": Meaning("ell")}
    printed = Printed(r"\frac{d}{dt}\frac{\partial L}{\partial\ddot\theta} = M r^2\dot\theta")
    found = Checker(Worlds(), diagnosis).check(Claim("c", Setting("s", "rod-pendulum", symbols=symbols), printed))
    assert (found.outcome, found.fix, found.diagnosis) == (Outcome.REFUTED, "", "")


def test_what_is_far_off_is_told_what_it_is():
    found = CHECKER.check(CLAIMS["eq-34"], Printed(r"\alpha=\frac{g^3}{\ell^5}\cos^3\theta\sin\theta"))
    assert found.outcome is Outcome.REFUTED and found.diagnosis == "in fact α is −(3g/(4ℓ)) cos θ"


@pytest.mark.parametrize(
    ("file", "name", "latex", "told"),
    [
        ("cart-and-rod", "small-oscillations", r"\Omega^2 = \frac{6(M)g}{(4M+m)\ell}", "term m is missing"),  # under a root
        ("bar-in-two-slots", "work-of-the-weight", r"U_W = -\frac{1}{2}mgb(1)", "term −cos θ is missing"),  # a work carried out
        ("disk-off-center", "equation-of-motion", r"\left(\frac{1}{2}R^2+d^2\right)\ddot\theta = 0", "dg sin θ is missing"),
        ("paper", "wall-works-cancel", r"\mathpzc{w}_1 = 0", "missing"),
        ("disk-with-spring", "energy", r"E = \frac{3}{4} m v^2", "term kx²/2 is missing"),  # whatever the constant
        ("disk-with-spring", "energy", r"E = \frac{1}{4} m v^2 + \frac{1}{2} k x^2", "3 in place of 1"),
        ("bead-on-rotating-rod", "jacobi-integral", r"\frac{1}{2}m(\dot r^2 - r^2\omega) = C_0", "exponent of ω"),
        ("cart-pulled-over-pulley", "kinetic-energy",
         r"K = P \left(\sqrt{x_1^2 + h^2} - \sqrt{x_2^2}\right)", "term h² is missing"),
        ("planet-wheel", "energy",
         r"K = \frac{1}{2}\left(\frac{M}{3}+\frac{3m}{2}\right)(R+r)\omega^2", "of R + r"),
        ("metronome", "frequency", r"\omega_0^2 = \frac{(m_2a-m_2b)g}{m_1a^2+m_2b^2}", "m₁ in place of m₂"),
    ],
)
def test_the_missing_term_is_told_and_never_what_makes_it_empty(file, name, latex, told):
    """No (θ̈ − α) = 0 and no I = I, which hold always."""
    claims = load_claims(library_folder() / "claims" / f"{file}.toml").claims
    claim = next(claim for claim in claims if claim.id == name)
    found = CHECKER.check(claim, Printed(latex))
    assert found.outcome is Outcome.REFUTED
    assert told in found.links[-1].diagnosis, found.links
    assert CHECKER.check(claim, Printed(found.fix)).outcome is Outcome.PROVED


@pytest.mark.parametrize(
    ("file", "name", "latex", "fix"),
    [
        ("rod-struck-off-center", "point-at-rest", r"v_c - \omega\frac{\ell^3}{12 b} = 0",
         r"v_c - \omega\frac{\ell^2}{12 b} = 0"),
        ("rod-dropped-on-rough-floor", "spin", r"\omega' = -\frac{3 v}{2 \ell} \cos2\beta",
         r"\omega' = -\frac{3 v}{2 \ell} \cos\beta"),
        ("ball-off-sphere", "leaves", r"\frac12 \theta_1 = \arccos\frac{10}{17}", r"\theta_1 = \arccos\frac{10}{17}"),
        ("cylinder-in-truck", "spin", r"2 \alpha = \frac{A}{2 R}", r"\alpha = \frac{A}{2 R}"),
        ("bead-on-rotating-rod", "power", r"P = \omega", r"P = \omega  C"),  # not Ω = ω, two names of one rate
        ("block-on-table", "weight", r"m_2 g = m_2 a", r"m_2 g = m_2 a + T_2"),  # not m₂ ẍ = m₂ a
        ("rod-caught-at-end", "energy-lost", r"Q = \frac{3}{4} Q", r"Q = \frac{3}{4} K_0"),  # not Q = 4 Q/4
        ("bullet-in-a-rod", "loss", r"Q = \frac{1}{2}mv_0^2-\frac{1}{2}(I_O+md^2)Q^2",
         r"Q = \frac{1}{2}mv_0^2-\frac{1}{2}(I_O+md^2)\omega_1^2"),  # of another moment
        ("kater-pendulum", "second-period", r"T_B = 2\pi\sqrt{\frac{k^2 }{g l_B}}",
         r"T_B = 2\pi\sqrt{\frac{k^2 + l_B^2 }{g l_B}}"),
        ("stepped-pulley", "first-tension", r"S = m_1 ( - R\alpha)", r"S = m_1 ( g - R\alpha)"),
        ("cylinder-in-cylinder", "speed-of-the-centre", r"V^2 = \dot{\phi}^2 (R )^2", r"V^2 = \dot{\phi}^2 (R - a )^2"),
        ("disk-with-spring", "equation-of-motion", r"\frac{3}{2} m a + k x + k x = 0", r"\frac{3}{2} m a + k x = 0"),
        ("metronome", "inertia", r"I_O = m_1+m_2b^2", r"I_O = m_1 a^2+m_2b^2"),
        ("ball-slipping-to-rolling", "angular-acceleration", r"\alpha = \frac{5\mu g}{2 g }", r"\alpha = \frac{5\mu g}{2 b }"),
        ("ball-and-hinged-rod", "ball", r"v = v\frac{m b^2 - e I}{m b^2 + I}", r"v = v_0\frac{m b^2 - e I}{m b^2 + I}"),
        ("slider-crank", "piston-turns-back", r"v = 6", "v = 0"),
        ("ball-on-incline", "coefficient", r"\frac{F}{N} = \frac{2}{7} \tan\beta^\circ", r"\frac{F}{N} = \frac{2}{7} \tan\beta"),
        ("ring-with-bob", "period", r"T = 2\pi\sqrt{\frac{2R}{}}", r"T = 2\pi\sqrt{\frac{2R}{g}}"),
        ("rod-over-corner", "about-the-center", r"N(d-\frac{\ell}{2}) - N_f\frac{\ell}{2}\cos2\theta = \frac{1}{12}M\ell^2\alpha",
         r"N(d-\frac{\ell}{2}) - N_f\frac{\ell}{2}\cos\theta = \frac{1}{12}M\ell^2\alpha"),  # without a value where θ = 0
        ("scotch-yoke", "work", r"(I+MR^2\sin^2)\omega^2 = 2T\theta", r"(I+MR^2\sin^2\theta)\omega^2 = 2T\theta"),
    ],
)  # fmt: skip
def test_what_the_author_wrote_is_restored(file, name, latex, fix):
    claims = load_claims(library_folder() / "claims" / f"{file}.toml").claims
    claim = next(claim for claim in claims if claim.id == name)
    found = CHECKER.check_safely(replace(claim, printed=Printed(latex)))
    assert found.outcome in (Outcome.REFUTED, Outcome.UNREAD)
    assert [link.fix for link in found.links if link.fix] == [fix], found.links
