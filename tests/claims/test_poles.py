"""What is claimed of an integral through a pole is refuted, whatever is claimed; a gap that can be filled is no pole."""

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.model import Claim, Meaning, Outcome, Printed, Setting
from rbpsym.claims.run import Worlds

SYMBOLS = {"q": Meaning("theta"), "L": Meaning("ell")}
WORLDS = Worlds()
THROUGH = [
    (r"\int_{-1}^{1}\frac1{\theta^2}d\theta", "-2"),
    (r"\int_0^\pi\frac1{\cos^2\theta}d\theta", "0"),
    (r"\int_{-1}^{2}\frac1{\theta^3}d\theta", r"\frac38"),
    (r"\int_{-1}^{1}\frac1{q^2}dq", "-2"),
    (r"\int_0^{2\pi}\frac1{\cos^2(\theta/2)}d\theta", "0"),
    (r"\int_{-M}^{M}\frac1{L^2}dL", r"-\frac2M"),
]
BESIDE = [
    (r"\int_1^2\frac1{\theta^2}d\theta", r"\frac12"),
    (r"\int_2^1\frac1{\theta^2}d\theta", r"-\frac12"),
    (r"\int_0^{\pi/4}\frac1{\cos^2\theta}d\theta", "1"),
    (r"\int_{-1}^1\frac{\theta^3+\theta}{\theta}d\theta", r"\frac83"),
    (r"\int_0^1\frac{\theta^2}{\theta}d\theta", r"\frac12"),
]


def outcome(latex):
    setting = Setting("s", "rod-pendulum", symbols=SYMBOLS)
    return Checker(WORLDS).check_safely(Claim("c", setting, Printed(latex))).outcome


@pytest.mark.parametrize(("integral", "at_the_ends"), THROUGH)
@pytest.mark.parametrize("relation", ["=", r"\ne", "<", ">"])
def test_nothing_holds_of_an_integral_through_a_pole(integral, at_the_ends, relation):
    assert outcome(f"{integral} {relation} {at_the_ends}") is Outcome.REFUTED


def test_where_a_pole_is_not_excluded_nothing_is_proved():
    assert outcome(r"\int_0^\pi\frac1{1-\sin^2\theta}d\theta = 0") is Outcome.UNDECIDED


@pytest.mark.parametrize(("integral", "value"), BESIDE)
def test_beside_a_pole_it_has_its_value(integral, value):
    assert outcome(f"{integral} = {value}") is Outcome.PROVED
