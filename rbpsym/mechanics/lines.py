"""Straight lines a x + b y = c with a² + b² = 1."""

from __future__ import annotations

from rbpsym.algebra.calculus import root
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.poly import Poly
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Vector, cartesian
from rbpsym.mechanics.inertia import tidy
from rbpsym.statement.model import Line


def components(line: Line) -> tuple[Scalar, Scalar, Scalar]:
    """(a, b, c) with a² + b² = 1: the distance of (x, y) from the line is a x + b y - c.

    Denominators are cleared first, so that y = x tan β gives (-sin β, cos β); a slope angle is
    therefore taken between -90° and 90°.
    """
    parts = [scalar(part) for part in (line.a, line.b, line.c)]
    factor = _below(parts[:2])
    a, b, c = (part * factor for part in parts)
    length = root(tidy(a * a + b * b))
    return a / length, b / length, c / length


def normal(line: Line) -> Vector:
    """The unit vector across the line, towards growing a x + b y."""
    a, b, _ = components(line)
    return cartesian(a, b)


def _below(parts: list[Scalar]) -> Scalar:
    """The product of all that stands below in the parts."""
    below: dict[int, int] = {}
    for part in parts:
        for m in part.num.terms:
            for index, exponent in m:
                below[index] = max(below.get(index, 0), -exponent)
    return Scalar(Poly({tuple(sorted((i, e) for i, e in below.items() if e)): 1}))
