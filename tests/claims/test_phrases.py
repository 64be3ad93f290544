"""What a symbol may mean: values at the start, at a place, when a phase begins; works, frequencies, friction."""

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.model import Claim, Meaning, Outcome, Printed, Setting
from rbpsym.claims.run import phase_of
from rbpsym.errors import RbpsymError
from tests.claims.worlds import world

PROVED, REFUTED = Outcome.PROVED, Outcome.REFUTED
ROWS = [  # world, phase, {printed: meaning}, formula, outcome
    ("bowling", "", {"t": "time until rolling"}, r"t=\frac{2v_0}{7\mu g}", PROVED),
    ("bowling", "", {"t": "time until rolling"}, r"t=\frac{2v_0}{5\mu g}", REFUTED),
    ("bowling", "", {"d": "x when rolling begins"}, r"d=\frac{12v_0^2}{49\mu g}", PROVED),
    ("bowling", "", {"v_f": "speed of x when rolling begins"}, r"v_f=\frac57 v_0", PROVED),
    ("bowling", "", {"v_f": "speed of x when rolling begins"}, r"v_f=\frac23 v_0", REFUTED),
    ("bowling", "", {"v_f": "speed of x just before rolling"}, r"v_f=\frac57 v_0", PROVED),
    ("bowling", "", {"a": "acceleration of x"}, r"a=-\mu g", PROVED),
    ("bowling", "", {"f": "kinetic energy just before rolling", "i": "start of kinetic energy"}, r"f/i=\frac57", PROVED),
    ("bowling", "", {"E_l": "energy lost when rolling begins"}, "E_l=0", PROVED),
    ("bowling", "rolling", {"a": "acceleration of x"}, "a=0", PROVED),
    ("bowling", "rolling", {"a": "acceleration of x"}, r"a=-\mu g", REFUTED),
    ("bowling", "rolling", {"v": "speed of x", r"\omega": "speed of phi"}, r"v=R\omega", PROVED),
    ("bowling", "rolling", {"v": "speed of x"}, r"v=\frac57v_0", PROVED),
    ("struck", "", {r"\omega": "speed of theta when struck begins"}, r"\omega=\frac{3Jb}{M\ell^2}", PROVED),
    ("struck", "", {"P": "impulse of P_x when struck begins"}, r"P=J\left(\frac{3b}{2\ell}-1\right)", PROVED),
    ("struck", "", {"P": "impulse of P_x when struck begins"}, r"P=J\left(\frac{3b}{2\ell}+1\right)", REFUTED),
    ("struck", "", {"v": "magnitude of velocity of rod.end when struck begins"}, r"v=\frac{3Jb}{M\ell}", PROVED),
    ("pendulum", "", {r"\omega_b": "speed of theta where theta = 0"},
     r"\omega_b^2=\frac{3g}{\ell}(1-\cos\theta_0)", PROVED),
    ("pendulum", "", {"v": "magnitude of velocity of rod.end where theta = 0"},
     r"v=\sqrt{3g\ell(1-\cos\theta_0)}", PROVED),
    ("pendulum", "", {"v": "magnitude of velocity of rod.end where theta = 0"},
     r"v=\sqrt{2g\ell(1-\cos\theta_0)}", REFUTED),
    ("pendulum", "", {"N": "F_y where theta = 0"}, r"N=\frac{mg}{2}(5-3\cos\theta_0)", PROVED),
    ("pendulum", "", {"N": "start of F_x"}, r"N=\frac{3mg}{8}\sin\theta_0\cos\theta_0", REFUTED),
    ("pendulum", "", {"N": "start of F_x"}, r"N=-\frac{3mg}{4}\sin\theta_0\cos\theta_0", PROVED),
    ("pendulum", "", {r"\vec F": "start of force F on rod"},
     r"\vec F=-\frac34 mg\sin\theta_0\cos\theta_0\hat\imath+mg\left(1-\frac34\sin^2\theta_0\right)\hat\jmath", PROVED),
    ("pendulum", "", {"W": "work of W on rod where theta = 0"}, r"W=\frac{mg\ell}{2}(1-\cos\theta_0)", PROVED),
    ("pendulum", "", {"T": "period of theta"}, r"T=2\pi\sqrt{\frac{2\ell}{3g}}", PROVED),
    ("pendulum", "", {"T": "period of theta"}, r"T=2\pi\sqrt{\frac{\ell}{3g}}", REFUTED),
    ("pendulum", "", {"q": "equilibrium of theta"}, "q=0", PROVED),
    ("pendulum", "", {"k": "radius of gyration of rod about O"}, r"k^2=\frac{\ell^2}{3}", PROVED),
    ("pendulum", "", {"L": "Lagrangian"},
     r"L=\frac16m\ell^2\dot\theta^2+\frac12mg\ell\cos\theta", PROVED),
    ("braked", "", {"V": "potential energy", "L": "Lagrangian of W"}, r"L=\frac16m\ell^2\dot\theta^2-V", PROVED),
    ("pendulum", "", {"L": "Lagrangian"},
     r"L=\frac16m\ell^2\omega^2-\frac12mg\ell\cos\theta", REFUTED),
    ("pendulum", "", {"P": "power of W on rod"}, r"P=-\frac12mg\ell\,\omega\sin\theta", PROVED),
    ("pendulum", "", {r"\omega_b": "speed of theta where theta = 0"},
     r"\omega_b=-\sqrt{\frac{3g}{\ell}(1-\cos\theta_0)}", REFUTED),
    ("falling", "", {r"\omega": "speed of theta where theta = pi/2"}, r"\omega=\sqrt{\frac{3g}{\ell}}", PROVED),
    ("incline", "", {"t": "time until s = L"}, "t=1", Outcome.NOT_COMPUTED),
    ("incline", "", {"t": "time until s = R"}, r"t=\sqrt{\frac{3R}{g\sin\beta}}", PROVED),
    ("incline", "", {"v": "speed of s where s = R"}, r"v^2=\frac43gR\sin\beta", PROVED),
    ("incline", "", {"v": "speed of s where phi = 2*pi"}, r"v=\sqrt{\frac{8\pi}{3}gR\sin\beta}", PROVED),
    ("incline", "", {"m": "friction ratio at N"}, r"m=\frac13\tan\beta", PROVED),
    ("incline", "", {"m": "friction coefficient needed at N"}, r"m=\frac13|\tan\beta|", PROVED),
    ("thrown", "", {"h": "s where s comes to rest"}, r"h=\frac{3v_0^2}{4b}", REFUTED),
    ("thrown", "", {"h": "s where s comes to rest"}, r"h=\frac{v_0^2}{2b}", PROVED),
    ("thrown", "", {"T": "time until s = h"}, r"T=\frac{v_0-\sqrt{v_0^2-2bh}}{b}", PROVED),
    ("thrown", "", {"v": "speed of s where s = h"}, r"v=\sqrt{v_0^2-2bh}", PROVED),
    ("twins", "", {r"\omega_1": "lowest frequency of x"}, r"\omega_1=\sqrt{\frac km}", PROVED),
    ("twins", "", {r"\omega_2": "highest frequency of x"}, r"\omega_2=\sqrt{\frac{k+2c}{m}}", PROVED),
    ("twins", "", {r"\omega_2": "lowest frequency of x"}, r"\omega_2=\sqrt{\frac{k+2c}{m}}", REFUTED),
    ("incline", "", {}, r"f=\frac13 Mg\sin\beta", PROVED),
    ("incline", "", {}, r"\ddot s=\frac23g\sin\beta", PROVED),
    ("incline", "", {}, r"\dot s=R\dot\phi", PROVED),
]  # fmt: skip


def decided(name, phase, symbols, latex):
    """The result of one claim about a world of the tests."""
    meanings = {printed: Meaning(phrase) for printed, phrase in symbols.items()}
    setting = Setting("test", problem=name, symbols=meanings, phase=phase)
    checker = Checker(lambda s: phase_of(world(s.problem), s))
    return checker.check(Claim("c", setting, Printed(latex)))


@pytest.mark.parametrize(("name", "phase", "symbols", "latex", "outcome"), ROWS, ids=[f"{r[0]}: {r[3]}" for r in ROWS])
def test_it_is_decided(name, phase, symbols, latex, outcome):
    if outcome is Outcome.NOT_COMPUTED:
        with pytest.raises(RbpsymError):
            decided(name, phase, symbols, latex)
        return
    found = decided(name, phase, symbols, latex)
    assert found.outcome is outcome, found.links


SENTENCES = [
    ("bowling", "speed of x when roling begins", "did you mean “rolling”"),
    ("pendulum", "speed of theta when rolling begins", "no [[phases]]"),
    ("bowling", "impulse of Q when rolling begins", "no impulse “Q”"),
    ("pendulum", "theta where F_x vanishes", "does not vanish"),
    ("pendulum", "time until theta = 0", "not uniform"),
    ("pendulum", "speed of theta where phi = 0", "“phi” is no coordinate"),
    ("pendulum", "friction coefficient needed at F", "static friction does not hold"),
    ("pendulum", "third frequency of theta", "only 1 frequencies"),
    ("twins", "frequency of x", "there are 2 frequencies"),
    ("pendulum", "theta where theta comes to rest", "no single closed form"),
    ("pendulum", "unstable equilibrium of phi", "“phi” is no coordinate"),
    ("pendulum", "velocity of rod.middle", "has no point “middle”"),
    ("bowling", "speed of x where phi = 1", "still depends on"),
    ("twins", "magnitude of frequencies", "this is several values"),
    ("twins", "rate of frequencies", "this is several values"),
    ("pendulum", "velocity of theta relative to rod.cm", "a vector belongs here"),
    ("pendulum", "potential energy of F", "no such potential energy"),
]


@pytest.mark.parametrize(("name", "phrase", "words"), SENTENCES, ids=[row[1] for row in SENTENCES])
def test_a_phrase_that_means_nothing_gets_a_sentence(name, phrase, words):
    with pytest.raises(RbpsymError) as caught:
        world(name).bound(phrase)
    assert words in f"{caught.value.what} {caught.value.instead}"
