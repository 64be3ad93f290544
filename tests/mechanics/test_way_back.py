"""A motion that may turn round comes behind its start: a list of losses is whole only if nothing can be lost there."""

from rbpsym.mechanics.study import Study
from rbpsym.statement import load_text

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
