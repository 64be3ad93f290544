"""Numbers of one representative pose of a system: for its figures, and to name what is above and what below."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from rbpsym.algebra.calculus import derivative
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Vector
from rbpsym.errors import RbpsymError
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.placing import locator
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.quantities import NUMBER
from rbpsym.statement.model import Coordinate, PointRef, Problem

Point = tuple[float, float]
LEAST_ANGLE, SHOWN_ANGLE = 0.3, 0.6


@dataclass(frozen=True, eq=False)
class DrawnPose:
    """A study with the numbers of the pose in which it is drawn."""

    study: Study
    numbers: Mapping[str, float] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "numbers", self._tied(drawn_numbers(self.study.problem)))

    def _tied(self, numbers: dict[str, float]) -> dict[str, float]:
        return numbers | {n: number(v, numbers) for n, v in self.study.system.dependent.items()}

    @cached_property
    def where(self):
        """The position of a point of the statement."""
        states = self.study.system.bodies
        return locator(
            self.study.problem, {n: s.inertia for n, s in states.items()}, {n: s.pose for n, s in states.items()}
        )

    def value(self, found: Scalar) -> float:
        """The number of a scalar."""
        return number(found, self.numbers)

    def node(self, node: t.Node) -> float:
        """The number of a tree."""
        return self.value(scalar(node))

    def point(self, vector: Vector) -> Point:
        """The numbers of a vector."""
        return self.value(vector.x), self.value(vector.y)

    def ref(self, ref: PointRef) -> Point:
        """Where a point of the statement is."""
        return self.point(self.where(ref))

    def center(self, body: str) -> Point:
        """The centre of mass of a body."""
        return self.point(self.study.system.bodies[body].center)

    def slope(self, body: str, coordinate: str) -> float | None:
        """How fast a body's angle grows with a coordinate; None if not at a constant rate."""
        found = derivative(self.study.system.bodies[body].pose.angle, coordinate).number()
        return None if found is None else float(found)

    def reactions(self) -> dict[str, float]:
        """The unknown forces of the motion in this pose, as far as they have numbers."""
        found = {}
        for name, value in self.study.dynamics.reactions.items():
            try:
                found[name] = self.value(value)
            except (KeyError, ValueError, ZeroDivisionError, OverflowError, RbpsymError):
                continue
        return found


def drawn_numbers(problem: Problem) -> dict[str, float]:
    """The sample of a problem; angles too small to be seen are opened."""
    numbers = sample(problem, problem.example)
    for coordinate in problem.coordinates:
        if coordinate.quantity.dimension == NUMBER and abs(numbers[coordinate.name]) < LEAST_ANGLE:
            numbers[coordinate.name] = _opened(coordinate, numbers)
    return numbers


def _opened(coordinate: Coordinate, numbers: Mapping[str, float]) -> float:
    """An angle that is seen and lies in the coordinate's range."""
    low, high = (
        _bound(end, numbers, fallback)
        for end, fallback in ((coordinate.lower, -math.inf), (coordinate.upper, math.inf))
    )
    return min(max(SHOWN_ANGLE, low), high) if low <= high else SHOWN_ANGLE


def _bound(node: t.Node | None, numbers: Mapping[str, float], fallback: float) -> float:
    try:
        return fallback if node is None else number(scalar(node), numbers)
    except (KeyError, ValueError, ZeroDivisionError, RbpsymError):
        return fallback
