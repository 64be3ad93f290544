"""The numeric sketch of a problem in a representative pose, for its figures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Vector
from rbpsym.derivation.step import Derivation
from rbpsym.document.figures.sketch import (
    AngleMark, LengthMark, RadiusMark, Sketch, SketchBody, SketchCoil, SketchCouple, SketchForce, SketchLine,
    SketchLink, SketchPart, SketchPoint,
)
from rbpsym.errors import RbpsymError
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.placing import locator
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force
from rbpsym.notation import tree as t
from rbpsym.statement.model import Element, PointRef, Shape

Point = tuple[float, float]


class _Pose:
    """Numbers of one pose of a system."""

    def __init__(self, study: Study) -> None:
        self.study, self.system = study, study.system
        self.numbers = self._tied(sample(study.problem, study.problem.example))
        states = self.system.bodies
        self.where = locator(study.problem, {n: s.inertia for n, s in states.items()},
                             {n: s.pose for n, s in states.items()})

    def _tied(self, numbers: dict[str, float]) -> dict[str, float]:
        return numbers | {n: number(v, numbers) for n, v in self.system.dependent.items()}

    def value(self, found: Scalar) -> float:
        return number(found, self.numbers)

    def node(self, node: t.Node) -> float:
        return self.value(scalar(node))

    def point(self, vector: Vector) -> Point:
        return self.value(vector.x), self.value(vector.y)

    def ref(self, ref: PointRef) -> Point:
        return self.point(self.where(ref))


def sketch_of(derivation: Derivation) -> Sketch:
    """The sketch of a derived problem, with the forces of its free-body diagrams."""
    pose = _Pose(derivation.study)
    return Sketch(
        bodies=tuple(_bodies(pose)), points=tuple(_points(pose)), lines=tuple(_lines(pose)),
        links=tuple(_links(pose)), coils=tuple(_coils(pose)), angles=tuple(_angles(pose)),
        lengths=tuple(_lengths(pose)), radii=tuple(_radii(pose)), forces=tuple(_forces(pose, derivation)),
        couples=tuple(_couples(pose, derivation)), **_gravity(pose),
    )


def _bodies(pose: _Pose) -> Iterator[SketchBody]:
    for body in pose.study.problem.bodies:
        state = pose.system.bodies[body.name]
        yield SketchBody(
            body.name, body.shape.kind, _sizes(pose, body.shape), pose.point(state.pose.origin),
            pose.value(state.pose.angle), pose.point(state.center), None, tuple(_parts(pose, body.shape)),
        )


def _sizes(pose: _Pose, shape: Shape) -> dict[str, float]:
    return {name: pose.node(size) for name, size in shape.sizes.items() if name != "moment"}


def _parts(pose: _Pose, shape: Shape) -> Iterator[SketchPart]:
    for part in shape.parts:
        at = (pose.node(part.at[0]), pose.node(part.at[1]))
        yield SketchPart(part.shape.kind, _sizes(pose, part.shape), at, pose.node(part.angle), part.removed)


def _elements(pose: _Pose, *kinds: str) -> list[Element]:
    both = (*pose.study.problem.constraints, *pose.study.problem.interactions)
    return [element for element in both if element.kind in kinds]


def _points(pose: _Pose) -> Iterator[SketchPoint]:
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


def _origin_label(pose: _Pose, ref: PointRef) -> t.Node | None:
    x, y = pose.ref(ref)
    return t.Sym("O") if math.hypot(x, y) < 1e-9 else None


def _lines(pose: _Pose) -> Iterator[SketchLine]:
    seen = set()
    for element in _elements(pose, "contact"):
        line = element.values.get("line")
        if line is None or line.label in seen:
            continue
        seen.add(line.label)
        yield SketchLine(pose.node(line.a), pose.node(line.b), pose.node(line.c))


def _links(pose: _Pose) -> Iterator[SketchLink]:
    for element in _elements(pose, "spring", "damper"):
        key = "stiffness" if element.kind == "spring" else "coefficient"
        start, end = (pose.ref(ref) for ref in element["between"])
        yield SketchLink(element.kind, start, end, element[key])


def _coils(pose: _Pose) -> Iterator[SketchCoil]:
    for element in _elements(pose, "torsion-spring", "rotary-damper"):
        key = "stiffness" if element.kind == "torsion-spring" else "coefficient"
        name = next(n for n in reversed(element["between"]) if n in pose.system.bodies)
        yield SketchCoil(_hinge(pose, name), element[key], element.kind.replace("-", "_"))


def _hinge(pose: _Pose, body: str) -> Point:
    """Where a body is hinged, else its centre."""
    for point in _points(pose):
        if body in point.bodies:
            return point.at
    return pose.point(pose.system.bodies[body].center)


def _angles(pose: _Pose) -> Iterator[AngleMark]:
    """Each angle coordinate from its reference direction to the body that turns with it."""
    for coordinate in pose.study.problem.coordinates:
        if coordinate.quantity.dimension.length:
            continue
        found = _turning_body(pose, coordinate.name)
        if found is None:
            continue
        name, sense = found
        direction = pose.value(pose.system.bodies[name].pose.angle)
        value = pose.numbers[coordinate.name]
        at = _vertex(pose, name)
        direction = _drawn_axis(pose, name, at, direction, sense * value)
        yield AngleMark(at, direction - sense * value, direction, t.Sym(coordinate.name))


def _turning_body(pose: _Pose, coordinate: str) -> tuple[str, int] | None:
    """The first body whose angle is ±coordinate plus a constant, and the sign."""
    from rbpsym.algebra.calculus import derivative

    for name, state in pose.system.bodies.items():
        slope = derivative(state.pose.angle, coordinate).number()
        if slope in (1, -1) and pose.study.problem.body(name).angle is not None:
            return name, int(slope)
    return None


def _vertex(pose: _Pose, body: str) -> Point:
    """A hinge of the body, a point that touches a horizontal line, else its centre."""
    hinges = [p.at for p in _points(pose) if body in p.bodies and p.kind == "pivot"]
    touches = [pose.ref(e["point"]) for e in _elements(pose, "contact")
               if e["point"].body == body and "line" in e.values and abs(pose.node(e["line"].a)) < 1e-9]
    pins = [p.at for p in _points(pose) if body in p.bodies]
    return next(iter([*hinges, *touches, *pins]), pose.point(pose.system.bodies[body].center))


def _drawn_axis(pose: _Pose, body: str, at: Point, direction: float, turned: float) -> float:
    """The end of the axis that leaves the vertex along the body; reference directions stay on the axes."""
    cx, cy = pose.point(pose.system.bodies[body].center)
    along = (cx - at[0]) * math.cos(direction) + (cy - at[1]) * math.sin(direction)
    return direction + math.pi if along < -1e-9 else direction


def _size_marks(pose: _Pose, kinds: tuple[str, ...]) -> Iterator[tuple[str, str, t.Node]]:
    for body in pose.study.problem.bodies:
        for key, size in body.shape.sizes.items():
            if key in kinds:
                yield body.name, key, size


def _lengths(pose: _Pose) -> Iterator[LengthMark]:
    ends = {"length": ("start", "end"), "width": ("left", "right"), "height": ("bottom", "top"), "base": ("left", "right")}
    for name, key, size in _size_marks(pose, tuple(ends)):
        points = pose.study.problem.body(name).points
        if all(end in points for end in ends[key]):
            start, end = (pose.ref(PointRef(p, name, p)) for p in ends[key])
            yield LengthMark(start, end, size)
    yield from _displacements(pose)


def _displacements(pose: _Pose) -> Iterator[LengthMark]:
    """A length coordinate, from the origin to the point whose place it gives."""
    for coordinate in pose.study.problem.coordinates:
        for body in pose.study.problem.bodies:
            if coordinate.quantity.dimension.length and body.placed and t.Sym(coordinate.name) in body.placed[1]:
                x, y = (pose.node(n) for n in body.placed[1])
                start = (0.0, y) if body.placed[1][0] == t.Sym(coordinate.name) else (x, 0.0)
                yield LengthMark(start, (x, y), t.Sym(coordinate.name))


def _radii(pose: _Pose) -> Iterator[RadiusMark]:
    for name, _, size in _size_marks(pose, ("radius", "inner", "outer")):
        yield RadiusMark(pose.point(pose.system.bodies[name].pose.origin), pose.node(size), size)


def _direction(pose: _Pose, force: Force) -> Point:
    """The direction in the pose; unknown components as they are at rest there, else positive."""
    values = dict(pose.numbers)
    known = _reactions(pose)
    values |= {name: known.get(name, 1.0) for name in force.unknowns}
    try:
        x, y = number(force.vector.x, values), number(force.vector.y, values)
    except (KeyError, ValueError, ZeroDivisionError):
        x, y = 0.0, 1.0
    size = math.hypot(x, y)
    return (x / size, y / size) if size > 1e-12 else (0.0, 0.0)


def _reactions(pose: _Pose) -> Mapping[str, float]:
    found = {}
    for name, value in pose.study.dynamics.reactions.items():
        try:
            found[name] = pose.value(value)
        except (KeyError, ValueError, ZeroDivisionError, RbpsymError):
            continue
    return found


def _names(derivation: Derivation) -> dict[tuple[str, str], t.Node]:
    """How the ledger names each force on each body."""
    return {(step.data["forces"][0].name, step.data["forces"][0].on): step.slots["force"]
            for step in derivation.chapter("forces")}


def _forces(pose: _Pose, derivation: Derivation) -> Iterator[SketchForce]:
    names = _names(derivation)
    for force in pose.system.forces:
        direction = _direction(pose, force) if force.vector else (0.0, 0.0)
        if direction != (0.0, 0.0):
            yield SketchForce(force.on, names.get((force.name, force.on), t.Vec(force.name)), pose.point(force.point), direction)


def _couples(pose: _Pose, derivation: Derivation) -> Iterator[SketchCouple]:
    known = _reactions(pose)
    for force in pose.system.forces:
        if not force.couple:
            continue
        try:
            value = number(force.couple, {**pose.numbers, **known})
        except (KeyError, ValueError, ZeroDivisionError):
            value = 1.0
        label = _couple_label(force)
        yield SketchCouple(force.on, label, pose.point(pose.system.bodies[force.on].center), 1 if value >= 0 else -1)


def _couple_label(force: Force) -> t.Node:
    from rbpsym.algebra.present import present

    shown = present(force.couple)
    plain = shown.arg if isinstance(shown, t.Neg) else shown
    return plain if isinstance(plain, t.Sym) else t.Sym(f"tau_{force.name}")


def _gravity(pose: _Pose) -> dict[str, object]:
    for element in _elements(pose, "gravity"):
        x, y = (pose.node(n) for n in element["direction"])
        return {"gravity": (x, y), "gravity_label": element["g"]}
    return {"gravity": None}


