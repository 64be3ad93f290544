"""What acts on a system and how it moves at first: arrows of a sketch."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from rbpsym.errors import NoNumber
from rbpsym.expr import tree as t
from rbpsym.field import Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.numbers import number
from rbpsym.pictures.figures.sketch import Point, SketchArrow
from rbpsym.pictures.pose import DrawnPose
from rbpsym.statement.model import Element
from rbpsym.statement.slots import drawn_as

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
        yield [_value(pose, value, more) for value in values]


def _value(pose: DrawnPose, value, more: Mapping[str, float]) -> float:
    try:
        return number(value, {**pose.reactions(), **pose.numbers, **more})
    except NoNumber:
        return 0.0


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
        push = pose.study.system.named(element.name)[0].vector.derivative(element.name)
        way = _unit(*(_value(pose, part, {}) for part in (push.x, push.y)))
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
