"""What questions tell in the form of a textbook, and what they tell at all: samples of kinds that were refused or open."""

from __future__ import annotations

from functools import cache

import pytest

from rbpsym.ask.asking import answered
from rbpsym.ask.moments import Asked
from rbpsym.notation.text import to_text
from tests.ask.test_answers import asked as of_library
from tests.ask.test_unseen import asked as of_unseen

PROVED = (
    # vectors with values, in limits, and on what they depend
    ("plate-pins", "does acceleration of plate.cm when swinging begins depend on m", ()),
    ("plate-pins", "acceleration of plate.cm when swinging begins with c = b", ("−3g/8", "−3g/8")),
    ("plate-pins", "force A on plate when swinging begins for b << c", ("−3mgb/(4c)", "mg")),
    # all places of rest of one kind
    ("bead-on-turning-hoop", "equilibria of theta", ("arccos(g/(RΩ²))", "−arccos(g/(RΩ²))")),
    ("bead-on-turning-hoop", "unstable equilibrium of theta", ("0", "π")),
    # one of several coordinates that move for themselves
    ("rod-hits-ball-at-bottom", "theta where theta comes to rest in phase hit",
     ("arccos(−3m(1 + e)(3em − 2M − 3m)/(M + 3m)²)",)),
    # conditions at a moment, and on one side of a value
    ("rod-tipping-over-edge", "mu for which it does not slip where theta = pi/6", None),
    ("ball-in-a-loop", "largest h for which theta stays below pi/2", None),
    ("block-and-drum-on-incline", "is acceleration of s positive", None),
    # a sum of known sign is printed as positive
    ("cylinder-on-wedge", "acceleration of X", None),
    ("bead-on-rotating-rod", "r as a function of t", None),
    # values at the end of the question, and before the search
    ("cylinder-on-wedge", "acceleration of X with m = M for small beta", None),
)  # fmt: skip


@cache
def asked(name: str) -> Asked:
    try:
        return of_unseen(name)
    except FileNotFoundError:
        return of_library(name)


@pytest.mark.parametrize(("name", "text", "told"), PROVED)
def test_it_is_told(name: str, text: str, told: tuple[str, ...] | None) -> None:
    found = answered(asked(name), text)
    assert found.verdict.is_proved, found.verdict
    print([to_text(node) for node in found.nodes], [to_text(node) for node in found.valid])
    assert told is None or tuple(map(to_text, found.nodes)) == told
