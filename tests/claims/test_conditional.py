r"""What stands before an arrow, behind “if” or in “for small x” is a condition: a relation is decided where it holds."""

from functools import cache

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.model import Claim, Meaning, Printed, Setting
from rbpsym.claims.run import Worlds

SYMBOLS = {r"\omega": Meaning("speed of theta"), r"\alpha": Meaning("acceleration of theta"), "F": Meaning("F_y")}
PENDULUM = [
    (r"\theta=0 \implies F = Mg+\frac{M\ell}{2}\omega^2", "PROVED"),
    (r"\theta=0 \implies F = 2Mg+\frac{M\ell}{2}\omega^2", "REFUTED"),
    (r"\theta=0,\ \omega=0 \Rightarrow F = Mg", "PROVED"),
    (r"\theta=0 \implies \alpha=0 \implies \ell\alpha=0", "PROVED"),
    (r"\theta=0 \implies \alpha=0 \\ \ell\alpha=0", "REFUTED"),
    (r"\alpha=-\frac{3g}{2\ell}\sin\theta \implies \ell\alpha = -\frac32 g\sin\theta", "PROVED"),
    (r"\alpha=-\frac{g}{\ell}\sin\theta \implies \ell\alpha = -g\sin\theta", "REFUTED"),  # a law is claimed itself
    (r"F = 0 \implies \ell\alpha=g", "UNDECIDED"),
    (r"\sin\theta = 0 \iff \theta = 0", "UNDECIDED"),
    (r"\cos\theta = \cos\theta_0 \impliedby \omega = 0", "UNDECIDED"),  # true of the motion
    (r"\alpha = 0 \impliedby \theta=0", "PROVED"),
    (r"\alpha \approx -\frac{3g}{2\ell}\theta \quad (\theta \ll 1)", "PROVED"),
    (r"\frac1\theta \approx 1+\theta", "UNDECIDED"),
    (r"\theta > 0 \text{ for } 0 < \theta \le 1", "PROVED"),
    (r"\theta > 0 \text{ for } 0 \le \theta \le 1", "REFUTED"),  # at its end it is not
]
DRIVEN = [
    (r"\frac{m}{M+m} \approx \frac mM - \frac{m^2}{M^2} \quad M \gg m", "PROVED"),
    (r"\frac{M}{M+m} \approx 1 - \frac{2m}{M} \quad \text{for small } m", "REFUTED"),
    (r"\frac{M}{M+m} \approx 1 - \frac{m}{M}", "UNDECIDED"),  # nobody says that m is small
    (r"\sqrt{t^2} = t", "PROVED"),  # the time since the start
    (r"\phi \ge 0", "PROVED"),
    (r"r = r_0\cos\Omega t", "REFUTED"),
]


@cache
def checker():
    """One for all, so that a problem is derived once."""
    return Checker(Worlds())


@pytest.mark.parametrize(("problem", "latex", "outcome"), [
    *(("rod-pendulum", *case) for case in PENDULUM), *(("bead-on-rotating-rod", *case) for case in DRIVEN),
])  # fmt: skip
def test_it_is_decided_under_its_condition(problem, latex, outcome):
    own = SYMBOLS if problem == "rod-pendulum" else {"t": Meaning("t")}
    found = checker().check(Claim("c", Setting(problem, problem, symbols=own), Printed(latex)))
    assert found.outcome.name == outcome, found.links
