"""The table of roads: each unknown force drops out or stays, and the road of the notes is among them."""

from __future__ import annotations

import pytest

from rbpsym.chapters.methods.balances import plan, roads
from rbpsym.derive import derive
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text
from tests.library.derived import unsimulated

NAMES = ("atwood-with-massive-pulley", "sliding-ladder", "rod-pendulum", "cart-and-rod", "disk-on-incline", "rod-and-disk-free")


@pytest.mark.parametrize("name", NAMES)
def test_each_road_says_of_all_unknown_forces_whether_they_drop_out(name: str) -> None:
    study = unsimulated(name).study
    found = roads(study)
    for road in found:
        assert sorted((*road.stay, *road.drop)) == sorted(study.system.unknowns)
        assert road.lines >= (1 if road.kind == "energy" else len(study.system.accelerations))
        assert road.first is None or not road.first.unknowns & set(road.drop), "what drops out stands in no line"
    assert any(road.is_taken for road in found) is (plan(study) is not None)
    assert [road.lines for road in found] == sorted(road.lines for road in found)


DRUMS = """
parameters = { M = "mass", m = "mass", R = "length", r = "length", h = "length", g = "acceleration" }
coordinates = { phi = { start = "0" }, psi = { start = "0" }, y = { dimension = "length", start = "0" } }
bodies.upper = { shape = "disk", mass = "M", radius = "R", center = "O", angle = "-phi" }
bodies.lower = { shape = "disk", mass = "m", radius = "r", center = ["R + r", "-h - y"], angle = "-psi" }
interactions.W = { type = "gravity" }
constraints.F = { type = "pivot", point = "upper.center" }
constraints.T = { type = "string", path = ["cw upper", "ccw lower"] }
"""
BEAD = """
parameters = { M = "mass", m = "mass", ell = "length", b = "length < ell" }
coordinates = { theta = { start = "0", speed = "omega_0" }, r = { dimension = "length", start = "b", range = ["0", "ell"] } }
bodies.rod = { shape = "rod", mass = "M", length = "ell", start = "O", angle = "theta" }
bodies.bead = { shape = "particle", mass = "m", center = ["r*cos(theta)", "r*sin(theta)"] }
constraints.F = { type = "pivot", point = "rod.start" }
constraints.N = { type = "guide", point = "bead.center", of = "rod", line = "y = 0" }
"""


def test_three_simple_lines_are_taken_before_two_long_ones() -> None:
    """A drum that falls from a tape on another: each drum about its own centre, and the falling one along its path."""
    found = plan(Study(load_text(DRUMS, "drums")))
    assert [(line.kind, line.label) for line in found.balances] == [("fixed", "O"), ("center", "lower.cm"), ("force", "y")]


def test_a_bead_on_a_turning_rod_is_looked_at_along_the_rod() -> None:
    """No force acts along the rod; what is kept is the angular momentum, no momentum along a direction that turns."""
    derivation = derive(load_text(BEAD, "bead"), simulation=False)
    found = plan(derivation.study)
    assert [(line.kind, line.label) for line in found.balances] == [("force", "with r"), ("fixed", "O")]
    assert not [step for step in derivation.steps if step.id.startswith("kept.with")]
