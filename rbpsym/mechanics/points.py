"""Positions of the points that a statement refers to."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Vector, cartesian
from rbpsym.mechanics.inertia import Inertia
from rbpsym.mechanics.system import Pose, at_point
from rbpsym.statement.model import Body, PointRef


def local_point(body: Body, name: str, inertia: Inertia) -> tuple[Scalar, Scalar]:
    """Body-frame coordinates of a named point; "cm" is the centre of mass."""
    if name == "cm":
        return inertia.x, inertia.y
    x, y = body.points[name]
    return scalar(x), scalar(y)


def pair(nodes) -> Vector:
    """A pair of trees as a vector of space."""
    return cartesian(scalar(nodes[0]), scalar(nodes[1]))


def position(
    ref: PointRef, bodies: Mapping[str, Body], inertias: Mapping[str, Inertia], poses: Mapping[str, Pose]
) -> Vector:
    """Position in space of any point."""
    if ref.body is None:
        return pair(ref.at)
    return at_point(poses[ref.body], local_point(bodies[ref.body], ref.point, inertias[ref.body]))
