"""What is said beside a value is PROVED only where a rule has decided it: each sentence needs its ground."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from rbpsym.algebra.scalar import symbol
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


ONE = symbol("a") / symbol("a")
DECIDED = [  # words, the rule, data with which it decides them, data with which it does not
    ("yes", "least_on_way", {"holds": True}, {"holds": False}),
    ("no", "least_on_way", {"holds": True, "opposite": True}, {"holds": True}),
    ("yes where this is met, else no", "least_on_way", {"holds": None}, {"holds": None, "opposite": True}),
    ("no where this is met, else yes", "least_on_way", {"holds": None, "opposite": True}, {"holds": None}),
    ("yes: “L” is conserved", "kept_or_not", {"kept": True}, {"kept": False}),
    ("no: “L” changes", "kept_or_not", {"kept": False}, {"kept": True}),
    ("“it slips” holds for every m in its range", "least_on_way", {"holds": True}, {"holds": False}),
    ("there is no such m: “it slips” holds for none in its range", "least_on_way", {"holds": False}, {"holds": True}),
    ("there is no such m: “it slips” holds for none in its range", "vanishes_for", {"places": ()}, {"places": (ONE,)}),
    ("else there is no such m", "least_on_way", {"holds": False}, {"holds": True}),
    ("every smaller m does: it holds for m < M", "holds_for", {"ends": {1: None, -1: ONE}}, {"ends": {1: ONE, -1: None}}),
    ("every larger m does: it holds for m > M", "holds_for", {"ends": {1: ONE, -1: None}}, {"ends": {1: None, -1: ONE}}),
    ("every such m does", "holds_for", {"opposite": True}, {}),
    ("there a contact is lost", "no_change", {"best": ONE - ONE}, {"best": ONE}),
    ("“v” grows beyond all bounds, as this", "limit", {"order": -1}, {"order": 1}),
    ("the limit is 0; “v” vanishes as this", "limit", {"order": 1}, {"order": 0}),
    ("no least value is reached: 0 is approached as m goes to 0", "extreme", {"at_end": True}, {"at_end": False}),
    ("only b = a has the same", "vanishes_for", {"places": (ONE,)}, {"places": (ONE, ONE)}),
    ("“v” is negative: its magnitude is meant", "least_on_way", {"holds": True}, {"holds": False}),
]


@pytest.mark.parametrize(("says", "rule", "so", "not_so"), DECIDED)
def test_a_rule_decides_its_words(says: str, rule: str, so: dict, not_so: dict) -> None:
    assert not list(doubts(Finding(says=says, grounds=((rule, so),))))
    assert list(doubts(Finding(says=says, grounds=((rule, not_so),))))
    assert list(doubts(Finding(says=says, grounds=(("another", so),))))
