"""Plots: every curve is the formula of a step, the axes have honest units, the drawings are complete."""

from __future__ import annotations

import math
import re
from functools import cache
from itertools import pairwise

import pytest
from click.testing import CliRunner

import rbpsym
from rbpsym.cli import main
from rbpsym.derive import derive
from rbpsym.document.model import FigureBlock, Math, parts
from rbpsym.document.notes import notation_of, notes
from rbpsym.document.notes_plots import FEW, plot_figures, plots_section
from rbpsym.document.words import Words
from rbpsym.document.writers import writer
from rbpsym.errors import NotApplicable
from rbpsym.expr import tree as t
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.friction import slips
from rbpsym.mechanics.numbers import number
from rbpsym.pictures.figures.scene import placed
from rbpsym.pictures.plots.axes import axis, round_step, written
from rbpsym.pictures.plots.following import REASONS, giving_way, motion
from rbpsym.pictures.plots.panel import scene
from rbpsym.pictures.plots.scales import scales, told_numbers
from rbpsym.pictures.plots.subjects import changes, energies, forces, positions, speeds, works
from rbpsym.quantities import DIMENSIONS, ENERGY, FORCE, TIME
from rbpsym.statement.loader import load_text
from tests.ask.test_unseen import HERE
from tests.document.collisions import collisions
from tests.library.derived import unsimulated

PLAIN = """
title = "Pendulum"
[parameters]
M = "mass: of the rod"
ell = "length: of the rod"
g = "acceleration: gravity"
[coordinates.theta]
meaning = "angle from the downward vertical"
start = "theta_0"
[bodies.rod]
shape = "rod"
mass = "M"
length = "ell"
angle = "theta - pi/2"
[interactions.W]
type = "gravity"
[constraints.F]
type = "pivot"
point = "rod.start"
at = "O"
"""


@cache
def derived(name: str):
    return unsimulated(name) if name else rbpsym.derive(load_text(PLAIN), simulation=False)


@cache
def moving(name: str):
    return motion(derived(name))


RULES = ("work_done", "kinetic_energy", "potential")
NAMES = ("sliding-ladder", "disk-with-spring", "rod-and-disk-free", "")
by_name = pytest.mark.parametrize("name", NAMES)


def panels(name: str):
    found = moving(name)
    return [panel for make in (works, energies, speeds, forces, positions) for panel in make(found)]


@by_name
def test_every_curve_is_the_formula_of_a_step(name: str) -> None:
    found, seen = moving(name), 0
    shown = [s for s in derived(name).steps if s.rule in RULES or s.phrase == "contact.along"]
    steps = {step.statement.items[0]: step for step in shown}
    for make in (works, energies, forces):
        for panel in make(found):
            way = found.real
            for curve in panel.curves:
                if curve.name not in steps or curve.style == "curve sum":
                    continue
                value = scalar(steps[curve.name].statement.items[-1])
                near = 1e-9 if make is not works else 1e-4 * max(map(abs, curve.values)) * panel.up_scale.size
                [leg] = way.legs
                for k in range(0, len(leg.moments), max(1, len(leg.moments) // 7)):
                    shown = curve.values[k] * panel.up_scale.size
                    assert shown == pytest.approx(number(value, leg.at(k)), rel=1e-9, abs=near)
                    seen += 1
    assert seen > 10


@by_name
def test_the_energy_stays_and_the_speed_is_that_of_the_first_integral(name: str) -> None:
    found = moving(name)
    energy = sum(derived(name).study.kinetic) + derived(name).study.potential
    values = found.whole.values(energy)
    size = max(abs(value) for value in found.whole.values(derived(name).study.kinetic[0])) or 1.0
    assert max(values) - min(values) < 1e-4 * size
    for coordinate, square in derived(name).study.squares.items():
        [leg] = found.way.legs
        for k in range(0, len(leg.moments), max(1, len(leg.moments) // 9)):
            speed = leg.at(k)[f"{coordinate}_dot"]
            assert speed**2 == pytest.approx(number(square, leg.at(k)), rel=1e-3, abs=1e-4 * max(1, speed**2))


@by_name
def test_the_work_of_all_forces_is_the_gain_of_kinetic_energy(name: str) -> None:
    found = moving(name)
    whole = [0.0] * len(found.real.times)
    for panel in works(found):
        for curve in panel.curves:
            if curve.style != "curve sum":
                whole = [a + b * panel.up_scale.size for a, b in zip(whole, curve.values, strict=True)]
    kinetic = found.real.values(sum(derived(name).study.kinetic[1:], derived(name).study.kinetic[0]))
    for work, value in zip(whole, kinetic, strict=True):
        assert work == pytest.approx(value - kinetic[0], abs=2e-3 * max(map(abs, kinetic)))


def test_the_loss_is_where_the_derivation_says() -> None:
    found = moving("sliding-ladder")
    [panel] = forces(found)
    [mark] = panel.marks
    at = number(derived("sliding-ladder").study.losses[0].at["theta"], found.scales.numbers)
    assert mark.place * panel.across_scale.size == pytest.approx(at, abs=1e-6)
    assert found.loss[1] == "N_w"
    assert len(found.real.times) < len(found.way.times)


def test_the_small_oscillation_has_the_derived_frequency() -> None:
    found = moving("")
    square = number(derived("").study.equilibria[0].frequencies_squared[0], found.scales.numbers)
    scale = next(positions(found)).up_scale
    [panel] = positions(found, "linear")
    small = next(curve for curve in panel.curves if curve.style == "curve thin")
    period = 2 * math.pi / math.sqrt(square)
    [leg] = found.whole.legs
    start = leg.at(0)["theta"] / scale.size
    for time, value in zip(found.whole.times, small.values, strict=True):
        assert value == pytest.approx(start * math.cos(2 * math.pi * time / period), abs=1e-4 * start)
    assert leg.times[leg.turns[1]] > period  # the large swing is slower


def test_numbers_of_the_author_have_units_and_generic_ones_are_groups() -> None:
    real, generic = scales(derived("sliding-ladder").study), scales(derived("").study)
    assert real.of(ENERGY).node == t.Word("J")
    assert real.numbers["M"] == 10
    assert generic.of(ENERGY).node == t.mul(t.Sym("M"), t.Sym("g"), t.Sym("ell"))
    assert generic.of(FORCE).node == t.mul(t.Sym("M"), t.Sym("g"))
    assert generic.of(TIME).node == t.Sqrt(t.div(t.Sym("ell"), t.Sym("g")))
    assert generic.of(DIMENSIONS["angular speed"]).node == t.Sqrt(t.div(t.Sym("g"), t.Sym("ell")))
    numbers = generic.numbers
    assert generic.of(TIME).size == pytest.approx(math.sqrt(numbers["ell"] / numbers["g"]))


def test_a_system_without_a_start_has_no_plots_and_the_notes_say_why() -> None:
    found = rbpsym.derive(load_text(PLAIN.replace('start = "theta_0"\n', "")), simulation=False)
    with pytest.raises(NotApplicable, match=REASONS["no_start"]):
        motion(found)
    for language, said in (("en", "where each coordinate starts"), ("es", "dónde empieza cada coordenada")):
        [paragraph] = plots_section(found, Words(language, found.study.problem), 1).blocks
        assert said in "".join(getattr(part, "text", "") for part in paragraph.inlines)


def test_statics_has_no_motion() -> None:
    result = CliRunner().invoke(main, ["plot", "ladder-in-equilibrium"])
    assert result.exit_code == 2
    assert "can't be drawn: nothing moves" in result.output


def test_what_rests_at_an_unstable_place_is_pushed() -> None:
    problem = load_text(PLAIN.replace('start = "theta_0"', 'start = "pi"'))
    found = motion(rbpsym.derive(problem, simulation=False))
    [leg] = found.whole.legs
    assert leg.at(0)["theta"] != math.pi
    assert max(abs(leg.numbers["theta"] - math.pi)) > 1


@by_name
def test_drawings_are_inside_their_frame_and_ticks_do_not_touch(name: str) -> None:
    for panel in panels(name):
        drawing = placed(scene(panel, notation_of(derived(name))), notation_of(derived(name)))
        boxes = [label.box for label in drawing.labels]
        overlaps = [pair for pair in collisions(drawing) if hasattr(pair[1], "content")]
        assert not overlaps, [(a.content, b.content) for a, b in overlaps]
        left, bottom, right, top = drawing.bounds
        assert all(left <= box[0] and box[2] <= right and bottom <= box[1] and box[3] <= top for box in boxes)
        assert right - left < 9


@pytest.mark.parametrize("values", [(0, 1), (-3.2, 7), (0, 1e-4), (5, 5), (0, 123456), (math.nan, 2, 3)])
def test_axes_hold_their_values_and_have_round_ticks(values: tuple) -> None:
    found = axis(values, 4.0)
    known = [value for value in values if math.isfinite(value)]
    assert found.low <= min(known) and max(known) <= found.high
    assert 2 <= len(found.ticks) <= 9
    assert all(b > a for a, b in pairwise(found.ticks))
    assert len(set(found.texts)) == len(found.texts)


def test_numbers_of_ticks_are_written_as_in_print() -> None:
    assert written(-1234.5, 1, ",") == "−1\u2009234,5"
    assert written(-0.0001, 2, ".") == "0.00"
    assert round_step(0.3) == 0.5
    assert round_step(22, degrees=True) == 30


def test_the_notes_have_the_plots_only_if_they_are_wanted() -> None:
    plain, drawn = notes(derived("sliding-ladder")), notes(derived("sliding-ladder"), plots=True)
    labels = {section.label for section in drawn.sections} - {section.label for section in plain.sections}
    assert labels == {"section.plots"}
    figures = [p for p in parts(drawn.sections) if isinstance(p, FigureBlock) and p.label.startswith("figure.")]
    assert {f.label for f in figures} >= {"figure.system", "figure.works"}
    for figure in figures[1:]:
        assert re.search("A plot over .* from .* to .*", figure.alt)
        assert re.search(" (stays at|rises from|falls from|varies between) ", figure.alt)
        assert "capital" not in figure.alt and "e−" not in figure.alt
    section = plots_section(derived("sliding-ladder"), Words("en", derived("sliding-ladder").study.problem), 1)
    told = [part.node for part in parts(section) if isinstance(part, Math)]
    assert t.equation(t.Sym("M"), t.Word("10 kg")) in told
    for name in ("tex", "typ", "html", "md", "docx", "ipynb", "beamer", "pdf"):
        assert writer(name)(drawn)


def test_plots_are_files(tmp_path) -> None:
    result = CliRunner().invoke(main, ["plot", "sliding-ladder", "--format", "svg,pdf,png", "-o", str(tmp_path)])
    assert result.exit_code == 0, result.output
    names = {path.name for path in tmp_path.iterdir()}
    parts_ = ("works", "energies", "positions")
    assert names == {f"sliding-ladder-{part}.{kind}" for part in parts_ for kind in ("svg", "pdf", "png")}


@pytest.mark.parametrize("language", ["en", "es"])
def test_a_listener_hears_how_each_curve_goes(language) -> None:
    """The energy of a conservative motion stays; no number has figures that no one hears out."""
    drawn = notes(derived("sliding-ladder"), language, "full", plots=True)
    [alt] = [p.alt for p in parts(drawn.sections) if isinstance(p, FigureBlock) and p.label == "figure.energies"]
    assert {"en": "E stays at 184.", "es": "E se mantiene en 184."}[language] in alt
    assert {"en": "U_W falls from 184 to 123.", "es": "U_W baja de 184 a 123."}[language] in alt


def test_the_axis_of_works_and_energies_says_what_it_counts():
    derivation = unsimulated("sliding-ladder")
    found = plot_figures(motion(derivation), Words("es", derivation.study.problem), FEW)
    drawn = [label for figure in found for scene in figure.scenes for label in scene.labels]
    assert t.Mul((t.Word("trabajo"), t.Word("/ J"))) in [label.content for label in drawn]


@pytest.mark.parametrize("name", ["block-on-rough-spring", "block-on-rough-wedge", "rod-strikes-puck", "sled-up-and-back"])
def test_a_motion_is_drawn_as_far_as_it_is_the_stated_one(name: str) -> None:
    """What slips keeps its sense, and at the start no contact pulls."""
    found = motion(derive(load_text((HERE / f"{name}.toml").read_text(encoding="utf-8")), simulation=False))
    for leg in found.whole.legs:
        pushing = [leg.values(value)[:1] for values in giving_way(leg.study).values() for value in values]
        assert all(min(value) > -1e-9 for value in (*map(leg.values, slips(leg.study.system).values()), *pushing))


def test_what_begins_at_once_or_stays_is_not_drawn_and_no_idle_number_told() -> None:
    assert not changes(motion(unsimulated("center-of-percussion"))) and changes(motion(unsimulated("ball-slipping-to-rolling")))
    kater, [panel] = unsimulated("kater-pendulum").study, energies(motion(unsimulated("spool-pulled-at-angle")))
    assert "h_2" not in {name for node in told_numbers(kater.problem, scales(kater)) for name in t.names(node)}
    assert {curve.name for curve in panel.curves}.isdisjoint({t.Sym("U_W"), t.Delta(t.Sym("U_W"))})
