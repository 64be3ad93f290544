"""What is said beside a value is PROVED only where a rule has decided it: each sentence needs its ground."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from rbpsym.ask.concluded import concluded
from rbpsym.ask.finding import Finding
from rbpsym.ask.moments import Asked
from rbpsym.ask.parameters import finding
from rbpsym.ask.words import SAID, doubts
from rbpsym.statement.loader import load_problem

# a question of each kind, and what would be false of it
FALSE = {
    ("rod-pendulum", "does the period of theta depend on M"): ("yes: “the period” depends on M", "no: “it” depends on M"),
    ("rod-pendulum", "does the period of theta depend on g"): ("no: “the period” does not depend on g",),
    ("rod-pendulum", "is the energy conserved"): ("no: “energy” changes",),
    ("ball-in-a-loop", "smallest v_0 for which theta reaches pi"): ("every smaller v_0 does: it holds for v_0 < 1", "yes"),
}


@pytest.mark.parametrize(("name", "text"), FALSE)
def test_other_words_are_not_proved(name: str, text: str) -> None:
    world, found = finding(Asked(load_problem(name)), text)
    assert concluded(world, text, found).verdict.is_proved
    for says in FALSE[name, text]:
        for holds in (found.holds, None if found.holds is None else not found.holds):
            assert not concluded(world, text, replace(found, says=says, holds=holds)).verdict.is_proved, (says, holds)
    if found.holds is not None:
        assert not concluded(world, text, replace(found, holds=not found.holds)).verdict.is_proved


def test_words_that_stand_in_no_row_are_doubted() -> None:
    assert list(doubts(Finding(says="it never slips"))) and not list(doubts(Finding()))
    assert all(list(doubts(Finding(says=re.sub(r"[^\w ,:;“”…]", "", words)))) for words in SAID)
