"""Dimensions and solid lines in a schematic: on the sides where there is room."""

from __future__ import annotations

import math
from typing import Any

from rbpsym.pictures.figures import marks
from rbpsym.pictures.figures.scene import Label, Point, Polyline, Scene, direction, polar
from rbpsym.pictures.figures.sketch import AngleMark, Caption, LengthMark, RadiusMark, Sketch, SketchLine

UP, DOWN = math.pi / 2, -math.pi / 2
QUARTER = math.pi / 4


def labelled(content: Caption, target: Point, toward: float | None = None, **more: Any) -> tuple[Label, ...]:
    """A label, if there is anything to write."""
    return () if content is None else (Label(content, target, toward, **more),)


def draw_angle(mark: AngleMark, sketch: Sketch) -> Scene:
    """An arc with its label at the middle; smaller angles get larger arcs."""
    turn = abs(mark.end - mark.start)
    radius = min(1.5, max(0.55, 0.5 / max(turn, 0.1)))
    radius = max(radius, mark.reach + 0.25) if mark.reach else radius
    items = marks.angle_arc(mark.at, mark.start, mark.end, radius)
    items += (Polyline((mark.at, polar(mark.at, radius + 0.1, mark.end)), "guide"),) if mark.reach else ()
    items += (Polyline((mark.at, polar(mark.at, mark.ray, mark.end)), "guide"),) if mark.ray else ()
    middle = (mark.start + mark.end) / 2
    target = polar(mark.at, radius, middle)
    return Scene(items, labelled(mark.label, target, middle, gap=0.06, color="accent"))


def draw_length(mark: LengthMark, sketch: Sketch) -> Scene:
    """A dimension on the side where fewer bodies are; along one line they stand behind each other."""
    aside = free_side(mark, sketch) * (0.38 + 0.42 * ranks(sketch.lengths)[mark])
    items = marks.dimension(mark.start, mark.end, aside)
    middle = marks.between(mark.start, mark.end, 0.5, aside)
    toward = direction(mark.start, mark.end) + math.copysign(UP, aside)
    return Scene(items, labelled(mark.label, middle, toward, gap=0.05, both=True))


def ranks(lengths: tuple[LengthMark, ...]) -> dict[LengthMark, int]:
    """How many dimensions stand between each one and its line: shorter ones stand nearer."""
    found: dict[LengthMark, int] = {}
    for mark in sorted(lengths, key=lambda mark: math.dist(mark.start, mark.end)):
        taken = {rank for other, rank in found.items() if are_in_line(mark, other)}
        found[mark] = next(rank for rank in range(len(lengths)) if rank not in taken)
    return found


def are_in_line(one: LengthMark, two: LengthMark) -> bool:
    """Do two lengths lie side by side on (nearly) the same line?"""
    way, length = direction(one.start, one.end), math.dist(one.start, one.end)
    spans = []
    for x, y in (two.start, two.end):
        dx, dy = x - one.start[0], y - one.start[1]
        if abs(dy * math.cos(way) - dx * math.sin(way)) > 0.3:
            return False
        spans.append(dx * math.cos(way) + dy * math.sin(way))
    return min(spans) < length - 0.05 and max(spans) > 0.05


def draw_radius(mark: RadiusMark, sketch: Sketch) -> Scene:
    """An arrow to the rim, away from all that meets at the centre."""
    angle = free_direction(mark.at, sketch) if mark.toward is None else mark.toward
    rim = polar(mark.at, mark.radius, angle)
    middle = marks.between(mark.at, rim, 0.6)
    items = (marks.arrow(mark.at, rim, "dimension"),)
    return Scene(items, labelled(mark.label, middle, angle + UP, gap=0.04, both=True))


def free_direction(at: Point, sketch: Sketch) -> float:
    """The direction, of twelve, that is farthest from those to other marked points."""
    points = [point.at for point in sketch.points] + [body.center for body in sketch.bodies]
    taken = [direction(at, point) for point in points if math.dist(at, point) > 1e-6]
    taken += [UP, DOWN]
    taken += [side for mark in sketch.angles if math.dist(mark.at, at) < 1e-6 for side in (mark.start, mark.end)]
    return max(
        (n * math.pi / 6 - QUARTER / 1.5 for n in range(12)),
        key=lambda angle: min(abs(math.remainder(angle - other, math.tau)) for other in taken),
    )


def free_side(mark: LengthMark, sketch: Sketch) -> int:
    """+1 if the left side of a length is the emptier one, else -1."""
    (x, y), (u, v) = mark.start, mark.end
    others = [body.center for body in sketch.bodies] + [point.at for point in sketch.points]
    others += [nearest(line, ((x + u) / 2, (y + v) / 2)) for line in sketch.lines]
    left = sum((u - x) * (q - y) - (v - y) * (p - x) for p, q in others)
    return -1 if left > 1e-9 else 1


def nearest(line: SketchLine, point: Point) -> Point:
    """The point of a line that is nearest to another point."""
    away = (line.a * point[0] + line.b * point[1] - line.c) / (line.a**2 + line.b**2)
    return point[0] - away * line.a, point[1] - away * line.b


# --- walls, floors and inclines: the visible piece of a solid line, and its solid side


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
