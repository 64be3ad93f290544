"""What holds a system, in numbers: points, lines, circles, strings, springs and dampers of a sketch."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.contacts import meeting, parameter
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.numbers import floating, number
from rbpsym.mechanics.strings import pieces
from rbpsym.mechanics.system import rotated
from rbpsym.pictures.figures import sketch as sk
from rbpsym.pictures.figures.scene import Point
from rbpsym.pictures.figures.sketch import SketchArrow
from rbpsym.pictures.pose import DrawnPose
from rbpsym.quantities import NUMBER
from rbpsym.statement.curves import is_slot
from rbpsym.statement.model import Element, PointRef, Problem, Turn
from rbpsym.statement.slots import ALL, drawn_as

NEAR = 1e-9


def touching(pose: DrawnPose) -> list[Element]:
    """Constraints on a line or a circle, and what is met later."""
    return [e for e in (*pose.study.problem.constraints, *met_later(pose.study.problem)) if "line" in e.values]


def met_later(problem: Problem) -> list[Element]:
    """What bodies bounce from, and the constraints that begin in a later phase."""
    bounces = [e for phase in problem.phases for e in phase.impulses if e.kind == "bounce"]
    return [*bounces, *(phase.gap for phase in problem.phases if phase.gap is not None and phase.gap not in bounces)]


def points(pose: DrawnPose) -> Iterator[sk.SketchPoint]:
    """Pivots, pins, welds, led points, edges, and the fixed ends of springs and strings."""
    problem = pose.study.problem
    for element in drawn_as(problem, "pivot", "pin", "weld"):
        yield _joined(pose, element)
    for element in touching(pose):
        yield from _led_or_edge(pose, element)
    for element in drawn_as(problem, "link", "cord"):
        yield from _anchors(pose, *element["between"])
    for element in (*problem.constraints, *met_later(problem)):
        if "path" in element.values:
            yield from _string_ends(pose, element["path"])


def _joined(pose: DrawnPose, element: Element) -> sk.SketchPoint:
    refs = element.values.get("points") or (None, element["point"])
    bodies = tuple(ref.body for ref in refs if ref and ref.body)
    ground, mark = len(bodies) < 2, ALL[element.kind].drawn
    kind = {("pin", True): "pivot", ("weld", False): "point"}.get((mark, ground), mark)
    at = pose.ref(next(ref for ref in reversed(refs) if ref and ref.body))
    return sk.SketchPoint(kind, at, origin_label(at) if ground else None, bodies)


def _led_or_edge(pose: DrawnPose, element: Element) -> Iterator[sk.SketchPoint]:
    """A point that a slot leads; a fixed edge on which a body lies."""
    ref = element.values.get("point")
    if ref is None:
        return
    if is_slot(element):
        yield sk.SketchPoint("guide", pose.ref(ref), None, (ref.body,) if ref.body else ())
    elif ref.body is None and element.values.get("of"):
        angle = pose.value(pose.study.system.bodies[element["of"]].pose.angle)
        below = min((angle + math.pi / 2, angle - math.pi / 2), key=math.sin)
        name = t.Sym(ref.label) if ref.label.isidentifier() else None
        yield sk.SketchPoint("edge", pose.ref(ref), name, (), below)


def _anchors(pose: DrawnPose, *ends: PointRef) -> Iterator[sk.SketchPoint]:
    """The fixed ends of what runs between two points, their ground away from the other end."""
    for ref, other in (ends, ends[::-1]):
        if ref.body is None:
            here, there = pose.ref(ref), pose.ref(other)
            yield sk.SketchPoint(
                "anchor", here, origin_label(here), (), math.atan2(here[1] - there[1], here[0] - there[0])
            )


def _string_ends(pose: DrawnPose, path: tuple[Turn, ...]) -> Iterator[sk.SketchPoint]:
    for turn, other in ((path[0], path[1]), (path[-1], path[-2])):
        if turn.body is None and not turn.sense:
            yield next(_anchors(pose, turn.center, other.center))
    for turn in path[1:-1]:
        if turn.body is None and not turn.sense:
            yield sk.SketchPoint("guide", pose.ref(turn.center))


def origin_label(at: Point) -> t.Node | None:
    """O, where the origin is."""
    return t.Sym("O") if math.hypot(*at) < NEAR else None


def lines(pose: DrawnPose) -> Iterator[sk.SketchLine]:
    """The fixed lines that anything touches, and the rails that lead points."""
    seen, geometry = set(), geometry_of(pose.study.system)
    for element in touching(pose):
        line = element.values.get("line")
        if line is None or element.values.get("of") or line.label in seen:
            continue
        seen.add(line.label)
        a, b, c = (pose.node(part) for part in (line.a, line.b, line.c))
        if is_slot(element):
            yield sk.SketchLine(a, b, c, kind="rail")
            continue
        met = meeting(element, geometry)
        x, y = pose.point(met.normal)
        at = pose.point(met.place)
        yield sk.SketchLine(
            a, b, c, None, -1 if a * x + b * y > 0 else 1, at=at, end=_edge_of_table(pose, (a, b, c), at)
        )


def _edge_of_table(pose: DrawnPose, line: tuple[float, float, float], at: Point) -> Point | None:
    """Where a line ends before a pulley that stands at its end."""
    a, b, c = line
    for element in pose.study.problem.of_kind("string"):
        for turn in element["path"]:
            x, y = pose.ref(turn.center)
            radius = pose.node(turn.radius) if turn.sense else 0.0
            away = (a * x + b * y - c) / (a * a + b * b)
            foot = (x - away * a, y - away * b)
            far = math.dist(foot, at)
            if radius and abs(away) * math.hypot(a, b) < 1.5 * radius and far > radius:
                share = (far - 1.1 * radius) / far
                return at[0] + share * (foot[0] - at[0]), at[1] + share * (foot[1] - at[1])
    return None


def circles(pose: DrawnPose) -> Iterator[sk.SketchCircle]:
    """Fixed circles that are touched, or round which a string slides."""
    seen = set()
    for element in touching(pose):
        centre = element.values.get("circle")
        if centre is None or centre.body is not None or centre.label in seen:
            continue
        seen.add(centre.label)
        yield _touched(pose, element)
    for element in pose.study.problem.of_kind("string"):
        for turn in element["path"]:
            if turn.body is None and turn.sense:
                yield sk.SketchCircle(pose.ref(turn.center), pose.node(turn.radius), "convex", turn.radius)


def _touched(pose: DrawnPose, element: Element) -> sk.SketchCircle:
    """Solid where nothing touches: inside for what is on it, outside for what is in it."""
    at, radius = pose.ref(element["circle"]), pose.node(element["radius"])
    body = element.values.get("body") or element["point"].body
    inside = body is not None and math.dist(pose.center(body), at) < radius
    kind = "rail" if is_slot(element) else _hollow(pose, element, at) if inside else "convex"
    return sk.SketchCircle(at, radius, kind, element["radius"] if radius else None)  # a corner has no size to tell


def _hollow(pose: DrawnPose, element: Element, at: Point) -> str:
    """A bowl, if all that touches the circle is below its centre and no angle goes all round."""
    turning = [c for c in pose.study.problem.coordinates if c.quantity.dimension == NUMBER and c.start is not None]
    if any(None in (c.lower, c.upper) for c in turning):
        return "concave"
    same = [e for e in touching(pose) if e.values.get("circle") and e["circle"].label == element["circle"].label]
    places = [pose.point(meeting(e, geometry_of(pose.study.system)).place) for e in same]
    return "bowl" if all(y < at[1] for _, y in places) else "concave"


def cords(pose: DrawnPose) -> Iterator[sk.SketchCord]:
    """Curves, and each string as a line of points, with arcs round its pulleys."""
    geometry = geometry_of(pose.study.system)
    yield from (_bent(pose, element) for element in touching(pose) if element.values.get("curve") is not None)
    for element in drawn_as(pose.study.problem, "cord"):
        yield sk.SketchCord(tuple(pose.ref(ref) for ref in element["between"]), element["size"], "string")
    for element in pose.study.problem.of_kind("string"):
        found, every = list[Point](), pieces(element, geometry)
        for place, piece in enumerate(every):
            found += [pose.point(piece.start), pose.point(piece.end)]
            if piece.second.sense and place + 1 < len(every):
                middle, turn = pose.ref(piece.second.center), piece.second.sense
                found += _round(found[-1], pose.point(every[place + 1].start), middle, turn)
        kind = "link" if element.values.get("rigid") else "string"
        yield sk.SketchCord(tuple(found), element.values.get("length"), kind)
    for element in met_later(pose.study.problem):
        if "path" in element.values:
            yield from _slack(pose, element)


def _slack(pose: DrawnPose, element: Element) -> Iterator[sk.SketchCord]:
    """A string that hangs loose between two points: a flat parabola of its length; none where the ends are in one place."""
    (x, y), (right, top) = (pose.ref(turn.center) for turn in element["path"])
    span, spare = math.dist((x, y), (right, top)), pose.node(element["length"])
    sag = math.sqrt(max(0.0, 3 / 8 * span * (spare - span)))
    shares = [k / 16 for k in range(17)] if span > NEAR else []
    places = [(x + k * (right - x), y + k * (top - y) - 4 * sag * k * (1 - k)) for k in shares]
    if places:
        yield sk.SketchCord(tuple(places), element["length"], "link" if element.values.get("rigid") else "string")


def _bent(pose: DrawnPose, element: Element) -> sk.SketchCord:
    """A curve on both sides of what it leads."""
    curve = element["curve"]
    here = pose.value(parameter(element, geometry_of(pose.study.system)))
    reach = 1.3 * max(abs(here), pose.size / 2 if curve.axis else 1.0)
    numbers = ({**pose.numbers, curve.name: reach * k / 24} for k in range(-24, 25))
    places = [(number(scalar(curve.x), known), number(scalar(curve.y), known)) for known in numbers]
    return sk.SketchCord(tuple(places), None, "rail")


def _round(start: Point, end: Point, middle: Point, sense: int) -> list[Point]:
    """Points of the arc from one point of a circle to another."""
    first, last = (math.atan2(p[1] - middle[1], p[0] - middle[0]) for p in (start, end))
    turn = ((last - first) * sense) % math.tau
    turn = 0.0 if turn > math.tau - 1e-6 else turn
    radius, count = math.dist(start, middle), max(1, round(turn / 0.15))
    angles = [first + sense * turn * k / count for k in range(1, count)]
    return [(middle[0] + radius * math.cos(a), middle[1] + radius * math.sin(a)) for a in angles]


def links(pose: DrawnPose) -> Iterator[sk.SketchLink]:
    """Springs and dampers."""
    for element in drawn_as(pose.study.problem, "link"):
        start, end = (pose.ref(ref) for ref in element["between"])
        yield sk.SketchLink(element.kind, start, end, strength(element))


def coils(pose: DrawnPose) -> Iterator[sk.SketchCoil]:
    """Torsion springs and rotary dampers, at a hinge."""
    for element in drawn_as(pose.study.problem, "coil"):
        name = next(n for n in reversed(element["between"]) if n in pose.study.system.bodies)
        yield sk.SketchCoil(_hinge(pose, name), strength(element), element.kind.replace("-", "_"))


def strength(element: Element) -> t.Node:
    """That by which a spring or a damper is told."""
    found: t.Node = element.values.get("stiffness") or element["coefficient"]
    return found


def _hinge(pose: DrawnPose, body: str) -> Point:
    """Where a body is hinged, else its centre."""
    held = (point.at for point in points(pose) if body in point.bodies)
    return next(held, pose.center(body))


# --- what acts on a system and how it moves at first: arrows of a sketch


SMALL = 1e-9


def arrows(pose: DrawnPose) -> Iterator[SketchArrow]:
    """Applied forces and couples, driven points, blows, speeds at the start."""
    for of in (_forces, _couples, _driven, _blows, _speeds):
        yield from of(pose)


def _unit(x: float, y: float) -> Point | None:
    size = math.hypot(x, y)
    return (x / size, y / size) if size > SMALL else None


def _letter(element: Element, parts: tuple[t.Node, ...]) -> t.Node:
    """The one component that there is, without its sign; else the name of the whole."""
    found = [part for part in parts if scalar(part)]
    plain = found[0].arg if len(found) == 1 and isinstance(found[0], t.Neg) else found[0] if len(found) == 1 else None
    return plain if isinstance(plain, t.Sym) else t.Vec(element.name)


def _forces(pose: DrawnPose) -> Iterator[SketchArrow]:
    for element in drawn_as(pose.study.problem, "arrow"):
        acting = pose.study.system.named(element.name)[0]
        way = next(filter(None, (_unit(x, y) for x, y in _acting(pose, acting.vector.x, acting.vector.y))), None)
        if way:
            letter = _letter(element, element["force"]) if "force" in element.values else t.Vec(element.name)
            yield SketchArrow("force", pose.point(acting.point), way, letter)


def _acting(pose: DrawnPose, *values: Scalar) -> Iterator[list[float]]:
    """The numbers in the pose, and as if all moved: what vanishes at rest is drawn as in motion."""
    for more in ({}, dict.fromkeys(pose.study.system.speeds, 1.0)):
        yield [floating(value, {**pose.reactions(), **pose.numbers, **more}, 0.0) for value in values]


def _couples(pose: DrawnPose) -> Iterator[SketchArrow]:
    for element in drawn_as(pose.study.problem, "turn"):
        acting = pose.study.system.named(element.name)[0]
        sense = math.copysign(1.0, next(filter(None, (value for value, in _acting(pose, acting.couple))), 1.0))
        letter = _sized(element.values.get("couple") or element["size"], element.name)
        yield SketchArrow("couple", pose.center(acting.on), (sense, 0.0), letter)


def _sized(node: t.Node, name: str) -> t.Node:
    plain = node.arg if isinstance(node, t.Neg) else node
    return plain if isinstance(plain, t.Sym) else t.Sym(name)


def _driven(pose: DrawnPose) -> Iterator[SketchArrow]:
    for element in drawn_as(pose.study.problem, "driven"):
        turn = pose.study.system.bodies[element["of"]].pose.angle if element["of"] else NOTHING
        x, y = map(scalar, element["along"])
        way = _unit(*pose.point(rotated(x, y, turn)))
        if way:
            yield SketchArrow("driven", pose.ref(element["point"]), way, element["distance"])
    for element in drawn_as(pose.study.problem, "spin"):
        yield SketchArrow("spin", pose.center(element["body"]), (1.0, 0.0), element["angle"])


def _blows(pose: DrawnPose) -> Iterator[SketchArrow]:
    for phase in pose.study.problem.phases:
        for element in phase.impulses:
            if element.kind != "blow":
                continue
            way = _unit(*(pose.node(part) for part in element["impulse"]))
            if way:
                yield SketchArrow("blow", pose.ref(element["on"]), way, _letter(element, element["impulse"]))


def _speeds(pose: DrawnPose) -> Iterator[SketchArrow]:
    """The speed at the start of each coordinate that has one, on the first body that it moves."""
    for coordinate in pose.study.problem.coordinates:
        if coordinate.speed is None or not scalar(coordinate.speed):
            continue
        sense = math.copysign(1.0, pose.node(coordinate.speed))
        label = _sized(coordinate.speed, f"{coordinate.name}_dot")
        found = _moved(pose, coordinate.name, bool(coordinate.quantity.dimension.length))
        if found:
            kind, at, way = found
            yield SketchArrow(kind, at, (sense * way[0], sense * way[1]), label)


def _moved(pose: DrawnPose, coordinate: str, is_length: bool) -> tuple[str, Point, Point] | None:
    """(kind, place, direction) of what a coordinate moves: a centre, or the turning of a body."""
    for name, state in pose.study.system.bodies.items():
        slope = pose.slope(name, coordinate)
        if not is_length and slope:
            return "spin", pose.center(name), (math.copysign(1.0, slope), 0.0)
        way = _unit(*pose.point(state.center.derivative(coordinate)))
        if is_length and way:
            return "velocity", pose.center(name), way
    return None
