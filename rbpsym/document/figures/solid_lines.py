"""Walls, floors and inclines: the visible piece of a solid line, and its solid side."""

from __future__ import annotations

import math

from rbpsym.document.figures.scene import Point
from rbpsym.document.figures.sketch import Sketch, SketchLine

Box = tuple[float, float, float, float]
OVERHANG = 0.8


def solid_line(line: SketchLine, sketch: Sketch, box: Box) -> tuple[Point, Point] | None:
    """The piece of a line near the system, cut at other solid lines; its solid side is right."""
    foot, way = foot_and_way(line, solid_side(line, sketch))
    low, high = -math.inf, math.inf
    for edge in box_edges(box):
        low, high = cut(foot, way, edge, low, high)
    for other in sketch.lines:
        if other is not line and "rail" not in (line.kind, other.kind):
            low, high = cut(foot, way, half_plane(other, sketch), low, high)
    if line.end is not None and line.at is not None:
        (x, y), (u, v) = line.at, line.end
        low, high = cut(foot, way, (u - x, v - y, (u - x) * u + (v - y) * v), low, high)
    if not low < high < math.inf:
        return None
    return along(foot, way, low), along(foot, way, high)


def value(line: SketchLine, point: Point) -> float:
    """a x + b y - c."""
    return line.a * point[0] + line.b * point[1] - line.c


def solid_side(line: SketchLine, sketch: Sketch) -> int:
    """The sign of the side that is solid: given, or where no body is, or below."""
    if line.solid is not None:
        return line.solid
    middle = sum(value(line, body.center) for body in sketch.bodies)
    if abs(middle) > 1e-6:
        return -1 if middle > 0 else 1
    return -1 if (line.b, line.a) > (0, 0) else 1


def foot_and_way(line: SketchLine, solid: int) -> tuple[Point, Point]:
    """A point of the line and the unit vector along it that has the solid side at its right."""
    size = math.hypot(line.a, line.b)
    a, b, c = solid * line.a / size, solid * line.b / size, solid * line.c / size
    return (a * c, b * c), (-b, a)


def half_plane(line: SketchLine, sketch: Sketch) -> tuple[float, float, float]:
    """(a, b, c) with a x + b y <= c on the free side of a line."""
    solid = solid_side(line, sketch)
    return solid * line.a, solid * line.b, solid * line.c


def box_edges(box: Box) -> list[tuple[float, float, float]]:
    """The four half planes of the box with some overhang."""
    left, bottom, right, top = box
    over = OVERHANG
    return [(-1, 0, over - left), (0, -1, over - bottom), (1, 0, right + over), (0, 1, top + over)]


def cut(foot: Point, way: Point, edge: tuple[float, float, float], low: float, high: float) -> tuple[float, float]:
    """The stretch of a line that lies in a half plane."""
    a, b, c = edge
    slope = a * way[0] + b * way[1]
    room = c - a * foot[0] - b * foot[1]
    if abs(slope) < 1e-12:
        return (low, high) if room >= -1e-9 else (0.0, -1.0)
    return (low, min(high, room / slope)) if slope > 0 else (max(low, room / slope), high)


def along(foot: Point, way: Point, distance: float) -> Point:
    """The point of a line at a distance from its foot."""
    return foot[0] + distance * way[0], foot[1] + distance * way[1]
