"""From a sketch to the drawing of the whole system."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from rbpsym.document.figures import marks
from rbpsym.document.figures.dimensions import (
    QUARTER,
    UP,
    draw_angle,
    draw_length,
    draw_radius,
    free_side,
    labelled,
)
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
