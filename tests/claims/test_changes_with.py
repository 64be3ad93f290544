"""What changes as a coordinate does, and what a parameter has a share in, is not held fixed: d/dθ, values there, limits.

Each display once with its diagnosis, as `rbpsym check` decides it.
"""

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.diagnosis import diagnosis
from rbpsym.claims.model import Claim, Meaning, Outcome, Printed, Setting
from rbpsym.claims.run import Worlds

CHECKER = Checker(Worlds(), diagnosis)
SYMBOLS = {
    r"\omega": Meaning("speed of theta"), r"\alpha": Meaning("acceleration of theta"), "K": Meaning("kinetic energy"),
    "E": Meaning("energy"), "I": Meaning("moment of inertia of ladder about ladder.cm"),
    r"\vec v": Meaning("velocity of ladder.cm"),
}  # fmt: skip
TRUE = r"""
\omega\frac{d\omega}{d\theta}=\alpha
\frac{d\omega^2}{d\theta}=2\alpha
\frac{dK}{d\theta}=-Mg\ell\cos\theta
\frac{dE}{d\theta}=0
\frac{\partial K}{\partial\theta}=0
\frac{d\alpha}{d\theta}=\frac{3g}{4\ell}\sin\theta
\frac{\partial\alpha}{\partial\theta}=\frac{3g}{4\ell}\sin\theta
\frac{d\alpha}{dg}=-\frac{3}{4\ell}\cos\theta
\frac{d}{d\theta}\cos\theta=-\sin\theta
\left.\alpha\right|_{\theta=0}=-\frac{3g}{4\ell}
\left.\omega^2\right|_{\theta=0}=\frac{3g}{2\ell}\sin\theta_0
\Big[\tfrac12M\ell^2\dot\theta^2\Big]_{\theta_0}^{\theta}=\tfrac12M\ell^2\dot\theta^2
\lim_{\theta\to0}\omega^2=\frac{3g}{2\ell}\sin\theta_0
\lim_{g\to0}\alpha=0
\lim_{M\to0}N_f=0
\alpha=-\frac{3g}{4\ell}\quad\text{at }\theta=0
\omega^2=\frac{3g}{2\ell}\sin\theta_0\quad\text{for }\theta=0
\alpha=0\quad(\theta=\pi/2)
""".split("\n")[1:-1]
FALSE = r"""
\frac{d\omega}{d\theta}=0
\frac{dK}{d\theta}=0
\frac{dE}{d\theta}=Mg\ell\cos\theta
\frac{d\alpha}{d\theta}=0
\frac{\partial\alpha}{\partial\theta}=0
\frac{dN_w}{d\theta}=0
\frac{d\alpha}{dg}=0
\left.\alpha\right|_{\theta=0}=\alpha
\left.\omega^2\right|_{\theta=0}=\omega^2
\left.\vec v\right|_{\theta=0}=\vec v
\lim_{\theta\to0}\omega^2=\omega^2
\lim_{g\to0}\alpha=\alpha
\alpha=0\quad\text{at }\theta=0
\omega^2=\frac{g}{2\ell}\sin\theta_0\quad\text{for }\theta=0
""".split("\n")[1:-1]


def outcome(latex: str, problem: str = "sliding-ladder", symbols: dict[str, Meaning] = SYMBOLS) -> Outcome:
    return CHECKER.check_safely(Claim("c", Setting("s", problem, symbols=symbols), Printed(latex))).outcome


@pytest.mark.parametrize("latex", TRUE)
def test_it_is_proved(latex: str) -> None:
    assert outcome(latex) is Outcome.PROVED


@pytest.mark.parametrize("latex", FALSE)
def test_it_is_not_proved(latex: str) -> None:
    """It may be true with ∂ in place of d, and is undecided then."""
    assert outcome(latex) in (Outcome.REFUTED, Outcome.UNDECIDED)


def test_what_is_said_of_where_a_force_vanishes_is_not_refuted() -> None:
    latex = r"\sin\theta=\frac23\sin\theta_0\quad\text{for}\quad N_w=0"
    assert outcome(latex) is Outcome.UNDECIDED


def test_what_is_true_of_partial_derivatives_is_not_refuted() -> None:
    assert outcome(r"\frac{dK}{d\theta}=0") is Outcome.UNDECIDED


@pytest.mark.parametrize("integral", [r"\frac1{\theta^2}", r"\frac1{(\theta-1/2)^3}"])
def test_a_pole_is_told_though_a_repair_is_looked_for(integral: str) -> None:
    claim = Claim("c", Setting("s", "rod-pendulum"), Printed(rf"\int_{{-1}}^{{1}}{integral}d\theta=-2"))
    found = CHECKER.check_safely(claim)
    assert found.outcome is Outcome.REFUTED and "pole" in found.links[0].detail
