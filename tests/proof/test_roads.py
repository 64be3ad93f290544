"""The table of roads: each unknown force drops out or stays, and the road of the notes is among them."""

from __future__ import annotations

import pytest

from rbpsym.chapters.methods.balances import plan
from rbpsym.chapters.methods.roads import roads
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
