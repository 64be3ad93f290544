"""The plots of every problem that ships: nothing that applies is missing, no label collides, no curve has corners."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cache

import pytest

from rbpsym.document.notes import notation_of
from rbpsym.mechanics.friction import slips
from rbpsym.pictures.figures.scene import Label, Polyline, placed
from rbpsym.pictures.plots.following import PlottedMotion, motion
from rbpsym.pictures.plots.panel import Panel, scene
from rbpsym.pictures.plots.subjects import energies, forces, positions, speeds, works
from tests.document.collisions import collisions
from tests.library.derived import FILES, FOLLOWED, derived

pytestmark = pytest.mark.heavy(of=6)

MOVING = [name for name in FOLLOWED if "[coordinates" in FILES[name].read_text(encoding="utf-8")]
MAKERS = (works, energies, speeds, forces, lambda moving: positions(moving, "linear"))
by_name = pytest.mark.parametrize("name", MOVING)


@cache
def drawn(name: str) -> tuple[PlottedMotion, tuple[tuple[Panel, ...], ...]]:
    moving = motion(derived(name))
    return moving, tuple(tuple(make(moving)) for make in MAKERS)


@by_name
def test_everything_that_applies_is_drawn(name: str) -> None:
    moving, (worked, stored, quick, pushed, placed_) = drawn(name)
    assert stored
    assert quick
    assert placed_
    systems = [leg.study.system for leg in moving.whole.legs]
    assert bool(pushed) == any(system.unknowns for system in systems)
    rules = {step.rule for step in moving.derivation.steps}
    assert worked or "work_done" not in rules
    shown = {curve.name for panel in pushed for curve in panel.curves}
    unknowns = {n for system in systems for n in system.unknowns}
    assert len(shown) + sum(panel.omitted for panel in pushed) == len(unknowns)
    assert len(moving.whole.legs) == 1 + len(moving.derivation.study.problem.phases)


@by_name
def test_no_label_collides(name: str) -> None:
    moving, groups = drawn(name)
    notation = notation_of(moving.derivation)
    for panel in (panel for panels in groups for panel in panels):
        drawing = placed(scene(panel, notation), notation)
        found = [
            (one.content, other.content if isinstance(other, Label) else other) for one, other in collisions(drawing)
        ]
        assert not found
        assert drawing.bounds[2] - drawing.bounds[0] < 11.5


def turns(points: Sequence[tuple[float, float]]) -> Iterator[tuple[int, float]]:
    """How much a broken line turns at each of its inner points."""
    for place in range(1, len(points) - 1):
        (a, b), (c, d), (e, f) = points[place - 1 : place + 2]
        turn = math.atan2((c - a) * (f - d) - (d - b) * (e - c), (c - a) * (e - c) + (d - b) * (f - d))
        yield place, abs(turn)


@by_name
def test_curves_are_smooth(name: str) -> None:
    """Between pieces of more than a millimetre a curve turns by less than 15°."""
    moving, groups = drawn(name)
    for panel in (panel for panels in groups for panel in panels):
        for item in scene(panel, notation_of(moving.derivation)).items:
            if not isinstance(item, Polyline) or not item.style.startswith("curve"):
                continue
            for place, turn in turns(item.points):
                sizes = [math.dist(*item.points[k : k + 2]) for k in (place - 1, place)]
                assert min(sizes) < 0.1 or turn < math.radians(15), (panel.across, item.style, item.points[place])


@by_name
def test_the_energy_of_a_conservative_motion_stays(name: str) -> None:
    moving, _ = drawn(name)
    for leg in moving.whole.legs:
        if leg.study.first_integral is not None and not leg.study.system.has_clock:
            values = leg.values(leg.study.first_integral)
            size = max(map(abs, leg.values(sum(leg.study.kinetic)))) or 1.0
            assert max(values) - min(values) < 1e-4 * size


@by_name
def test_what_slips_keeps_its_sense_where_it_is_drawn(name: str) -> None:
    moving, _ = drawn(name)
    for leg in moving.whole.legs:
        for slip in map(leg.values, slips(leg.study.system).values()):
            assert min(slip) >= -1e-6 * max(map(abs, slip))
