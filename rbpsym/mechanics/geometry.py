"""Positions of the points and lines that a statement refers to, as the constraints see them, and signs at a sample state.

Straight lines are a x + b y = c with a² + b² = 1. A sample state only chooses between equally valid conventions (which
side of a line a body is on, which way a straight string runs); it never decides whether something holds.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.errors import NoNumber, StatementError, there
from rbpsym.field import NOTHING, ORIGIN, Poly, Scalar, Vector, cartesian, is_zero, root, tidy
from rbpsym.field.evaluate import scalar
from rbpsym.field.roots import side_of
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.inertia import Inertia
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.system import BodyState, Pose, at_point
from rbpsym.statement.model import Body, Element, Line, Pair, PointRef, Problem


def local_point(body: Body, name: str, inertia: Inertia) -> tuple[Scalar, Scalar]:
    """Body-frame coordinates of a named point; "cm" is the centre of mass."""
    if name == "cm":
        return inertia.x, inertia.y
    x, y = body.points[name]
    return scalar(x), scalar(y)


def pair(nodes: Pair) -> Vector:
    """A pair of trees as a vector of space."""
    return cartesian(scalar(nodes[0]), scalar(nodes[1]))


def position(ref: PointRef, bodies: Mapping[str, Body], inertias: Mapping[str, Inertia], poses: Mapping[str, Pose]) -> Vector:
    """Position in space of any point."""
    if ref.body is None:
        return pair(there(ref.at))
    return at_point(poses[ref.body], local_point(bodies[ref.body], there(ref.point), inertias[ref.body]))


def components(line: Line) -> tuple[Scalar, Scalar, Scalar]:
    """(a, b, c) with a² + b² = 1: the distance of (x, y) from the line is a x + b y - c.

    Denominators are cleared first, so that y = x tan β gives (-sin β, cos β); a slope angle is
    therefore taken between -90° and 90°.
    """
    parts = [scalar(part) for part in (line.a, line.b, line.c)]
    factor = below(parts[:2])
    a, b, c = (part * factor for part in parts)
    length = root(tidy(a * a + b * b))
    return a / length, b / length, c / length


def normal(line: Line) -> Vector:
    """The unit vector across the line, towards growing a x + b y."""
    a, b, _ = components(line)
    return cartesian(a, b)


def below(parts: list[Scalar]) -> Scalar:
    """The product of all that stands below in the parts."""
    found: dict[int, int] = {}
    for part in parts:
        for m in part.num.terms:
            for index, exponent in m:
                found[index] = max(found.get(index, 0), -exponent)
    return Scalar(Poly({tuple(sorted((i, e) for i, e in found.items() if e)): 1}))


TINY = 1e-9


class Geometry(Frozen):
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

    def size(self, square: Scalar) -> Scalar:
        """The root of the square of a length: ℓ, with the sign that makes it positive at the start, for ℓ²."""
        side = side_of(square)
        return root(square) if side is None or not self.sign(side) else side * self.sign(side)

    def velocity(self, body: str | None, place: Vector) -> Vector:
        """Velocity of the material point of a body at a place: V + ω k × (place - R)."""
        if body is None:
            return ORIGIN
        state = self.states[body]
        return state.velocity + (place - state.center).turned() * state.omega


def unsaid(problem: Problem) -> frozenset[str]:
    """Coordinates without a start and a range."""
    return frozenset(c.name for c in problem.coordinates if c.start is None and c.lower is None and c.upper is None)


def start_numbers(problem: Problem) -> dict[str, float]:
    """The sample state with the declared starts of the coordinates."""
    numbers = sample(problem)
    starts = {c.name: scalar(c.start) for c in problem.coordinates if c.start is not None}
    return numbers | {name: number(value, numbers) for name, value in starts.items()}


def no_direction(element: Element, first: str, second: str) -> StatementError:
    """The refusal of what pulls along the line between two points that are always in one place."""
    return StatementError(
        f"the {element.kind} “{element.name}” joins “{first}” and “{second}”, which are always in one place: "
        "its pull has no direction",
        instead="join two points that are apart.",
        place=element.place,
    )
