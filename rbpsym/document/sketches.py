"""The numeric sketch of a problem in a representative pose, for its figures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from types import MappingProxyType

from rbpsym.derivation.step import Derivation
from rbpsym.document.figures.sketch import (
    AngleMark,
    LengthMark,
    RadiusMark,
    Sketch,
    SketchBody,
    SketchCoil,
    SketchCouple,
    SketchForce,
    SketchLine,
    SketchLink,
    SketchPart,
    SketchPoint,
)
from rbpsym.document.pose import DrawnPose
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.system import Force, System
from rbpsym.notation import tree as t
from rbpsym.statement.model import Element, PointRef, Shape

Point = tuple[float, float]


def sketch_of(derivation: Derivation) -> Sketch:
    """The sketch of a derived problem, with the forces of its free-body diagrams, named as in its ledger."""
    return sketch_of_pose(DrawnPose(derivation.study), _names(derivation))


def sketch_of_pose(pose: DrawnPose, names: Mapping[tuple[str, str], t.Node] = MappingProxyType({})) -> Sketch:
    """The sketch of a study in a pose; `names` are those of the forces, by force and body."""
    return Sketch(
        bodies=tuple(_bodies(pose)),
        points=tuple(_points(pose)),
        lines=tuple(_lines(pose)),
        links=tuple(_links(pose)),
        coils=tuple(_coils(pose)),
        angles=tuple(_angles(pose)),
        lengths=tuple(_lengths(pose)),
        radii=tuple(_radii(pose)),
        forces=tuple(_forces(pose, names)),
        couples=tuple(_couples(pose)),
        **_gravity(pose),
    )


def _bodies(pose: DrawnPose) -> Iterator[SketchBody]:
    for body in pose.study.problem.bodies:
        state = pose.study.system.bodies[body.name]
        yield SketchBody(
            body.name,
            body.shape.kind,
            _sizes(pose, body.shape),
            pose.point(state.pose.origin),
            pose.value(state.pose.angle),
            pose.point(state.center),
            None,
            tuple(_parts(pose, body.shape)),
        )


def _sizes(pose: DrawnPose, shape: Shape) -> dict[str, float]:
    return {name: pose.node(size) for name, size in shape.sizes.items() if name != "moment"}


def _parts(pose: DrawnPose, shape: Shape) -> Iterator[SketchPart]:
    for part in shape.parts:
        at = (pose.node(part.at[0]), pose.node(part.at[1]))
        yield SketchPart(part.shape.kind, _sizes(pose, part.shape), at, pose.node(part.angle), part.removed)


def _elements(pose: DrawnPose, *kinds: str) -> list[Element]:
    both = (*pose.study.problem.constraints, *pose.study.problem.interactions)
    return [element for element in both if element.kind in kinds]


def _points(pose: DrawnPose) -> Iterator[SketchPoint]:
    for element in _elements(pose, "pivot"):
        ref = element["point"]
        yield SketchPoint("pivot", pose.ref(ref), _origin_label(pose, ref), (ref.body,))
    for element in _elements(pose, "pin", "weld"):
        refs = element["points"]
        bodies = tuple(ref.body for ref in refs if ref.body)
        ground = any(ref.body is None for ref in refs)
        kind = {("pin", True): "pivot", ("weld", False): "point"}.get((element.kind, ground), element.kind)
        yield SketchPoint(kind, pose.ref(refs[1]), None, bodies)
    for element in _elements(pose, "spring", "damper"):
        for ref in element["between"]:
            if ref.body is None:
                yield SketchPoint("fixed", pose.ref(ref))


def _origin_label(pose: DrawnPose, ref: PointRef) -> t.Node | None:
    x, y = pose.ref(ref)
    return t.Sym("O") if math.hypot(x, y) < 1e-9 else None


def _lines(pose: DrawnPose) -> Iterator[SketchLine]:
    """The fixed lines that anything touches."""
    seen = set()
    for element in pose.study.problem.constraints:
        line = element.values.get("line")
        if line is None or element.values.get("of") or line.label in seen:
            continue
        seen.add(line.label)
        yield SketchLine(pose.node(line.a), pose.node(line.b), pose.node(line.c))


def _links(pose: DrawnPose) -> Iterator[SketchLink]:
    for element in _elements(pose, "spring", "damper"):
        key = "stiffness" if element.kind == "spring" else "coefficient"
        start, end = (pose.ref(ref) for ref in element["between"])
        yield SketchLink(element.kind, start, end, element[key])


def _coils(pose: DrawnPose) -> Iterator[SketchCoil]:
    for element in _elements(pose, "torsion-spring", "rotary-damper"):
        key = "stiffness" if element.kind == "torsion-spring" else "coefficient"
        name = next(n for n in reversed(element["between"]) if n in pose.study.system.bodies)
        yield SketchCoil(_hinge(pose, name), element[key], element.kind.replace("-", "_"))


def _hinge(pose: DrawnPose, body: str) -> Point:
    """Where a body is hinged, else its centre."""
    for point in _points(pose):
        if body in point.bodies:
            return point.at
    return pose.point(pose.study.system.bodies[body].center)


def _angles(pose: DrawnPose) -> Iterator[AngleMark]:
    """Each angle coordinate from its reference direction to the body that turns with it."""
    for coordinate in pose.study.problem.coordinates:
        if coordinate.quantity.dimension.length:
            continue
        found = _turning_body(pose, coordinate.name)
        if found is None:
            continue
        name, sense = found
        direction = pose.value(pose.study.system.bodies[name].pose.angle)
        value = pose.numbers[coordinate.name]
        at = _vertex(pose, name)
        direction = _drawn_axis(pose, name, at, direction, sense * value)
        yield AngleMark(at, direction - sense * value, direction, t.Sym(coordinate.name), _rim(pose, name, at))


ROUND = frozenset({"disk", "ring", "annulus", "ball", "shell"})


def _rim(pose: DrawnPose, name: str, at: Point) -> float:
    """The radius of a round body that is turned about its own centre: nothing on it shows how far."""
    shape = pose.study.problem.body(name).shape
    if shape.kind not in ROUND or math.dist(at, pose.center(name)) > 1e-9:
        return 0.0
    return max(pose.node(shape.sizes[key]) for key in ("radius", "outer") if key in shape.sizes)


def _turning_body(pose: DrawnPose, coordinate: str) -> tuple[str, int] | None:
    """The first body whose angle is ±coordinate plus a constant, and the sign."""
    from rbpsym.algebra.calculus import derivative

    for name, state in pose.study.system.bodies.items():
        slope = derivative(state.pose.angle, coordinate).number()
        if slope in (1, -1) and pose.study.problem.body(name).angle is not None:
            return name, int(slope)
    return None


def _vertex(pose: DrawnPose, body: str) -> Point:
    """A hinge of the body, a point that touches a horizontal line, else its centre."""
    hinges = [p.at for p in _points(pose) if body in p.bodies and p.kind == "pivot"]
    touches = [
        pose.ref(e["point"])
        for e in _elements(pose, "contact")
        if e["point"].body == body and e.values.get("line") is not None and abs(pose.node(e["line"].a)) < 1e-9
    ]
    pins = [p.at for p in _points(pose) if body in p.bodies]
    return next(iter([*hinges, *touches, *pins]), pose.point(pose.study.system.bodies[body].center))


def _drawn_axis(pose: DrawnPose, body: str, at: Point, direction: float, turned: float) -> float:
    """The end of the axis that leaves the vertex along the body; reference directions stay on the axes."""
    cx, cy = pose.point(pose.study.system.bodies[body].center)
    along = (cx - at[0]) * math.cos(direction) + (cy - at[1]) * math.sin(direction)
    return direction + math.pi if along < -1e-9 else direction


def _size_marks(pose: DrawnPose, kinds: tuple[str, ...]) -> Iterator[tuple[str, str, t.Node]]:
    for body in pose.study.problem.bodies:
        for key, size in body.shape.sizes.items():
            if key in kinds:
                yield body.name, key, size


def _lengths(pose: DrawnPose) -> Iterator[LengthMark]:
    ends = {
        "length": ("start", "end"),
        "width": ("top_left", "top_right"),
        "height": ("top_right", "bottom_right"),
        "base": ("left", "right"),
    }
    for name, key, size in _size_marks(pose, tuple(ends)):
        points = pose.study.problem.body(name).points
        if all(end in points for end in ends[key]):
            start, end = (pose.ref(PointRef(p, name, p)) for p in ends[key])
            yield LengthMark(start, end, size)
    yield from _displacements(pose)


def _displacements(pose: DrawnPose) -> Iterator[LengthMark]:
    """A length coordinate, from the origin to the point whose place it gives."""
    for coordinate in pose.study.problem.coordinates:
        for body in pose.study.problem.bodies:
            if coordinate.quantity.dimension.length and body.placed and t.Sym(coordinate.name) in body.placed[1]:
                x, y = (pose.node(n) for n in body.placed[1])
                start = (0.0, y) if body.placed[1][0] == t.Sym(coordinate.name) else (x, 0.0)
                yield LengthMark(start, (x, y), t.Sym(coordinate.name))


def _radii(pose: DrawnPose) -> Iterator[RadiusMark]:
    for name, _, size in _size_marks(pose, ("radius", "inner", "outer")):
        yield RadiusMark(pose.point(pose.study.system.bodies[name].pose.origin), pose.node(size), size)


def _direction(pose: DrawnPose, force: Force) -> Point:
    """The direction in the pose; unknown components as they are at rest there, else positive."""
    values = dict(pose.numbers)
    known = pose.reactions()
    values |= {name: known.get(name, 1.0) for name in force.unknowns}
    try:
        x, y = number(force.vector.x, values), number(force.vector.y, values)
    except (KeyError, ValueError, ZeroDivisionError):
        x, y = 0.0, 1.0
    size = math.hypot(x, y)
    return (x / size, y / size) if size > 1e-12 else (0.0, 0.0)


def _names(derivation: Derivation) -> dict[tuple[str, str], t.Node]:
    """How the ledger names each force on each body."""
    return {
        (step.data["forces"][0].name, step.data["forces"][0].on): step.slots["force"]
        for step in derivation.chapter("forces")
    }


def force_node(system: System, force: Force) -> t.Node:
    """The letter of a force: N on the second body, -N on the first, W_rod for one of several weights."""
    same = [f for f in system.forces if f.name == force.name]
    if any(_is_opposite(system, f) for f in same):
        letter = t.Vec(force.name) if force.vector else t.Sym(force.name)
        return t.neg(letter) if _is_opposite(system, force) else letter
    name = force.name if len(same) == 1 else f"{force.name}_{force.on}"
    return t.Vec(name) if force.vector else t.Sym(name)


def _is_opposite(system: System, force: Force) -> bool:
    first = next(f for f in system.forces if f.name == force.name)
    return first is not force and first.on == force.by and first.by == force.on


def _forces(pose: DrawnPose, names: Mapping[tuple[str, str], t.Node]) -> Iterator[SketchForce]:
    for force in pose.study.system.forces:
        direction = _direction(pose, force) if force.vector else (0.0, 0.0)
        if direction != (0.0, 0.0):
            label = names.get((force.name, force.on)) or force_node(pose.study.system, force)
            yield SketchForce(force.on, label, pose.point(force.point), direction)


def _couples(pose: DrawnPose) -> Iterator[SketchCouple]:
    """Unknown couples in the sense in which their letter is positive, known ones as they act in the pose."""
    known = pose.reactions()
    for force in pose.study.system.forces:
        if not force.couple:
            continue
        letter = _couple_letter(force)
        values = pose.numbers | known | ({letter.name: 1.0} if letter.name in force.unknowns else {})
        try:
            value = number(force.couple, values)
        except (KeyError, ValueError, ZeroDivisionError):
            value = 1.0
        yield SketchCouple(force.on, letter, pose.center(force.on), 1 if value >= 0 else -1)


def _couple_letter(force: Force) -> t.Sym:
    """The letter of a couple; its own if it is an unknown or a parameter with its sign."""
    from rbpsym.algebra.present import present

    shown = present(force.couple)
    plain = shown.arg if isinstance(shown, t.Neg) else shown
    return plain if isinstance(plain, t.Sym) else t.Sym(force.name)


def _gravity(pose: DrawnPose) -> dict[str, object]:
    for element in _elements(pose, "gravity"):
        x, y = (pose.node(n) for n in element["direction"])
        return {"gravity": (x, y), "gravity_label": element["g"]}
    return {"gravity": None}
