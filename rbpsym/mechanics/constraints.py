"""What each kind of constraint says: which points and angles it joins, and its unknown forces.

A new kind is a new entry of `JOINTS`: its joins of points, of angles, its points on lines,
and the forces by which it keeps them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from rbpsym.algebra.calculus import root
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.poly import Poly
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.algebra.vector import EX, EY, Vector, cartesian
from rbpsym.mechanics.inertia import tidy
from rbpsym.mechanics.system import Force
from rbpsym.statement.model import Element, Line, PointRef


@dataclass(frozen=True, slots=True)
class AngleJoin:
    """angle(second) - angle(first) = offset; first None means the ground; offset None: as it starts."""

    first: str | None
    second: str
    offset: Scalar | None


@dataclass(frozen=True, slots=True)
class Touch:
    """A point that lies on a line."""

    point: PointRef
    line: Line
    side: str


@dataclass(frozen=True, slots=True)
class Joint:
    """A kind of constraint: what it joins, and its forces given the positions of points."""

    joins: Callable[[Element], tuple[tuple[PointRef | None, PointRef], ...]]
    angles: Callable[[Element], tuple[AngleJoin, ...]]
    touches: Callable[[Element], tuple[Touch, ...]]
    forces: Callable[[Element, Callable[[PointRef], Vector], Callable[[Element], int]], tuple[Force, ...]]


def unknown(element: Element) -> tuple[Vector, tuple[str, str]]:
    """The unknown force N of a joint as a vector N_x i + N_y j, with its component names."""
    names = (f"{element.name}_x", f"{element.name}_y")
    return EX * symbol(names[0]) + EY * symbol(names[1]), names


def _pivot_forces(element: Element, where, side) -> tuple[Force, ...]:
    ref = element["point"]
    vector, names = unknown(element)
    return (Force(element.name, ref.body, "ground", where(ref), vector, unknowns=names, where=ref.label),)


def _pair_of_forces(element: Element, where, couple: Scalar, more: tuple[str, ...]) -> tuple[Force, ...]:
    """The force on the second body, and its reaction on the first if that is a body."""
    first, second = element["points"]
    vector, names = unknown(element)
    names += more
    if second.body is None:
        first, second = second, first
    here = where(second)
    forces = [Force(element.name, second.body, first.body or "ground", here, vector, couple, names, where=second.label)]
    if first.body is not None:
        forces.append(Force(element.name, first.body, second.body, here, -vector, -couple, names, where=first.label))
    return tuple(forces)


def _weld_forces(element: Element, where, side) -> tuple[Force, ...]:
    name = element["couple"]
    return _pair_of_forces(element, where, symbol(name), (name,))


def _weld_angles(element: Element) -> tuple[AngleJoin, ...]:
    first, second = element["points"]
    offset = scalar(element["angle"]) if element["angle"] is not None else None
    if second.body is None:
        return (AngleJoin(None, first.body, None if offset is None else -offset),)
    return (AngleJoin(first.body, second.body, offset),)


def normal(line: Line) -> Vector:
    """The unit vector across the line, towards growing a x + b y.

    Denominators are cleared first, so that y = x tan β gives (-sin β, cos β); a slope angle is
    therefore taken between -90° and 90°.
    """
    a, b = _cleared(scalar(line.a), scalar(line.b))
    length = root(tidy(a * a + b * b))
    return cartesian(a / length, b / length)


def _cleared(a: Scalar, b: Scalar) -> tuple[Scalar, Scalar]:
    """Both multiplied by what stands below in them."""
    below: dict[int, int] = {}
    for poly in (a.num, b.num):
        for m in poly.terms:
            for index, exponent in m:
                below[index] = max(below.get(index, 0), -exponent)
    factor = Scalar(Poly({tuple(sorted((i, e) for i, e in below.items() if e)): 1}))
    return a * factor, b * factor


def _contact_forces(element: Element, where, side) -> tuple[Force, ...]:
    ref = element["point"]
    push = normal(element["line"]) * (symbol(element.name) * side(element))
    return (Force(element.name, ref.body, "ground", where(ref), push, unknowns=(element.name,), where=ref.label),)


def _none(element: Element) -> tuple:
    return ()


JOINTS: Mapping[str, Joint] = {
    "pivot": Joint(
        lambda e: ((_fixed(e), e["point"]),), _none, _none, _pivot_forces,
    ),
    "pin": Joint(
        lambda e: (tuple(e["points"]),), _none, _none,
        lambda e, where, side: _pair_of_forces(e, where, NOTHING, ()),
    ),
    "weld": Joint(lambda e: (tuple(e["points"]),), _weld_angles, _none, _weld_forces),
    "contact": Joint(
        _none, _none, lambda e: (Touch(e["point"], e["line"], e["side"]),), _contact_forces,
    ),
}


def _fixed(element: Element) -> PointRef | None:
    at = element["at"]
    return None if at is None else PointRef(f"{element.name} support", at=at)
