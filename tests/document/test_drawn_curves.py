"""Arcs in SVG, TikZ and Typst pass through the points that the scene has: read back by the definitions of the formats."""

from __future__ import annotations

import math
import re
from xml.etree import ElementTree

import pytest

from rbpsym.pictures.figures.scene import Arc, Circle, Polyline, Scene
from rbpsym.pictures.figures.svg import SCALE, to_svg
from rbpsym.pictures.figures.tikz import to_tikz

ARCS = [
    Arc((0.5, -0.25), 1.5, start, start + sweep)
    for start in (-2.0, 0.0, 0.7, 2.9)
    for sweep in (-5.5, -3.3, -1.2, 0.4, 1.5, 3.0, 4.0, 6.0)
]
NUMBER = r"(-?[\d.]+)"


def svg_points(path: str, count: int = 5) -> list[tuple[float, float]]:
    """Points of “M x,y A r,r 0 large sweep x,y” in scene units, upwards (SVG 2, appendix B.2.4)."""
    x1, y1, r, _, large, sweep, x2, y2 = map(
        float, re.fullmatch(rf"M{NUMBER},{NUMBER} A{NUMBER},{NUMBER} 0 ([01]) ([01]) {NUMBER},{NUMBER}", path).groups()
    )
    hx, hy = (x1 - x2) / 2, (y1 - y2) / 2
    size = math.sqrt(max(0.0, (r * r - hx * hx - hy * hy) / (hx * hx + hy * hy)))
    side = -1 if large == sweep else 1
    cx, cy = (x1 + x2) / 2 + side * size * hy, (y1 + y2) / 2 - side * size * hx
    first, last = math.atan2(y1 - cy, x1 - cx), math.atan2(y2 - cy, x2 - cx)
    turn = (last - first) % (2 * math.pi)
    turn = turn if sweep else turn - 2 * math.pi
    angles = [first + turn * k / (count - 1) for k in range(count)]
    return [((cx + r * math.cos(a)) / SCALE, -(cy + r * math.sin(a)) / SCALE) for a in angles]


@pytest.mark.parametrize("arc", ARCS, ids=lambda arc: f"{arc.start:g} to {arc.end:.2g}")
def test_an_arc_goes_the_way_that_it_is_meant_to(arc):
    root = ElementTree.fromstring(to_svg(Scene((arc,))))
    drawn = svg_points(next(part for part in root.iter() if part.tag.endswith("path")).get("d"))
    meant = [arc.at(k / 4) for k in range(5)]
    for (x, y), (u, v) in zip(drawn, meant, strict=True):
        assert math.hypot(x - u, y - v) < 0.02

    tikz = to_tikz(Scene((arc,)))
    written = rf"\({NUMBER},{NUMBER}\) arc\[start angle={NUMBER}, end angle={NUMBER}, radius={NUMBER}\]"
    x, y, start, end, radius = map(float, re.search(written, tikz).groups())
    center = x - radius * math.cos(math.radians(start)), y - radius * math.sin(math.radians(start))
    for share in (0, 0.3, 1):
        angle = math.radians(start + share * (end - start))
        point = center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)
        assert math.dist(point, arc.at(share)) < 0.01


def heads(scene: Scene) -> list[list[tuple[float, float]]]:
    """The corners of the arrow heads in SVG, the tip first."""
    root = ElementTree.fromstring(to_svg(scene))
    found = [part.get("points") for part in root.iter() if part.tag.endswith("polygon")]
    return [[(float(x) / SCALE, -float(y) / SCALE) for x, y in (p.split(",") for p in text.split())] for text in found]


@pytest.mark.parametrize("arc", ARCS, ids=lambda arc: f"{arc.start:g} to {arc.end:.2g}")
def test_the_head_of_an_arc_is_at_its_end_and_points_ahead(arc):
    [head] = heads(Scene((Arc(arc.center, arc.radius, arc.start, arc.end, heads="end"),)))
    assert math.dist(head[0], arc.at(1)) < 0.02
    before = arc.at(1 - 0.1 / abs(arc.end - arc.start) / arc.radius)
    middle = [sum(values) / len(values) for values in zip(*head[1:], strict=True)]
    way, back = [a - b for a, b in zip(arc.at(1), before, strict=True)], [a - b for a, b in zip(head[0], middle, strict=True)]
    assert (way[0] * back[0] + way[1] * back[1]) / (math.hypot(*way) * math.hypot(*back)) > 0.9


def test_the_heads_of_a_line_point_outward():
    line = Polyline(((0.0, 0.0), (3.0, 1.0)), heads="both")
    last, first = heads(Scene((line,)))
    for head, tip, other in ((last, line.points[1], line.points[0]), (first, line.points[0], line.points[1])):
        assert math.dist(head[0], tip) < 0.02
        assert all(math.dist(corner, other) < math.dist(tip, other) for corner in head[1:])


def test_lines_and_circles_are_where_they_are_meant_to_be():
    root = ElementTree.fromstring(to_svg(Scene((Polyline(((0, 0), (1, 2))), Circle((1, -1), 0.5)))))
    line, circle = (next(p for p in root.iter() if p.tag.endswith(tag)) for tag in ("polyline", "circle"))
    assert line.get("points") == f"0,0 {SCALE:g},{-2 * SCALE:g}"
    assert [float(circle.get(key)) for key in ("cx", "cy", "r")] == [SCALE, SCALE, SCALE / 2]
