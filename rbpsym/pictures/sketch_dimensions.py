"""Dimensions of a sketch: lengths, displacements, distances, radii."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations

from rbpsym.elements.shapes import PARTLY_ROUND
from rbpsym.expr import tree as t
from rbpsym.pictures.figures.outlines import turned
from rbpsym.pictures.figures.sketch import LengthMark, Point, RadiusMark
from rbpsym.pictures.pose import RADII, DrawnPose, other_numbers
from rbpsym.pictures.sketch_angles import CLOSE, is_parameter, parameters
from rbpsym.pictures.sketch_supports import circles, cords, lines, points
from rbpsym.quantities import LENGTH
from rbpsym.statement.model import PlacedShape, PointRef


def lengths(pose: DrawnPose) -> Iterator[LengthMark]:
    """Sizes of bodies, length coordinates, and distances that are parameters and not shown otherwise."""
    found = [*_sizes(pose), *_part_lengths(pose), *_displacements(pose)]
    yield from found
    told = [mark.label for mark in (*found, *radii(pose), *cords(pose)) if mark.label is not None]
    shown = {leaf.name for label in told for leaf in t.walk(label) if isinstance(leaf, t.Sym)}
    yield from _distances(pose, shown)


ENDS = {
    "length": ("start", "end"),
    "width": ("top_left", "top_right"),
    "height": ("top_right", "bottom_right"),
    "base": ("left", "right"),
}


def _size_marks(pose: DrawnPose, kinds: tuple[str, ...]) -> Iterator[tuple[str, str, t.Node]]:
    for body in pose.study.problem.bodies:
        for key, size in body.shape.sizes.items():
            if key in kinds:
                yield body.name, key, size


def _sizes(pose: DrawnPose) -> Iterator[LengthMark]:
    for name, key, size in _size_marks(pose, tuple(ENDS)):
        known = pose.study.problem.body(name).points
        if all(end in known for end in ENDS[key]):
            start, end = (pose.ref(PointRef(p, name, p)) for p in ENDS[key])
            yield LengthMark(start, end, size)
        elif key == "height":
            yield from _triangle_height(pose, name, size)


def _parts(pose: DrawnPose) -> Iterator[tuple[PlacedShape, Point, float]]:
    """The parts of composites with their places and angles in space."""
    for body in pose.study.problem.bodies:
        state = pose.study.system.bodies[body.name]
        origin, turn = pose.point(state.pose.origin), pose.value(state.pose.angle)
        for part in body.shape.parts:
            at = turned((pose.node(part.at[0]), pose.node(part.at[1])), origin, turn)
            yield part, at, turn + pose.node(part.angle)


def _part_lengths(pose: DrawnPose) -> Iterator[LengthMark]:
    """Lengths of the rods that composites have."""
    for part, at, angle in _parts(pose):
        size = part.shape.sizes.get("length")
        if size is not None and part.shape.kind == "rod":
            half = pose.node(size) / 2
            yield LengthMark(turned((-half, 0.0), at, angle), turned((half, 0.0), at, angle), size)


def _triangle_height(pose: DrawnPose, name: str, size: t.Node) -> Iterator[LengthMark]:
    """From the base to the top, across the base."""
    top, left, right = (pose.ref(PointRef(p, name, p)) for p in ("top", "left", "right"))
    base = (right[0] - left[0], right[1] - left[1])
    share = ((top[0] - left[0]) * base[0] + (top[1] - left[1]) * base[1]) / (base[0] ** 2 + base[1] ** 2)
    yield LengthMark((left[0] + share * base[0], left[1] + share * base[1]), top, size)


def _displacements(pose: DrawnPose) -> Iterator[LengthMark]:
    """A length coordinate, from the origin to the point whose place it gives."""
    for coordinate in pose.study.problem.coordinates:
        letter = t.Sym(coordinate.name)
        for body in pose.study.problem.bodies:
            if coordinate.quantity.dimension.length and body.placed and letter in body.placed[1]:
                x, y = (pose.node(n) for n in body.placed[1])
                start = (0.0, y) if body.placed[1][0] == letter else (x, 0.0)
                if math.dist(start, (x, y)) > CLOSE:
                    yield LengthMark(start, (x, y), letter)


def _distances(pose: DrawnPose, shown: set[str]) -> Iterator[LengthMark]:
    """Parameters that are the distance of two points: for these numbers and for others."""
    here, there = _marked(pose), _marked(other_numbers(pose))
    for name in parameters(pose, LENGTH):
        if name in shown:
            continue
        for (k, one), (j, two) in combinations(enumerate(here), 2):
            others = there[k], there[j]
            found = next(
                (
                    way
                    for way in WAYS
                    if is_parameter(way(one, two), pose, name) and is_parameter(way(*others), other_numbers(pose), name)
                ),
                None,
            )
            if found:
                yield LengthMark(*ENDS_OF[found](one, two), t.Sym(name))
                break


def _apart(p: Point, q: Point) -> float:
    return math.dist(p, q)


def _across(p: Point, q: Point) -> float:
    return abs(p[0] - q[0])


def _upright(p: Point, q: Point) -> float:
    return abs(p[1] - q[1])


WAYS = (_apart, _across, _upright)
ENDS_OF = {
    _apart: lambda p, q: (p, q),
    _across: lambda p, q: ((p[0], min(p[1], q[1])), (q[0], min(p[1], q[1]))),
    _upright: lambda p, q: ((max(p[0], q[0]), p[1]), (max(p[0], q[0]), q[1])),
}


def _marked(pose: DrawnPose) -> list[Point]:
    """Points between which distances may be shown: of bodies, fixed ones, feet on lines."""
    problem = pose.study.problem
    found = [pose.ref(PointRef(p, b.name, p)) for b in problem.bodies for p in ("cm", *b.points)]
    found += [(pose.node(x), pose.node(y)) for x, y in problem.points.values()]
    fixed = [point.at for point in points(pose)]
    found += fixed
    for line in lines(pose):
        size = line.a**2 + line.b**2
        for x, y in (*fixed, *(pose.center(name) for name in pose.study.system.bodies)):
            away = (line.a * x + line.b * y - line.c) / size
            found.append((x - away * line.a, y - away * line.b))
    return found


# --- radii


def _inside(pose: DrawnPose, name: str) -> float | None:
    """A direction in which a half disk or half ring has a rim; None for a whole one."""
    if pose.study.problem.body(name).shape.kind not in PARTLY_ROUND:
        return None
    return pose.value(pose.study.system.bodies[name].pose.angle) + math.pi / 3


def radii(pose: DrawnPose) -> Iterator[RadiusMark]:
    """Radii of bodies and of fixed circles; one letter is shown once."""
    seen: set[t.Node] = set()
    for name, _, size in _size_marks(pose, ("radius", "inner", "outer")):
        if size not in seen:
            seen.add(size)
            yield RadiusMark(
                pose.point(pose.study.system.bodies[name].pose.origin), pose.node(size), size, _inside(pose, name)
            )
    for part, at, _ in _parts(pose):
        for size in (node for key, node in part.shape.sizes.items() if key in RADII and node not in seen):
            seen.add(size)
            yield RadiusMark(at, pose.node(size), size)
    for circle in circles(pose):
        if circle.label not in seen:
            seen.add(circle.label)
            yield RadiusMark(circle.at, circle.radius, circle.label)
    for name, rims in pose.rims.items():
        at = pose.point(pose.study.system.bodies[name].pose.origin)
        for rim in rims:
            if rim not in seen:
                seen.add(rim)
                yield RadiusMark(at, pose.node(rim), rim)
