"""A motion that may turn round comes behind its start: a list of losses is whole only if nothing can be lost there."""

import re

import pytest

from rbpsym.commands.derive import lines
from rbpsym.derive import derive
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.statement import load_text
from rbpsym.typeset.machine import to_machine

LOOP = """
[parameters]
m = "mass"
R = "length"
g = "acceleration"
omega_0 = "angular speed"
[coordinates.theta]
meaning = "angle"
start = "0"
speed = "omega_0"
range = ["-pi", "pi"]
[bodies.b]
shape = "particle"
mass = "m"
center = ["R*sin(theta)", "-R*cos(theta)"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "b.center"
circle = "O"
radius = "R"
side = "inside"
"""


def test_what_would_be_lost_on_the_way_back_is_lost_on_the_way_there():
    found = Study(load_text(LOOP)).ended
    assert found.complete is True and [loss.force for loss in found.found] == ["N"]


def test_what_may_be_lost_behind_the_start_alone_leaves_the_list_undecided():
    found = Study(load_text(LOOP.replace('"-pi", "pi"', '"-pi", "pi/3"'))).ended
    assert found.complete is None and "turn round" in found.reason


def test_what_leaves_a_balance_may_go_to_either_side():
    top = LOOP.replace("-R*cos(theta)", "R*cos(theta)").replace("inside", "outside").replace("speed", "# speed", 2)
    found = Study(load_text(top.replace('omega_0 = "angular # speed"', ""))).ended
    assert [to_machine(present(loss.at["theta"])) for loss in found.found] == ["acos(2/3)", "-acos(2/3)"]


@pytest.mark.parametrize(("force", "complete"), [("0", False), ("P", True), ("P - m*g", None)])
def test_where_every_place_is_one_of_rest_no_list_is_whole(force, complete):
    found = Study(load_text(PUSHED.replace("FORCE", force))).rest
    assert found.complete is complete and not found.places


PUSHED = """
[parameters]
m = "mass"
g = "acceleration"
P = "force"
[coordinates.x]
dimension = "length"
start = "0"
[bodies.s]
shape = "particle"
mass = "m"
center = ["x", "0"]
[interactions.W]
type = "gravity"
[interactions.F]
type = "force"
on = "s.center"
force = ["FORCE", "0"]
[constraints.N]
type = "guide"
point = "s.center"
line = "y = 0"
"""


def test_forces_of_time_alone_are_called_so():
    driven = PUSHED.replace("FORCE", "P*t").replace('line = "y = 0"', 'line = "y = 0"').replace('"guide"', '"contact"')
    driven = driven.replace('force = ["P*t", "0"]', 'force = ["0", "P*t/T"]').replace('P = "force"', 'P = "force"\nT = "time"')
    assert Study(load_text(driven)).ended.reason == "the forces are functions of the time alone"


def test_a_body_called_by_a_letter_keeps_it_where_a_sentence_begins():
    page = "\n".join(lines(derive(load_text(PUSHED.replace("FORCE", "P")), simulation=False), "full", "all", "en"))
    assert "S is" not in page and not re.search(r"(^|[.:] )S\b", page)
