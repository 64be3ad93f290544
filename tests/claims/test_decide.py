"""Relations on a problem with what is to be decided, true ones and near misses."""

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.model import Claim, Meaning, Outcome, Printed, Setting
from rbpsym.claims.run import Worlds

PROVED, REFUTED, UNDECIDED, DEFINITION = Outcome.PROVED, Outcome.REFUTED, Outcome.UNDECIDED, Outcome.DEFINITION
LADDER = {
    "M": "M",
    "g": "g",
    r"\ell": "ell",
    r"\theta": "theta",
    r"\theta_0": "theta_0",
    r"\omega": "speed of theta",
    r"\alpha": "acceleration of theta",
    r"\vec{V}": "velocity of ladder.cm",
    r"\vec R": "position of ladder.cm",
    r"\vec N_w": "force N_w on ladder",
    "N_w": "N_w",
    "N_f": "N_f",
    "W_T": "net work on ladder, translational",
    r"W_\theta": "net work on ladder, rotational",
    "E": "energy",
    "U": "energy, up to a constant",
    "C": "a constant",
    r"\vec L": "angular momentum of ladder about O",
    "L_s": "angular momentum of ladder about O, spin",
    "L_o": "angular momentum of ladder about O, orbital",
    "I": "moment of inertia of ladder",
    "I_c": "moment of inertia of ladder about O",
    "K": "kinetic energy of ladder",
    "z": "defined here",
    r"\vec\tau": "net torque on ladder about ladder.cm",
    r"\phi": "minus theta",
    r"\vec p": "linear momentum of ladder",
    "s": "magnitude of velocity of ladder.cm",
    "v_0": "start of speed of theta",
    "q": "unknown",
    "a_x": "x component of acceleration of ladder.cm",
    "P": "rate of kinetic energy of ladder",
    "m_1": "mass of ladder",
}
ROWS = [
    (r"\alpha=-\frac{3g}{4\ell}\cos\theta", PROVED),
    (r"\alpha=-\frac{3g}{4\ell}\sin\theta", REFUTED),
    (r"\alpha=-\frac{3g}{2\ell}\cos\theta", REFUTED),
    (r"\omega^2=\frac{3g}{2\ell}(\sin\theta_0-\sin\theta)", PROVED),
    (r"\omega^2=\frac{3g}{2\ell}\sin\theta_0", REFUTED),
    (r"N_w=\frac34 Mg(3\sin\theta-2\sin\theta_0)\cos\theta", PROVED),
    (r"N_f=\frac{Mg}{4}(1-6\sin\theta\sin\theta_0+9\sin^2\theta)", PROVED),
    (r"N_f=Mg", REFUTED),
    (r"\theta=C\cos(q\theta_0)", UNDECIDED),  # of other constants it may be true
    (r"W_T=\frac12 M V^2", PROVED),
    (r"W_\theta=\frac16 M\ell^2\omega^2", PROVED),
    (r"W_\theta=\frac12 M\ell^2\omega^2", REFUTED),
    (r"W_T+W_\theta=Mg\ell(\sin\theta_0-\sin\theta)", PROVED),
    (r"W_T+W_\theta=\frac23 M\ell^2\omega^2", PROVED),
    (r"W_\theta=\int_{\theta_0}^{\theta}\ell(N_w\sin\theta-N_f\cos\theta)d\theta", PROVED),
    (r"W_\theta=\int_{\theta}^{\theta_0}\ell(N_w\sin\theta-N_f\cos\theta)d\theta", REFUTED),
    (r"W_\theta=-\int_{\theta}^{\theta_0}\ell(N_w\sin\theta-N_f\cos\theta)d\theta", PROVED),
    (r"W_\theta=\int_{0}^{\theta}\ell(N_w\sin\theta-N_f\cos\theta)d\theta", REFUTED),
    (r"\int_{0}^{\theta}\cos\theta d\theta=\sin\theta", PROVED),
    (r"\frac23M\ell^2\omega^2+Mg\ell\sin\theta=E", PROVED),
    (r"\frac23M\ell^2\omega^2+Mg\ell\sin\theta=C", PROVED),
    (r"\frac23M\ell^2\omega^2+Mg\ell\sin\theta=\text{const}", PROVED),
    (r"\frac23M\ell^2\omega^2-Mg\ell\sin\theta=\text{const}", REFUTED),
    (r"\frac23M\ell^2\omega^2+Mg\ell(\sin\theta-1)=U", PROVED),
    (r"\frac43M\ell^2\omega^2+2Mg\ell\sin\theta=U", REFUTED),
    (r"\frac{U}{2}-\frac13M\ell^2\omega^2=\frac12Mg\ell(\sin\theta-1)", PROVED),
    (r"\frac{U}{2}-\frac23M\ell^2\omega^2=\frac12Mg\ell\sin\theta", REFUTED),
    (r"U+E=\frac43M\ell^2\omega^2+2Mg\ell\sin\theta", PROVED),
    (r"U^2=U\left(\frac23M\ell^2\omega^2+Mg\ell\sin\theta\right)", UNDECIDED),
    (r"U>0", UNDECIDED),
    (r"\omega=-\sqrt{\frac{3U}{2M\ell^2}}", UNDECIDED),
    (r"\vec L=\frac23M\ell^2\omega\hat k", PROVED),
    (r"\vec L=\frac43M\ell^2\omega\hat k", REFUTED),
    (r"L_s=-\frac13M\ell^2\omega", PROVED),
    (r"L_o=M\ell^2\omega", PROVED),
    (r"I=\frac{M\ell^2}{3}", PROVED),
    (r"I_c=I+M\ell^2=\frac43M\ell^2", PROVED),
    (r"K=\frac12MV^2+\frac12I\omega^2", PROVED),
    (r"s=\ell|\omega|", PROVED),
    (r"V=\ell\omega", REFUTED),
    (r"v_0=0", PROVED),
    (r"\vec\tau=\ell(N_f\cos\theta-N_w\sin\theta)\hat k", PROVED),
    (r"\vec\tau=\vec 0", Outcome.REFUTED),
    (r"\vec R\cdot\vec V=0", PROVED),
    (r"\vec R\times\vec p=\vec L", REFUTED),
    (r"\frac{d\vec R}{dt}=\vec V", PROVED),
    (r"M\frac{d^2\vec R}{dt^2}=\vec N_w", REFUTED),
    (r"M a_x=N_w", PROVED),
    (r"P=\frac{d}{dt}K", PROVED),
    (r"m_1=M", PROVED),
    (r"m_1=2M", REFUTED),
    (r"\sin\phi=-\sin\theta", PROVED),
    (r"\omega^2>0", REFUTED),
    (r"\omega^2\ge0", PROVED),
    (r"\omega\le0", PROVED),
    (r"\omega\ge0", REFUTED),
    (r"V=\sqrt{\frac{3g\ell}{2}(\sin\theta_0-\sin\theta)}", PROVED),
    (r"V=\sqrt{\frac{3g\ell}{4}(\sin\theta_0-\sin\theta)}", REFUTED),
    (r"V=-\ell\omega", PROVED),
    (r"V=-\sqrt{\frac{3g\ell}{2}(\sin\theta_0-\sin\theta)}", REFUTED),
    (r"\omega=-\sqrt{\frac{3g}{2\ell}(\sin\theta_0-\sin\theta)}", PROVED),
    (r"\omega=\sqrt{\frac{3g}{2\ell}(\sin\theta_0-\sin\theta)}", REFUTED),
    (r"|\omega|=\sqrt{\frac{3g}{2\ell}(\sin\theta_0-\sin\theta)}", PROVED),
    (r"Mg\ell(\sin\theta_0-\sin\theta)\ge0", PROVED),
    (r"\sin\theta_0-\sin\theta\ge\frac12", REFUTED),
    (r"\sin\theta>\frac12", REFUTED),
    (r"I>0", PROVED),
    (r"I<I_c", PROVED),
    (r"\alpha<0", PROVED),
    (r"N_w>0", REFUTED),
    (r"\sin\theta\approx\theta", PROVED),
    (r"\sin\theta\approx2\theta", REFUTED),
    (r"\cos\theta\approx\theta", REFUTED),
    (r"W_\theta\ne0", PROVED),
    (r"z=M\ell", DEFINITION),
    (r"z=z+1", Outcome.NOT_COMPUTED),
    (r"q=1", REFUTED),
    (r"M=V_w", Outcome.UNREAD),
    (r"\vec V=M", Outcome.NOT_COMPUTED),
    (r"\theta\to0", Outcome.NOT_COMPUTED),
]


def decided(latex, depth=""):
    setting = Setting("ladder", "sliding-ladder", symbols={key: Meaning(value) for key, value in LADDER.items()})
    claim = Claim("a", setting, Printed(latex), holds=depth)
    return Checker(WORLDS).check_safely(claim)


WORLDS = Worlds()


@pytest.mark.parametrize(("latex", "wanted"), ROWS, ids=[row[0] for row in ROWS])
def test_a_relation_is_decided(latex, wanted):
    result = decided(latex)
    assert result.outcome is wanted, (result.detail, result.links)
    if wanted is REFUTED:
        assert any("left = " in link.detail for link in result.links)


@pytest.mark.parametrize(
    ("latex", "depth", "wanted"),
    [
        (r"\alpha=-\frac{3g}{4\ell}\cos\theta", "identity", False),
        (r"\alpha=-\frac{3g}{4\ell}\cos\theta", "motion", True),
        (r"\omega^2=\frac{3g}{2\ell}(\sin\theta_0-\sin\theta)", "motion", True),
        (r"\vec R\cdot\vec V=0", "identity", True),
    ],
)
def test_a_claim_may_ask_for_more(latex, depth, wanted):
    assert (decided(latex, depth).outcome is PROVED) is wanted


def test_what_one_claim_defines_the_next_may_use():
    checker = Checker(WORLDS)
    setting = Setting("ladder", "sliding-ladder", symbols={key: Meaning(value) for key, value in LADDER.items()})
    first, second = (
        Claim("a", setting, Printed(latex)) for latex in (r"z=2\ell\cos\theta", r"z^2=4\ell^2-4\ell^2\sin^2\theta")
    )
    assert [checker.check(claim).outcome for claim in (first, second)] == [DEFINITION, PROVED]


LAWLESS = [
    (r"\frac{dN_w}{dt}=0", REFUTED), (r"N_w=n_0", REFUTED), (r"\frac{d\alpha}{dt}=0", REFUTED),
    (r"\alpha=\alpha_0", REFUTED),
    (r"N_w=\text{const}", REFUTED),
    (r"\frac{dN_f}{dt}=\frac{Mg}{2}(9\sin\theta-3\sin\theta_0)\omega\cos\theta", PROVED),
    (r"\int_{\theta_0}^{\theta}N_w d\theta=N_w(\theta-\theta_0)", REFUTED), (r"\frac{d^3\theta}{dt^3}=0", REFUTED),
]  # fmt: skip
THEORY = [
    (r"\vec F=\text{const}", UNDECIDED), (r"\frac{d\vec F}{dt}=0", UNDECIDED), (r"\alpha=\text{const}", UNDECIDED),
    (r"\int_{\theta_0}^{\theta}\tau d\theta=\tau(\theta-\theta_0)", UNDECIDED), (r"\vec F=M\vec A", PROVED),
    (r"\vec V=\text{const}", REFUTED), (r"M=\text{const}", PROVED), (r"\frac{d\theta}{dt}=\omega", PROVED),
]  # fmt: skip


@pytest.mark.parametrize(("latex", "wanted"), LAWLESS, ids=[row[0] for row in LAWLESS])
def test_unknown_forces_and_accelerations_are_never_taken_for_constants(latex, wanted):
    more = {"n_0": "start of N_w", r"\alpha_0": "start of acceleration of theta"}
    symbols = {key: Meaning(value) for key, value in {**LADDER, **more}.items()}
    claim = Claim("a", Setting("lawless", "sliding-ladder", symbols=symbols), Printed(latex))
    assert Checker(WORLDS).check(claim).outcome is wanted


@pytest.mark.parametrize(("latex", "wanted"), THEORY, ids=[row[0] for row in THEORY])
def test_the_forces_of_the_theory_may_change(latex, wanted):
    symbols = {
        r"\vec F": "net force", "M": "mass", r"\vec A": "acceleration of the centre of mass", r"\theta": "angle",
        r"\vec V": "velocity of the centre of mass", r"\alpha": "angular acceleration", r"\omega": "angular velocity",
        r"\tau": "net torque", r"\theta_0": "start of the angle",
    }  # fmt: skip
    setting = Setting("theory", theory="plane-motion", symbols={key: Meaning(value) for key, value in symbols.items()})
    assert Checker(WORLDS).check(Claim("a", setting, Printed(latex))).outcome is wanted
