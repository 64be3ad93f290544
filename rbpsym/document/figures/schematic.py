"""From a sketch to the drawing of the whole system."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from rbpsym.document.figures import marks
from rbpsym.document.figures.outlines import body_outline
from rbpsym.document.figures.scaling import scaled
from rbpsym.document.figures.scene import (
    Circle,
    Item,
    Label,
    Line,
    Point,
    Scene,
    box_of,
    direction,
    points_of,
    polar,
)
from rbpsym.document.figures.sketch import (
    AngleMark,
    LengthMark,
    RadiusMark,
    Sketch,
    SketchArrow,
    SketchBody,
    SketchCircle,
    SketchCoil,
    SketchCord,
    SketchLine,
    SketchLink,
    SketchPoint,
)
from rbpsym.document.figures.solid_lines import solid_line
from rbpsym.notation.tree import Sym

WIDTH, HEIGHT = 5.6, 4.4  # the room for the system itself, in cm
ROUND = 1.15  # the greatest radius of a round body
UP, DOWN = math.pi / 2, -math.pi / 2
QUARTER = math.pi / 4


def schematic(sketch: Sketch) -> Scene:
    """The system with its supports, springs, dimensions, angles and axes."""
    sketch = fitted(sketch)
    drawn = [drawn_part(part, sketch) for part in in_order(sketch)]
    scene = sum(drawn, Scene())
    return scene + compass(scene, sketch)


def in_order(sketch: Sketch) -> Iterator[object]:
    """The parts from the back to the front."""
    for name in (
        "circles",
        "lines",
        "cords",
        "links",
        "coils",
        "bodies",
        "points",
        "angles",
        "lengths",
        "radii",
        "arrows",
    ):
        yield from getattr(sketch, name)


def fitted(sketch: Sketch) -> Sketch:
    """The sketch scaled to the room of a figure."""
    left, bottom, right, top = extent(sketch)
    factor = min(WIDTH / max(right - left, 1e-9), HEIGHT / max(top - bottom, 1e-9))
    return scaled(sketch, min(factor, roundest(sketch)))


def roundest(sketch: Sketch) -> float:
    """The factor that draws the largest round body with the greatest radius allowed."""
    radii = [body.sizes.get(key, 0.0) for body in sketch.bodies for key in ("radius", "outer")]
    radii += [part.sizes.get("radius", 0.0) for body in sketch.bodies for part in body.parts]
    radii += [0.3 * body.sizes.get("size", 0.0) for body in sketch.bodies]
    return ROUND / max([*radii, 1e-9])


def extent(sketch: Sketch) -> tuple[float, float, float, float]:
    """The box of bodies, points, links and marks."""
    found = [p for body in sketch.bodies for item in body_outline(body) for p in points_of(item)]
    found += [mark.at for mark in (*sketch.points, *sketch.coils, *sketch.angles)]
    found += [polar(c.at, c.radius, n * UP) for c in sketch.circles for n in range(2 if c.kind == "bowl" else 0, 5)]
    found += [point for cord in sketch.cords for point in cord.points]
    found += [end for link in (*sketch.links, *sketch.lengths) for end in (link.start, link.end)]
    return box_of(tuple(found))


def drawn_part(part: object, sketch: Sketch) -> Scene:
    """The scene of one part."""
    return DRAW[type(part)](part, sketch)


def labelled(content: object, target: Point, toward: float | None = None, **more: object) -> tuple:
    """A label, if there is anything to write."""
    return () if content is None else (Label(content, target, toward, **more),)


def draw_body(body: SketchBody, sketch: Sketch) -> Scene:
    """The outline, the centre of mass of what is not a point, the name."""
    items = body_outline(body)
    mark = () if body.kind == "particle" else marks.dot(body.center)
    side = direction_aside(body, sketch)
    return Scene((*items, *mark), labelled(body.label, body.center, side, gap=0.12))


def direction_aside(body: SketchBody, sketch: Sketch) -> float:
    """Where a body's name stands: beside its axis, upwards, but not where its length stands."""
    left = body.angle + UP
    for mark in sketch.lengths:
        if math.dist(marks.between(mark.start, mark.end, 0.5), body.center) < 0.2:
            return direction(mark.start, mark.end) - math.copysign(UP, free_side(mark, sketch))
    return left if math.sin(left) >= 0 else left + math.pi


def draw_point(point: SketchPoint, sketch: Sketch) -> Scene:
    """A point with the sign of what it does."""
    held = [sketch.body(name).center for name in point.bodies]
    away = marks.away_from(point.at, held) if point.away is None else point.away
    items = POINTS[point.kind](point.at, away)
    return Scene(items, labelled(point.label, point.at, away + math.pi / 3, gap=0.2))


POINTS = {
    "pivot": lambda at, away: (*marks.support(at, away), *marks.joint(at)),
    "weld": marks.clamp,
    "guide": lambda at, away: marks.joint(at),
    "pin": lambda at, away: marks.joint(at),
    "fixed": lambda at, away: marks.dot(at),
    "anchor": marks.anchor,
    "edge": marks.edge,
    "point": lambda at, away: marks.dot(at),
}


def draw_link(link: SketchLink, sketch: Sketch) -> Scene:
    """A spring, damper or string with its label beside the middle."""
    items = marks.LINKS[link.kind](link.start, link.end)
    middle = marks.between(link.start, link.end, 0.5)
    aside = direction(link.start, link.end) + UP
    return Scene(items, labelled(link.label, middle, aside, gap=0.22))


def draw_circle(circle: SketchCircle, sketch: Sketch) -> Scene:
    """A fixed cylinder, a hollow, or a wire."""
    return Scene(CIRCLES[circle.kind](circle.at, circle.radius))


CIRCLES = {
    "convex": lambda at, radius: (Circle(at, radius, "ground"), *marks.dot(at)),
    "concave": lambda at, radius: (*marks.bore(at, radius), *marks.dot(at)),
    "bowl": lambda at, radius: (*marks.bowl(at, radius), *marks.dot(at)),
    "rail": lambda at, radius: (Circle(at, radius, "rail"),),
}


def draw_cord(cord: SketchCord, sketch: Sketch) -> Scene:
    """A string; its length, if it has one, beside its middle."""
    middle = marks.between(cord.points[0], cord.points[1], 0.5)
    aside = direction(cord.points[0], cord.points[1]) + UP
    return Scene((Line(cord.points, "cord"),), labelled(cord.label, middle, aside))


def draw_arrow(arrow: SketchArrow, sketch: Sketch) -> Scene:
    """What acts, or how it moves at first."""
    style, color, length = ARROWS[arrow.kind]
    angle = math.atan2(arrow.direction[1], arrow.direction[0])
    if arrow.kind in ("spin", "couple"):
        arc = marks.turning(arrow.at, 1 if arrow.direction[0] > 0 else -1, 0.5, style)
        return Scene((arc,), labelled(arrow.label, arc.at(0.5), UP + QUARTER, gap=0.08, color=color))
    start = arrow.at if arrow.kind != "blow" else polar(arrow.at, length, angle + math.pi)
    tip = polar(start, length, angle)
    heads = "both" if arrow.kind == "driven" else "end"
    item = Line((polar(start, -length, angle) if arrow.kind == "driven" else start, tip), style, heads=heads)
    target = start if arrow.kind == "blow" else tip
    return Scene(
        (item,), labelled(arrow.label, target, angle if target == tip else angle + math.pi, gap=0.08, color=color)
    )


ARROWS = {
    "force": ("force", "force", 0.95),
    "couple": ("couple", "force", 0.0),
    "blow": ("force", "force", 0.8),
    "velocity": ("velocity", "motion", 0.95),
    "spin": ("velocity", "motion", 0.0),
    "driven": ("velocity", "motion", 0.45),
}


def draw_coil(part: SketchCoil, sketch: Sketch) -> Scene:
    """A torsion spring."""
    return Scene(marks.coil(part.at), labelled(part.label, part.at, QUARTER, gap=0.35))


def draw_line(line: SketchLine, sketch: Sketch) -> Scene:
    """A solid edge, hatched on its solid side."""
    found = solid_line(line, sketch, extent(sketch))
    if found is None:
        return Scene()
    start, end = found
    if line.kind == "rail":
        return Scene((Line((start, end), "rail"),))
    target = marks.between(start, end, 0.85, -0.25)
    toward = direction(start, end) - UP
    return Scene(marks.hatching(start, end), labelled(line.label, target, toward))


def draw_angle(mark: AngleMark, sketch: Sketch) -> Scene:
    """An arc with its label at the middle; smaller angles get larger arcs."""
    turn = abs(mark.end - mark.start)
    radius = min(1.5, max(0.55, 0.5 / max(turn, 0.1)))
    radius = max(radius, mark.reach + 0.25) if mark.reach else radius
    items = marks.angle_arc(mark.at, mark.start, mark.end, radius)
    items += (Line((mark.at, polar(mark.at, radius + 0.1, mark.end)), "guide"),) if mark.reach else ()
    items += (Line((mark.at, polar(mark.at, mark.ray, mark.end)), "guide"),) if mark.ray else ()
    middle = (mark.start + mark.end) / 2
    target = polar(mark.at, radius, middle)
    return Scene(items, labelled(mark.label, target, middle, gap=0.06, color="accent"))


def draw_length(mark: LengthMark, sketch: Sketch) -> Scene:
    """A dimension on the side where fewer bodies are; along one line they stand behind each other."""
    aside = free_side(mark, sketch) * (0.38 + 0.42 * ranks(sketch.lengths)[mark])
    items = marks.dimension(mark.start, mark.end, aside)
    middle = marks.between(mark.start, mark.end, 0.5, aside)
    toward = direction(mark.start, mark.end) + math.copysign(UP, aside)
    return Scene(items, labelled(mark.label, middle, toward, gap=0.05))


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
    return Scene(items, labelled(mark.label, middle, angle + UP, gap=0.04))


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


DRAW = {
    SketchBody: draw_body,
    SketchPoint: draw_point,
    SketchLink: draw_link,
    SketchCoil: draw_coil,
    SketchLine: draw_line,
    SketchCircle: draw_circle,
    SketchCord: draw_cord,
    SketchArrow: draw_arrow,
    AngleMark: draw_angle,
    LengthMark: draw_length,
    RadiusMark: draw_radius,
}


def compass(scene: Scene, sketch: Sketch) -> Scene:
    """Axes, the positive sense of rotation and the direction of gravity, right of the drawing."""
    _, bottom, right, top = scene.bounds
    corner = (right + 0.75, bottom + 0.25)
    return axes(corner) + gravity(sketch, (right + 1.1, max(top - 0.1, bottom + 2.6)))


def axes(at: Point) -> Scene:
    """Small axes with the positive sense of rotation between them."""
    east, north = (at[0] + 0.8, at[1]), (at[0], at[1] + 0.8)
    items: tuple[Item, ...] = (
        marks.arrow(at, east, "axis"),
        marks.arrow(at, north, "axis"),
        replace(marks.turning(at, 1, 0.42), start=0.18, end=UP - 0.1),
    )
    labels = (
        Label(Sym("x"), east, 0.0, 0.06, "soft"),
        Label(Sym("y"), north, UP, 0.04, "soft"),
        Label("+", polar(at, 0.42, QUARTER), QUARTER, 0.02, "soft"),
    )
    return Scene(items, labels)


def gravity(sketch: Sketch, at: Point) -> Scene:
    """The arrow of gravity, from `at`."""
    if sketch.gravity is None or sketch.gravity_label is None:
        return Scene()
    end = polar(at, 0.8, math.atan2(sketch.gravity[1], sketch.gravity[0]))
    label = Label(sketch.gravity_label, marks.between(at, end, 0.5), 0.0, 0.1)
    return Scene((Line((at, end), "line", heads="end"),), (label,))
