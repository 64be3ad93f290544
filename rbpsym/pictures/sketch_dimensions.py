"""Dimensions of a sketch: lengths, displacements, distances, radii."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import combinations, islice

from rbpsym.elements.shapes import PARTLY_ROUND
from rbpsym.expr import tree as t
from rbpsym.field import Vector, derivative, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.placing import stated_place, straight
from rbpsym.pictures.figures.outlines import turned
from rbpsym.pictures.figures.scene import Point
from rbpsym.pictures.figures.sketch import AngleMark, LengthMark, RadiusMark, SketchLine
from rbpsym.pictures.pose import RADII, DrawnPose, other_numbers
from rbpsym.pictures.sketch_supports import circles, cords, lines, points
from rbpsym.quantities import LENGTH, NUMBER, Dimension
from rbpsym.statement.model import PlacedShape, PointRef


def lengths(pose: DrawnPose) -> Iterator[LengthMark]:
    """Sizes of bodies, length coordinates, and distances that are parameters and not shown otherwise."""
    found = [*_sizes(pose), *_part_lengths(pose), *_displacements(pose)]
    yield from found
    told = [mark.label for mark in found] + [mark.label for mark in radii(pose)] + [mark.label for mark in cords(pose)]
    trees = (label for label in told if isinstance(label, t.Node))
    shown = {leaf.name for tree in trees for leaf in t.walk(tree) if isinstance(leaf, t.Sym)}
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
    """A length coordinate: the way along a straight line, of a body or across an axis, from where the coordinate is 0."""
    coordinates = [c.name for c in pose.study.problem.coordinates]
    for coordinate in pose.study.problem.coordinates:
        name = coordinate.name
        if not coordinate.quantity.dimension.length or abs(pose.numbers[name]) < CLOSE:
            continue
        starts = [(p - way * symbol(name), p) for p in _places(pose) if (way := straight(p, name))]
        if starts:
            start, end = min(starts, key=lambda both: sum(bool(both[0].derivative(other)) for other in coordinates))
            yield LengthMark(pose.point(start), pose.point(end), t.Sym(name))


def _places(pose: DrawnPose) -> Iterator[Vector]:
    """The point of each body by which it is placed; else its centre of mass."""
    for body in pose.study.problem.bodies:
        yield stated_place(body) or pose.study.system.bodies[body.name].center


def _distances(pose: DrawnPose, shown: set[str]) -> Iterator[LengthMark]:
    """Parameters that are the distance of two points: for these numbers and for others."""
    other = other_numbers(pose)
    pairs = [(ends, others) for ends, others in zip(*(combinations(_marked(of), 2) for of in (pose, other)), strict=True)]
    for name in (name for name in parameters(pose, LENGTH) if name not in shown):
        fits = (
            drawn(*ends)
            for ends, others in pairs
            for far, drawn in WAYS
            if is_parameter(far(*ends), pose, name) and is_parameter(far(*others), other, name)
        )
        yield from (LengthMark(*ends, t.Sym(name)) for ends in islice(fits, 1))


Pair = Callable[[Point, Point], tuple[Point, Point]]
WAYS: tuple[tuple[Callable[[Point, Point], float], Pair], ...] = (  # how far apart two points are, and where that is drawn
    (math.dist, lambda p, q: (p, q)),
    (lambda p, q: abs(p[0] - q[0]), lambda p, q: ((p[0], min(p[1], q[1])), (q[0], min(p[1], q[1])))),
    (lambda p, q: abs(p[1] - q[1]), lambda p, q: ((max(p[0], q[0]), p[1]), (max(p[0], q[0]), q[1]))),
)


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
        if isinstance(circle.label, t.Node) and circle.label not in seen:
            seen.add(circle.label)
            yield RadiusMark(circle.at, circle.radius, circle.label)
    for name, rims in pose.rims.items():
        at = pose.point(pose.study.system.bodies[name].pose.origin)
        for rim in rims:
            if rim not in seen:
                seen.add(rim)
                yield RadiusMark(at, pose.node(rim), rim)


# --- angles of a sketch: those of coordinates, and slopes of lines that are parameters


ROUND = frozenset({"disk", "ring", "annulus", "ball", "shell"})
CLOSE = 1e-9
UNSEEN = 0.05  # radians


def angles(pose: DrawnPose) -> Iterator[AngleMark]:
    """Angle coordinates, then the slopes of lines that are parameters."""
    yield from _coordinate_angles(pose)
    yield from _slopes(pose)


def _coordinate_angles(pose: DrawnPose) -> Iterator[AngleMark]:
    """Each angle coordinate from its reference direction to the body that turns with it."""
    for coordinate in pose.study.problem.coordinates:
        value = math.fmod(pose.numbers[coordinate.name], math.tau)  # full turns are not seen
        if coordinate.quantity.dimension.length or abs(value) < UNSEEN:
            continue
        found, polar = _turning_body(pose, coordinate.name), tuple(_polar_angle(pose, coordinate.name, value))
        at = _vertex(pose, found[0]) if found else (0.0, 0.0)
        if found is None or (polar and _is_middle(pose, found[0], at)):  # rather than a turn about its own axis
            yield from polar
            continue
        name, sense = found
        direction = pose.value(pose.study.system.bodies[name].pose.angle)
        hung = _hanging(pose, name, at, sense * value)
        direction = _drawn_axis(pose, name, at, direction) if hung is None else hung
        reach = _reach(pose, name, at, direction)
        yield AngleMark(at, direction - sense * value, direction, t.Sym(coordinate.name), reach)


def _hanging(pose: DrawnPose, name: str, at: Point, turned: float) -> float | None:
    """The way from the vertex to the centre of mass, if the body has no axis to be seen and that way was level or
    upright when the angle was 0: so a book draws the angle of a body that hangs."""
    if pose.study.problem.body(name).shape.kind not in ROUND | {"composite", "given"}:
        return None
    (x, y), (u, v) = at, pose.center(name)
    direction = math.atan2(v - y, u - x)
    quarters = (direction - turned) / (math.pi / 2)
    is_away = math.dist(at, (u, v)) > CLOSE * pose.size
    return direction if is_away and abs(quarters - round(quarters)) < CLOSE else None


def _polar_angle(pose: DrawnPose, coordinate: str, value: float) -> Iterator[AngleMark]:
    """An angle that turns the line to a body from a centre that it does not move, as on a circular track."""
    for place in _places(pose):
        way = place.derivative(coordinate)
        bend = way.derivative(coordinate)
        centre = pose.point(place + bend)
        if (ray := math.hypot(*pose.point(bend))) < CLOSE or not (way + bend.derivative(coordinate)).vanishes():
            continue
        sense = 1 if pose.value(way.cross(bend)) > 0 else -1
        direction = math.atan2(*reversed(pose.point(-bend)))
        yield AngleMark(centre, direction - sense * value, direction, t.Sym(coordinate), ray=ray)
        return


def _is_middle(pose: DrawnPose, name: str, at: Point) -> bool:
    """Is it the centre of a round body?"""
    return pose.study.problem.body(name).shape.kind in ROUND and math.dist(at, pose.center(name)) < CLOSE


def _reach(pose: DrawnPose, name: str, at: Point, direction: float) -> float:
    """How far the line at which the angle ends must be drawn: nothing on a round body or beside it shows it."""
    shape = pose.study.problem.body(name).shape
    if _is_middle(pose, name, at):
        return max(pose.node(shape.sizes[key]) for key in ("radius", "outer") if key in shape.sizes)
    if shape.kind in ("rod", "particle", "rectangle", "triangle", *PARTLY_ROUND):
        return 0.0
    return max(0.3 * pose.size, math.dist(at, pose.center(name)))


def _turning_body(pose: DrawnPose, coordinate: str) -> tuple[str, int] | None:
    """The first body whose angle is stated as ±coordinate plus a constant, and the sign."""
    for body in pose.study.problem.bodies:
        slope = None if body.angle is None else derivative(scalar(body.angle), coordinate).number()
        if slope in (1, -1):
            return body.name, int(slope)
    return None


def _vertex(pose: DrawnPose, body: str) -> Point:
    """A hinge of the body, a point that touches a horizontal line, else its centre."""
    marked = list(points(pose))
    hinges = [p.at for p in marked if body in p.bodies and p.kind == "pivot"]
    touches = [
        pose.ref(e["point"])
        for e in pose.study.problem.of_kind("contact")
        if e["point"].body == body and e.values.get("line") is not None and abs(pose.node(e["line"].a)) < CLOSE
    ]
    pins = [p.at for p in marked if body in p.bodies]
    return next(iter([*hinges, *touches, *pins]), pose.center(body))


def _drawn_axis(pose: DrawnPose, body: str, at: Point, direction: float) -> float:
    """The end of the axis that leaves the vertex along the body."""
    cx, cy = pose.center(body)
    along = (cx - at[0]) * math.cos(direction) + (cy - at[1]) * math.sin(direction)
    return direction + math.pi if along < -CLOSE else direction


def _slopes(pose: DrawnPose) -> Iterator[AngleMark]:
    """Parameters that are the slope of a line, at its lower end."""
    seen: set[str] = set()
    for line, other in zip(lines(pose), lines(other_numbers(pose)), strict=True):
        for name in parameters(pose, NUMBER):
            if name in seen or not (
                _rise(line)
                and is_parameter(_rise(line), pose, name)
                and is_parameter(_rise(other), other_numbers(pose), name)
            ):
                continue
            seen.add(name)
            yield _slope_mark(pose, line, t.Sym(name))


def _slope_mark(pose: DrawnPose, line: SketchLine, label: t.Node) -> AngleMark:
    """Between the horizontal and the line, below all that stands on it."""
    size = math.hypot(line.a, line.b)
    down = (line.b / size, -line.a / size)
    down = down if down[1] < 0 else (-down[0], -down[1])
    lowest = max((x * down[0] + y * down[1] for x, y in (pose.center(name) for name in pose.study.system.bodies)))
    foot = (line.a * line.c / size**2, line.b * line.c / size**2)
    far = lowest - foot[0] * down[0] - foot[1] * down[1] + 1.1 * pose.size
    at = (foot[0] + far * down[0], foot[1] + far * down[1])
    uphill = math.atan2(-down[1], -down[0])
    start = 0.0 if down[0] < 0 else math.pi
    return AngleMark(at, start, uphill, label)


def _rise(line: SketchLine) -> float:
    """The acute angle of a line with the horizontal, 0 for a level or an upright one."""
    return math.atan2(abs(line.a), abs(line.b)) if abs(line.a) > CLOSE and abs(line.b) > CLOSE else 0.0


def parameters(pose: DrawnPose, dimension: Dimension) -> list[str]:
    """Names of the parameters of a dimension."""
    return [q.name for q in pose.study.problem.parameters if q.dimension == dimension]


def is_parameter(value: float, pose: DrawnPose, name: str) -> bool:
    """Is a number that of a parameter in this pose?"""
    return abs(value - pose.numbers[name]) < 1e-9 * max(1.0, abs(value))
