"""Points, lines and directions in words, as they are seen in the figure."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

from rbpsym.document.model import Inlines
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.field import Vector, is_zero
from rbpsym.mechanics.assemble import vector_rate
from rbpsym.mechanics.study import Study
from rbpsym.pictures.pose import DrawnPose
from rbpsym.statement.model import Line, PointRef

CENTERS = frozenset({"center", "cm", "middle", "origin"})
ENDS = {"start": "end", "end": "start"}
SIDES = ("right", "upwards", "left", "downwards")


def point_in_words(ref: PointRef, pose: DrawnPose, said: Words) -> Inlines:
    """ "the lower end of the ladder", "the centre of the disk", "the fixed point O"."""
    if ref.body is None:
        return fixed_point(ref, pose, said)
    body = said.the(ref.body)
    if shape_of(ref, pose) == "particle":
        return body
    return said.say("point.of", point=point_name(ref, pose, said), body=body)


def locator(study: Study) -> Callable[[str, str, Words], Inlines]:
    """Says a point of a body of a study by its name in the file: "the lower end of the rod"."""

    @cache
    def pose() -> DrawnPose:
        return DrawnPose(study)

    return lambda body, point, said: point_in_words(PointRef(f"{body}.{point}", body, point), pose(), said)


def shape_of(ref: PointRef, pose: DrawnPose) -> str:
    """The kind of the body on which a point is, "" if it is on none."""
    return pose.study.problem.body(ref.body).shape.kind if ref.body else ""


def point_name(ref: PointRef, pose: DrawnPose, said: Words) -> Inlines:
    """The point alone: "lower end", "centre"."""
    point, shape = ref.point or "cm", shape_of(ref, pose)
    if point in ENDS and shape == "rod":
        return said.say(f"point.end.{_side(ref, pose)}")
    if point == "cm" and not _is_centre(ref, pose):
        return said.say("point.cm")
    if point == "origin" and not _is_centre(ref, pose):
        return said.say("point.origin")
    if said.has(f"point.{shape}.{point}"):
        return said.say(f"point.{shape}.{point}")
    if point in CENTERS:
        return said.say("point.center")
    name = said.named(point)
    return said.say("point.own" if is_word(name) else "point.named", point=name)


def is_word(name: str) -> bool:
    """Is the name of a point a word ("rung"), and not a letter ("A", "P2")?"""
    return len(name) > 2 and name.islower() and not any(map(str.isdigit, name))


def _is_centre(ref: PointRef, pose: DrawnPose) -> bool:
    """Is the centre of mass also the centre of the shape?"""
    return ref.body is not None and "center" in pose.study.problem.body(ref.body).points


def _side(ref: PointRef, pose: DrawnPose) -> str:
    """Which end of a rod it is in the figure."""
    other = PointRef(ref.label, ref.body, ENDS[ref.point or "start"])
    (x, y), (u, v) = pose.ref(ref), pose.ref(other)
    if abs(y - v) > 0.25 * math.dist((x, y), (u, v)):
        return "upper" if y > v else "lower"
    return "right" if x > u else "left"


def fixed_point(ref: PointRef, pose: DrawnPose, said: Words) -> Inlines:
    """A point of space by its name, or by its coordinates."""
    if ref.label.isidentifier():
        return said.say("point.fixed", point=t.Sym(ref.label))
    if ref.at is None:
        return said.say("point.support")
    return said.say("point.at", x=t.equation(t.Sym("x"), ref.at[0]), y=t.equation(t.Sym("y"), ref.at[1]))


def line_in_words(line: Line, pose: DrawnPose, said: Words) -> Inlines:
    """ "wall", "floor" or "line", with its equation."""
    a, b = pose.node(line.a), pose.node(line.b)
    kind = "floor" if abs(a) < 1e-9 else "wall" if abs(b) < 1e-9 else "line"
    kind = "line" if kind == "floor" and not _is_below(line, pose) else kind
    return said.say(f"line.{kind}", line=line_equation(line))


def line_equation(line: Line) -> t.Node:
    """The line as y = ... where that can be read off, else as a x + b y = c."""
    x, y = t.Sym("x"), t.Sym("y")
    if line.b == t.ONE and line.a != t.ZERO:
        return t.equation(y, t.add(t.mul(x, t.neg(line.a)), line.c))
    pairs = ((a, b) if not any(isinstance(part, t.Fn) for part in t.walk(a)) else (b, a) for a, b in ((line.a, x), (line.b, y)))
    return t.equation(t.add(*(t.mul(*pair) for pair in pairs)), line.c)  # x sin β, but 2 x


def _is_below(line: Line, pose: DrawnPose) -> bool:
    """Is a horizontal line under all bodies?"""
    height = pose.node(line.c) / pose.node(line.b)
    return all(pose.center(name)[1] >= height - 1e-9 for name in pose.study.system.bodies)


def growth(coordinate: str, pose: DrawnPose) -> tuple[str, str]:
    """Which way a coordinate grows, and on which body this is seen ("" for both if on none, or not always this way, or where
    two bodies turn with it in opposite senses)."""
    turned = {name: slope for name in pose.study.system.bodies if (slope := pose.slope(name, coordinate)) in (1.0, -1.0)}
    if turned:
        (name, slope), is_one = next(iter(turned.items())), len({*turned.values()}) == 1
        return (("with" if slope > 0 else "against"), name) if is_one else ("", "")
    for name, state in pose.study.system.bodies.items():
        velocity = state.center.derivative(coordinate)
        x, y = pose.point(velocity)
        if math.hypot(x, y) > 1e-9:
            if not _keeps_direction(velocity, pose):
                return "", name
            quarters = math.atan2(y, x) / (math.pi / 2)
            return (SIDES[round(quarters) % 4] if abs(quarters - round(quarters)) < 1e-6 else ""), name
    return "", ""


def _keeps_direction(velocity: Vector, pose: DrawnPose) -> bool:
    """Does the vector stay parallel to itself whatever the motion is?"""
    rate = vector_rate(velocity, pose.study.system.scope)
    return is_zero(velocity.cross(rate))
