"""Hostile formulas: a sentence within 0.2 s, and nothing else."""

import random

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.model import Claim, Outcome, Printed
from tests.claims.test_decide import LADDER, ROWS, WORLDS, Meaning, Setting
from tests.effort import MANY, at_most

SETTING = Setting("ladder", "sliding-ladder", symbols={key: Meaning(value) for key, value in LADDER.items()})
HOSTILE = [
    "{" * 3000 + "M" + "}" * 3000 + "=M",
    r"9^{9^{9^9}}=M",
    r"M^{999999999}=M",
    r"M=10^{64}^{64}",
    r"((M^{60})^{60})^{60}=M",
    r"\write18{rm -rf /}=M",
    r"\input{/etc/passwd}=M",
    r"\csname x\endcsname=M",
    r"\catcode`\$=M",
    r"__class__=M",
    r"M.__init__=M",
    r"\text{__import__}=M",
    "M\u200b=M",
    "М=M",
    "M\u0000=M",
    "M=" + "M" * 9000,
    "M=" + "+".join(["M"] * 3000),
    r"\frac" * 500 + "=M",
    r"\sqrt" * 500 + "M=M",
    r"\int_0^1" * 200 + "=M",
    "=",
    "",
    "M=",
    "=M",
    r"M=\frac{1}{0}",
    r"M=\frac{g}{\sin^2\theta+\cos^2\theta-1}",
    r"\frac{d}{dt}" * 30 + r"\sin\theta=M",
    r"(M+g+\ell)^{64}=M",
    r"(M+g+\ell+\theta+\omega)^{40}=M",
    r"\prod_{i} M=M",
    "$M=M$",
    r"\sin\sin\sin\sin\theta=M",
    r"\sqrt{-1}=M",
    r"\ln 0=M",
    r"\arcsin 2=M",
    r"\tan\frac{\pi}{2}=M",
]


def checked(latex):
    with at_most(MANY):
        return Checker(WORLDS).check_safely(Claim("a", SETTING, Printed(latex)))


@pytest.mark.parametrize("latex", HOSTILE, ids=[latex[:24].replace("\0", "0") for latex in HOSTILE])
def test_a_hostile_formula_is_answered(latex):
    checked("M=M")
    assert checked(latex).outcome is not Outcome.PROVED


def test_random_changes_of_formulas_never_crash():
    chance = random.Random(7)
    alphabet = r"\{}^_()[]|&=<>+-*/., dMg0129" + "θω∫"
    for _ in range(600):
        latex = list(chance.choice(ROWS)[0])
        for _ in range(chance.randint(1, 4)):
            place = chance.randrange(len(latex))
            latex[place : place + chance.randint(0, 2)] = chance.choice(alphabet)
        checked("".join(latex))
