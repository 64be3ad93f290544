"""From a sketch to the drawing of the whole system."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import chain
from typing import Any

from rbpsym.expr.tree import Sym
from rbpsym.pictures.figures import dimensions, marks
from rbpsym.pictures.figures import scene as s
from rbpsym.pictures.figures import sketch as sk
from rbpsym.pictures.figures.dimensions import DOWN, labelled, solid_line
from rbpsym.pictures.figures.outlines import body_outline
from rbpsym.pictures.figures.scene import Label, Point, Scene, box_of, placed, points_of, polar
from rbpsym.pictures.figures.sketch import Sketch, SketchBody, SketchCouple, SketchForce, scaled

WIDTH, HEIGHT = 5.6, 4.4  # the room for the system itself, in cm
ROUND = 1.15  # the greatest radius of a round body


def schematic(sketch: sk.Sketch) -> s.Scene:
    """The system with its supports, springs, dimensions, angles and axes."""
    sketch = fitted(sketch)
    behind = (sketch.circles, sketch.lines, sketch.cords, sketch.links, sketch.coils, sketch.bodies)
    before = (sketch.points, sketch.angles, sketch.lengths, sketch.radii, sketch.arrows)
    scene = sum((DRAW[type(part)](part, sketch) for part in chain(*behind, *before)), s.Scene())
    return scene + compass(scene, sketch)


def fitted(sketch: sk.Sketch) -> sk.Sketch:
    """The sketch scaled to the room of a figure."""
    left, bottom, right, top = extent(sketch)
    factor = min(WIDTH / max(right - left, 1e-9), HEIGHT / max(top - bottom, 1e-9))
    return scaled(sketch, min(factor, roundest(sketch)))


def roundest(sketch: sk.Sketch) -> float:
    """The factor that draws the largest round body with the greatest radius allowed."""
    radii = [body.sizes.get(key, 0.0) for body in sketch.bodies for key in ("radius", "outer")]
    radii += [part.sizes.get("radius", 0.0) for body in sketch.bodies for part in body.parts]
    radii += [0.3 * body.sizes.get("size", 0.0) for body in sketch.bodies]
    return ROUND / max([*radii, 1e-9])


def extent(sketch: sk.Sketch) -> tuple[float, float, float, float]:
    """The box of bodies, points, links and marks."""
    found = [p for body in sketch.bodies for item in body_outline(body) for p in s.points_of(item)]
    marked: list[Any] = [*sketch.points, *sketch.coils, *sketch.angles]
    found += [mark.at for mark in marked]
    found += [
        s.polar(c.at, c.radius, n * dimensions.UP)
        for c in sketch.circles
        for n in range(2 if c.kind == "bowl" else 0, 5)
    ]
    found += [point for cord in sketch.cords for point in cord.points]
    spans: list[Any] = [*sketch.links, *sketch.lengths]
    found += [end for link in spans for end in (link.start, link.end)]
    return s.box_of(tuple(found))


def draw_body(body: sk.SketchBody, sketch: sk.Sketch) -> s.Scene:
    """The outline, the centre of mass of what is not a point, the name."""
    items = body_outline(body)
    mark = () if body.kind == "particle" else marks.dot(body.center)
    side = direction_aside(body, sketch)
    return s.Scene((*items, *mark), dimensions.labelled(body.label, body.center, side, gap=0.12))


def direction_aside(body: sk.SketchBody, sketch: sk.Sketch) -> float:
    """Where a body's name stands: beside its axis, upwards, but not where its length stands."""
    left = body.angle + dimensions.UP
    for mark in sketch.lengths:
        if math.dist(marks.between(mark.start, mark.end, 0.5), body.center) < 0.2:
            return s.direction(mark.start, mark.end) - math.copysign(dimensions.UP, dimensions.free_side(mark, sketch))
    return left if math.sin(left) >= 0 else left + math.pi


def draw_point(point: sk.SketchPoint, sketch: sk.Sketch) -> s.Scene:
    """A point with the sign of what it does."""
    held = [sketch.body(name).center for name in point.bodies]
    away = marks.away_from(point.at, held) if point.away is None else point.away
    items = POINTS[point.kind](point.at, away)
    return s.Scene(items, dimensions.labelled(point.label, point.at, away + math.pi / 3, gap=0.2))


POINTS: Mapping[str, Callable[..., tuple[s.Item, ...]]] = {
    "pivot": lambda at, away: (*marks.support(at, away), *marks.joint(at)),
    "weld": marks.clamp,
    "guide": lambda at, away: marks.joint(at),
    "pin": lambda at, away: marks.joint(at),
    "fixed": lambda at, away: marks.dot(at),
    "anchor": marks.anchor,
    "edge": marks.edge,
    "point": lambda at, away: marks.dot(at),
}


def draw_link(link: sk.SketchLink, sketch: sk.Sketch) -> s.Scene:
    """A spring, damper or string with its label beside the middle."""
    items = marks.LINKS[link.kind](link.start, link.end)
    middle = marks.between(link.start, link.end, 0.5)
    aside = s.direction(link.start, link.end) + dimensions.UP
    return s.Scene(items, dimensions.labelled(link.label, middle, aside, gap=0.22))


CIRCLES: Mapping[str, Callable[..., tuple[s.Item, ...]]] = {
    "convex": lambda at, radius: (s.Circle(at, radius, "ground"), *marks.dot(at)),
    "concave": lambda at, radius: (*marks.bore(at, radius), *marks.dot(at)),
    "bowl": lambda at, radius: (*marks.bowl(at, radius), *marks.dot(at)),
    "rail": lambda at, radius: (s.Circle(at, radius, "rail"),),
}


def draw_cord(cord: sk.SketchCord, sketch: sk.Sketch) -> s.Scene:
    """A string; its length, if it has one, beside its middle."""
    middle = marks.between(cord.points[0], cord.points[1], 0.5)
    aside = s.direction(cord.points[0], cord.points[1]) + dimensions.UP
    line = s.Polyline(cord.points, "rail" if cord.kind == "rail" else "cord")
    return s.Scene((line,), dimensions.labelled(cord.label, middle, aside))


def draw_arrow(arrow: sk.SketchArrow, sketch: sk.Sketch) -> s.Scene:
    """What acts, or how it moves at first."""
    style, color, length = ARROWS[arrow.kind]
    angle = math.atan2(arrow.direction[1], arrow.direction[0])
    if arrow.kind in ("spin", "couple"):
        arc = marks.turning(arrow.at, 1 if arrow.direction[0] > 0 else -1, 0.5, style)
        return s.Scene(
            (arc,),
            dimensions.labelled(arrow.label, arc.at(0.5), dimensions.UP + dimensions.QUARTER, gap=0.08, color=color),
        )
    start = arrow.at if arrow.kind != "blow" else s.polar(arrow.at, length, angle + math.pi)
    tip = s.polar(start, length, angle)
    heads = "both" if arrow.kind == "driven" else "end"
    item = s.Polyline((s.polar(start, -length, angle) if arrow.kind == "driven" else start, tip), style, heads=heads)
    target = start if arrow.kind == "blow" else tip
    return s.Scene(
        (item,),
        dimensions.labelled(arrow.label, target, angle if target == tip else angle + math.pi, gap=0.08, color=color),
    )


ARROWS = {
    "force": ("force", "force", 0.95),
    "couple": ("couple", "force", 0.0),
    "blow": ("force", "force", 0.8),
    "velocity": ("velocity", "motion", 0.95),
    "spin": ("velocity", "motion", 0.0),
    "driven": ("velocity", "motion", 0.45),
}


def draw_line(line: sk.SketchLine, sketch: sk.Sketch) -> s.Scene:
    """A solid edge, hatched on its solid side."""
    found = solid_line(line, sketch, extent(sketch))
    if found is None:
        return s.Scene()
    start, end = found
    if line.kind == "rail":
        return s.Scene((s.Polyline((start, end), "rail"),))
    target = marks.between(start, end, 0.85, -0.25)
    toward = s.direction(start, end) - dimensions.UP
    return s.Scene(marks.hatching(start, end), dimensions.labelled(line.label, target, toward))


DRAW: Mapping[type, Callable[[Any, sk.Sketch], s.Scene]] = {
    sk.SketchBody: draw_body,
    sk.SketchPoint: draw_point,
    sk.SketchLink: draw_link,
    sk.SketchCoil: lambda part, sketch: s.Scene(
        marks.coil(part.at), dimensions.labelled(part.label, part.at, dimensions.QUARTER, gap=0.35)
    ),
    sk.SketchLine: draw_line,
    sk.SketchCircle: lambda circle, sketch: s.Scene(CIRCLES[circle.kind](circle.at, circle.radius)),
    sk.SketchCord: draw_cord,
    sk.SketchArrow: draw_arrow,
    sk.AngleMark: dimensions.draw_angle,
    sk.LengthMark: dimensions.draw_length,
    sk.RadiusMark: dimensions.draw_radius,
}


def compass(scene: s.Scene, sketch: sk.Sketch) -> s.Scene:
    """Axes, the positive sense of rotation and the direction of gravity, right of the drawing."""
    _, bottom, right, top = scene.bounds
    corner = (right + 0.75, bottom + 0.25)
    return axes(corner) + gravity(sketch, (right + 1.1, max(top - 0.1, bottom + 2.6)))


def axes(at: s.Point) -> s.Scene:
    """Small axes with the positive sense of rotation between them."""
    east, north = (at[0] + 0.8, at[1]), (at[0], at[1] + 0.8)
    items: tuple[s.Item, ...] = (
        marks.arrow(at, east, "axis"),
        marks.arrow(at, north, "axis"),
        replace(marks.turning(at, 1, 0.42), start=0.18, end=dimensions.UP - 0.1),
    )
    labels = (
        s.Label(Sym("x"), east, 0.0, 0.06, "soft"),
        s.Label(Sym("y"), north, dimensions.UP, 0.04, "soft"),
        s.Label("+", s.polar(at, 0.42, dimensions.QUARTER), dimensions.QUARTER, 0.02, "soft"),
    )
    return s.Scene(items, labels)


def gravity(sketch: sk.Sketch, at: s.Point) -> s.Scene:
    """The arrow of gravity, from `at`."""
    if sketch.gravity is None or sketch.gravity_label is None:
        return s.Scene()
    end = s.polar(at, 0.8, math.atan2(sketch.gravity[1], sketch.gravity[0]))
    label = s.Label(sketch.gravity_label, marks.between(at, end, 0.5), 0.0, 0.1)
    return s.Scene((s.Polyline((at, end), "line", heads="end"),), (label,))


# --- from a sketch to the free-body diagram of one body: every force at its point


SIZE = 3.2  # the greatest extent of the body, in cm
SHARES = {"rod": 1.0, "composite": 0.75, "rectangle": 0.6, "triangle": 0.6}  # of SIZE; others are round
LENGTH = 1.0  # of each force arrow


def free_body(sketch: Sketch, body_name: str, name: str | None = None, axes_too: bool = True) -> Scene:
    """One body alone, with the forces and couples on it.

    `name` is what stands under it (its own name if None, nothing if ""); the axes with the
    positive sense are drawn if `axes_too`.
    """
    sketch = scaled(sketch, factor(sketch.body(body_name)))
    body = sketch.body(body_name)
    scene = Scene((*body_outline(body), *marks.dot(body.center)))
    scene += sum(map(force_scene, spread([force for force in sketch.forces if force.body == body_name])), Scene())
    scene += sum((couple_scene(couple) for couple in sketch.couples if couple.body == body_name), Scene())
    shown = body.name if name is None else name
    under = heading(scene, shown) if shown else Scene()
    return scene + (sense(scene) if axes_too else Scene()) + under


def factor(body: SketchBody) -> float:
    """What brings a body to the size of a diagram."""
    found = tuple(point for item in body_outline(body) for point in points_of(item))
    left, bottom, right, top = box_of(found)
    extent = max(right - left, top - bottom)
    return SIZE * SHARES.get(body.kind, 0.42) / extent if extent > 1e-9 else 1.0


def spread(forces: list[SketchForce]) -> Iterator[SketchForce]:
    """Forces with the same point and direction stand a little beside each other."""
    seen: list[tuple[Point, float]] = []
    for force in forces:
        angle = math.atan2(force.direction[1], force.direction[0])
        same = sum(math.dist(force.at, at) < 0.05 and abs(angle - a) < 0.05 for at, a in seen)
        seen.append((force.at, angle))
        yield replace(force, at=polar(force.at, 0.22 * same, angle - math.pi / 2))


def force_scene(force: SketchForce) -> Scene:
    """An arrow that starts at the point where the force acts."""
    angle = math.atan2(force.direction[1], force.direction[0])
    tip = polar(force.at, LENGTH, angle)
    items = (*marks.dot(force.at), marks.arrow(force.at, tip))
    return Scene(items, labelled(force.label, tip, angle, gap=0.06, color="force"))


def couple_scene(couple: SketchCouple) -> Scene:
    """An open circle with a head."""
    arc = marks.turning(couple.at, couple.sign, 0.45, "couple")
    target = polar(couple.at, 0.45, math.pi / 2)
    return Scene((arc,), labelled(couple.label, target, math.pi / 2, gap=0.12, color="force"))


def heading(scene: Scene, name: str) -> Scene:
    """The name of the body, under it."""
    left, bottom, right, _ = placed(scene).bounds
    return Scene((), (Label(name, ((left + right) / 2, bottom - 0.05), DOWN, 0.05),))


def sense(scene: Scene) -> Scene:
    """The positive senses, at the lower right."""
    _, bottom, right, _ = scene.bounds
    return axes((right + 0.7, bottom + 0.1))
