"""What is said beside a value is PROVED only where a rule has decided it: each sentence needs its ground."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import ask
from rbpsym.ask.concluded import concluded
from rbpsym.ask.finding import SAID, Finding, doubts, ground
from rbpsym.ask.parameters import finding
from rbpsym.ask.telling import record
from rbpsym.commands.ask import lines
from rbpsym.field.scalar import symbol
from rbpsym.proof.rules import RULES
from rbpsym.statement.loader import load_problem
from rbpsym.studio.api import _told as shown
from tests.library.derived import problem

# a question of each kind, and what would be false of it
FALSE = {
    ("rod-pendulum", "does the period of theta depend on M"): ("yes: “the period” depends on M", "no: “it” depends on M"),
    ("rod-pendulum", "does the period of theta depend on g"): (
        "no: “the period” does not depend on g", "yes: “the period” depends on M",
    ),
    ("rod-pendulum", "is theta = 0 stable"): ("no",),
    ("rod-pendulum", "is theta = pi unstable"): ("no", "yes where this is met"),
    ("sliding-ladder", "does N_f vanish"): ("yes", "yes where this is met"),
    ("sliding-ladder", "does N_w vanish"): ("no", "yes where this is met"),
    ("ball-in-a-loop", "does N vanish"): ("no", "yes"),
    ("ball-in-a-loop", "does N vanish until theta = pi/2"): ("yes", "yes where this is met"),
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
    ("there a contact is lost", "no_change", {"best": ONE - ONE, "names": ()}, {"best": ONE, "names": ()}),
    ("at this m itself it does not hold", "no_change", {"best": ONE - ONE, "names": ()}, {"best": ONE - ONE, "names": ("m",)}),
    ("“v” is the same for every m", "no_change", {"best": ONE, "names": ("m",)}, {"best": ONE, "names": ("M",)}),
    ("m is the only zero of this in its range", "one_zero", {"name": "m"}, {"name": "M"}),
    ("else “it slips” holds for m < b", "holds_for", {"ends": {1: None, -1: ONE}}, {"ends": {1: ONE, -1: ONE}}),
    ("else “it slips” holds for m > b", "holds_for", {"ends": {1: ONE, -1: None}}, {"ends": {1: None, -1: ONE}}),
    ("yes", "equilibrium", {"proved": "unstable", "opposite": True}, {"proved": "open", "opposite": True}),
    ("no", "stays", {"until": ""}, {"until": "N"}),
    ("yes where this is met", "vanishing", {"open": True}, {"open": False}),
    ("“v” grows beyond all bounds, as this", "limit", {"order": -1}, {"order": 1}),
    ("the limit is 0; “v” vanishes as this", "limit", {"order": 1}, {"order": 0}),
    ("no least value is reached: 0 is approached as m goes to 0", "extreme", {"at_end": True}, {"at_end": False}),
    ("only b = a has the same", "vanishes_for", {"places": (ONE,)}, {"places": (ONE, ONE)}),
    ("“v” is negative: its magnitude is meant", "least_on_way", {"holds": True}, {"holds": False}),
]


SWUNG = """
[parameters]
m = "mass"
L = "length"
g = "acceleration"
[coordinates.q]
start = "0"
speed = "omega_0"
range = ["-2*pi", "2*pi"]
[bodies.bob]
shape = "particle"
mass = "m"
center = ["L*sin(q)", "-L*cos(q)"]
[interactions.W]
type = "gravity"
[constraints.T]
type = "KIND"
KEYS
"""
ROD, STRING = ('"link"', "points = [\"O\", \"bob.center\"]"), ('"string"', "path = [\"O\", \"bob.center\"]")


def swung(by: tuple[str, str]) -> str:
    return SWUNG.replace('"KIND"', by[0]).replace("KEYS", by[1])


APPROACHED = "with this omega_0 itself, q = π is approached and never reached"


def test_a_bound_that_is_approached() -> None:
    """The square of the speed and its slope vanish at the place; where one of them does not, the sentence falls."""
    text = "smallest omega_0 for which q reaches pi"
    forward = swung(ROD).replace("[parameters]", '[parameters]\nomega_0 = "angular speed"')
    world, found = finding(Asked(load_problem(forward)), text)
    answer = concluded(world, text, found)
    assert answer.verdict.is_proved and answer.says == APPROACHED
    [first, (rule, data)] = found.grounds
    for spoilt in ({"value": data["value"] + symbol("g")}, {"place": data["place"] / 2}):
        wrong = replace(found, grounds=(first, (rule, {**data, **spoilt})))
        assert not all(check(None, ground(wrong.grounds[1])).is_proved for check in RULES[rule])
    assert not concluded(world, text, replace(found, grounds=(first,))).verdict.is_proved


def test_where_it_may_go_two_ways_there_is_no_else() -> None:
    """Sent to the right the string goes slack under one condition, to the left under another: "else no" is said of none."""
    world, found = finding(Asked(load_problem(swung(STRING))), "does T vanish")
    assert found.says == "yes where this is met" and len(world.study.ended.found) == 2


@pytest.mark.parametrize(("says", "rule", "so", "not_so"), DECIDED)
def test_a_rule_decides_its_words(says: str, rule: str, so: dict, not_so: dict) -> None:
    assert not list(doubts(Finding(says=says, grounds=((rule, so),))))
    assert list(doubts(Finding(says=says, grounds=((rule, not_so),))))
    assert list(doubts(Finding(says=says, grounds=(("another", so),))))


@pytest.mark.parametrize(
    ("name", "question", "is_nearly"),
    [
        ("rod-pendulum", "period of theta", True),
        ("rod-pendulum", "theta_dot where theta = 0", False),  # no ≈ on its way
        ("torsion-pendulum", "period of theta", False),  # the law is linear for any size
    ],
)
def test_what_rests_on_a_nearly_is_told_so_wherever_it_is_shown(name: str, question: str, is_nearly: bool) -> None:
    """The studio and JSON told a period of a pendulum as if it held for all swings."""
    found, told = ask(problem(name), question)[0], "small oscillations"
    kept = record(found)
    assert kept["valid_for"] == (told if is_nearly else None)
    assert (f"    for {told}" in lines(found, kept, None, found.study.problem)) == is_nearly
    assert (told in shown(found)["says"]) == is_nearly
