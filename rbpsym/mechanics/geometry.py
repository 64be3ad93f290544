"""Where everything is, as the constraints see it, and signs at a sample state.

A sample state only chooses between equally valid conventions (which side of a line a body is
on, which way a straight string runs); it never decides whether something holds.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.algebra.vector import ORIGIN, Vector
from rbpsym.errors import NoNumber
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.system import BodyState, Pose
from rbpsym.statement.model import PointRef, Problem

TINY = 1e-9


@dataclass(frozen=True)
class Geometry:
    """Positions of points, poses of bodies, sample numbers; states of motion where they are known.

    `unsaid` are coordinates of which nothing says where they are: their sample numbers tell nothing.
    """

    where: Callable[[PointRef], Vector]
    poses: Mapping[str, Pose]
    numbers: Mapping[str, float]
    states: Mapping[str, BodyState] = field(default_factory=dict)
    unsaid: frozenset[str] = frozenset()

    def angle(self, body: str | None) -> Scalar:
        """Angle of a body's x' axis, counter-clockwise from +x; 0 for the ground."""
        return self.poses[body].angle if body else NOTHING

    def origin(self, body: str | None) -> Vector:
        """Origin of the frame of a body."""
        return self.poses[body].origin if body else ORIGIN

    def center(self, body: str) -> Vector:
        """Centre of mass of a body."""
        return self.where(PointRef(f"{body}.cm", body, "cm"))

    def sign(self, value: Scalar) -> int:
        """1, -1, or 0 where the value vanishes or the sample does not tell."""
        try:
            found = 0.0 if is_zero(value) else number(value, self.numbers)
        except NoNumber:
            return 0
        return 0 if abs(found) < TINY else 1 if found > 0 else -1

    def is_unsaid(self, value: Scalar) -> bool:
        """Whether its sign hangs on where something is that nothing says."""
        return any(depends_on(value, name) for name in self.unsaid)

    def velocity(self, body: str | None, place: Vector) -> Vector:
        """Velocity of the material point of a body at a place: V + ω k × (place - R)."""
        if body is None:
            return ORIGIN
        state = self.states[body]
        return state.velocity + (place - state.center).turned() * state.omega


def unsaid(problem: Problem) -> frozenset[str]:
    """Coordinates without a start and a range."""
    return frozenset(c.name for c in problem.coordinates if c.start is None and c.lower is None and c.upper is None)


def sample_numbers(problem: Problem, dependent: Mapping[str, Scalar]) -> dict[str, float]:
    """The sample state, what the constraints tie to other coordinates included."""
    numbers = sample(problem)
    return numbers | {name: number(value, numbers) for name, value in dependent.items()}


def start_numbers(problem: Problem) -> dict[str, float]:
    """The sample state with the declared starts of the coordinates."""
    numbers = sample(problem)
    starts = {c.name: scalar(c.start) for c in problem.coordinates if c.start is not None}
    return numbers | {name: number(value, numbers) for name, value in starts.items()}
