"""Figures: labels keep clear of each other and of lines; every printer draws every item."""

from __future__ import annotations

import math
import re
from itertools import pairwise
from types import SimpleNamespace as Told

import pytest

from rbpsym.document.notes_figures import describe, describe_free_body
from rbpsym.elements.shapes import SHAPES
from rbpsym.pictures.figures import scene
from rbpsym.pictures.figures.dimensions import solid_line
from rbpsym.pictures.figures.outlines import OUTLINES, OWN
from rbpsym.pictures.figures.scene import COLORS, STYLES, Label, Polyline, Scene
from rbpsym.pictures.figures.schematic import free_body, schematic
from rbpsym.pictures.figures.sketch import Sketch, SketchBody, SketchLine, SketchPart
from rbpsym.pictures.figures.svg import SCALE, label_svg, number, to_svg
from rbpsym.pictures.figures.tikz import to_tikz
from rbpsym.pictures.figures.typst import to_typst_drawing
from tests.document.collisions import collisions
from tests.document.gallery import GALLERY
from tests.document.samples import SKETCHES, ladder, pendulum

ALL = SKETCHES | GALLERY
SCENES = {name: schematic(sketch) for name, sketch in ALL.items()} | {
    f"{name}: {body.name}": free_body(sketch, body.name) for name, sketch in SKETCHES.items() for body in sketch.bodies
}
POSES = [pendulum(n / 5) for n in range(-12, 13)] + [
    ladder(n / 20, spring=spring) for n in range(5, 29) for spring in (False, True)
]


@pytest.mark.parametrize("name", SCENES)
def test_no_label_collides(name: str) -> None:
    assert collisions(scene.placed(SCENES[name])) == []


def test_no_label_lies_on_another_in_any_pose() -> None:
    for sketch in POSES:
        found = collisions(scene.placed(schematic(sketch)))
        assert not [pair for pair in found if isinstance(pair[1], Label)]


def test_a_collision_is_found() -> None:
    line = Polyline(((-1, 0), (1, 0)))
    here = Label("x", (0, 0), place=(0.0, 0.0), size=(0.2, 0.2))
    aside = Label("x", (0, 0), place=(0.0, 0.3), size=(0.2, 0.2))
    assert collisions(Scene((line,), (here,)))
    assert not collisions(Scene((line,), (aside,)))
    assert collisions(Scene((), (here, here)))


@pytest.mark.parametrize(
    ("start", "end", "hit"),
    [
        ((-1, 0), (1, 0), True),
        ((-1, 0.2), (1, 0.2), False),
        ((-1, -1), (1, 1), True),
        ((-1, 0.9), (0.9, -1), True),
        ((-1, 0), (-0.2, 0), False),
        ((0, -1), (0, 1), True),
        ((-0.2, 0.05), (0.05, 0.3), False),
    ],
)
def test_a_stroke_crosses_a_box_or_not(start: tuple, end: tuple, hit: bool) -> None:
    stroke = next(scene.strokes_of(Scene((Polyline((start, end)),))))
    assert scene.crosses(stroke, (-0.1, -0.1, 0.1, 0.1)) is hit


@pytest.mark.parametrize("name", SCENES)
def test_every_printer_draws_every_item_and_label(name: str) -> None:
    scene = SCENES[name]
    svg, tikz, drawing = (print_(scene) for print_ in (to_svg, to_tikz, to_typst_drawing))
    assert svg.count("<foreignObject") == len(scene.labels)
    assert tikz.count(r"\node") == drawing.count("label-at(") == len(scene.labels)
    assert tikz.count(r"\draw") == len(scene.items)
    assert "nan" not in (svg + tikz + drawing).lower().replace("nand", "")


def test_every_shape_of_a_statement_has_an_outline() -> None:
    assert set(SHAPES) - {"composite"} <= set(OUTLINES)


@pytest.mark.parametrize("kind", {**OUTLINES, **OWN})
def test_outlines_use_known_styles(kind: str) -> None:
    sizes = dict.fromkeys(
        ("length", "radius", "inner", "outer", "width", "height", "base", "offset", "right", "top"), 0.5
    )
    sizes |= {"left": -0.5, "bottom": -0.5, "opening": 1.0, "half_width": 0.5, "half_height": 0.3}
    sizes |= {"x_1": 0.0, "y_1": 0.0, "x_2": 1.0, "y_2": 0.0, "x_3": 0.0, "y_3": 1.0}
    body = SketchBody("b", kind, sizes, (1, 1), 0.3)
    scene = schematic(Sketch((body,)))
    assert all(item.style in STYLES for item in scene.items)


def test_a_composite_shows_its_holes_last() -> None:
    hole = SketchPart("disk", {"radius": 0.2}, (0.1, 0), removed=True)
    plate = SketchPart("disk", {"radius": 0.5})
    body = SketchBody("b", "composite", {}, (0, 0), parts=(hole, plate))
    styles = [item.style for item in schematic(Sketch((body,))).items]
    assert styles.index("body") < styles.index("hole")


def test_a_line_is_solid_where_no_body_is() -> None:
    sketch = ladder()
    for line, solid in zip(sketch.lines, ("left", "below"), strict=True):
        (x, y), (u, v) = solid_line(line, sketch, (0, 0, 2, 2))
        right = (v - y, -(u - x))
        assert (right[0] < 0) if solid == "left" else (right[1] < 0)


def test_walls_end_in_their_corner() -> None:
    start, end = solid_line(SketchLine(1, 0, 0), ladder(), (0, 0, 2, 2))
    assert min(start[1], end[1]) == pytest.approx(0)


def test_the_alt_text_names_all_that_is_seen() -> None:
    text = describe(SKETCHES["ladder-with-spring"])
    assert all(word in text for word in ("ladder", "wall", "floor", "spring k", "θ", "counter-clockwise"))
    forces = describe_free_body(SKETCHES["pendulum"], "rod")
    assert "mg pointing down" in forces.replace(" g", "g")


def test_scaling_does_not_change_the_drawing() -> None:
    small, large = (schematic(Sketch((SketchBody("b", "disk", {"radius": r}, (0, 0)),))) for r in (1e-3, 1e3))
    for one, two in zip(small.items, large.items, strict=True):
        assert one.style == two.style
    assert math.isclose(small.items[0].radius, large.items[0].radius)


def luminance(color: str) -> float:
    """The relative luminance of WCAG 2."""
    parts = [int(color[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


@pytest.mark.parametrize("name", sorted(set(COLORS) - {"paper", "body", "ground"}))
@pytest.mark.parametrize("place", [0, 1], ids=["light", "dark"])
def test_what_is_written_or_drawn_stands_out(name: str, place: int) -> None:
    """A contrast of 4.5 to the paper (WCAG AA for text), of 3 to the bodies on which it may lie."""
    one = luminance(COLORS[name][place])
    for under, least in (("paper", 4.5), ("body", 3.0)):
        other = luminance(COLORS[under][place])
        assert (max(one, other) + 0.05) / (min(one, other) + 0.05) >= least, under


def test_curves_differ_by_more_than_their_colour() -> None:
    """Neighbours in a panel have another dash or width; each has its name beside it."""
    looks = [(STYLES[f"curve {k}"].dash, STYLES[f"curve {k}"].width) for k in range(1, 7)]
    assert all(one != other for one, other in pairwise(looks))
    assert STYLES["curve sum"].width > max(width for _, width in looks)


@pytest.mark.parametrize(("length", "written"), [(0.0, "0"), (-0.00001, "0"), (1.0, None), (-1.0, None)])
def test_numbers_of_a_drawing_have_no_needless_signs(length: float, written: str | None) -> None:
    assert number(length) == (written or f"{length * SCALE:g}")


def test_the_box_of_a_label_is_a_little_larger_than_the_label():
    label = Told(box=(1.0, -2.0, 4.0, 3.0), content="A", color="ink")
    drawn = re.findall(r' (x|y|width|height)="([-.\d]+)"', label_svg(label, None))
    size = {name: float(number) / SCALE for name, number in drawn}
    assert size["x"] < 1 and -size["y"] > 3
    assert size["x"] + size["width"] > 4 and -size["y"] - size["height"] < -2
