"""A mechanism in maximal coordinates: every body has its own x, y (centre of mass) and angle.

Built from the statement alone; `clock` is the time of the state that is looked at. The state
is X = (x, y, φ) and V = dX/dt of all bodies in a row; angles and torques are counter-clockwise positive.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import KindParts
from rbpsym.errors import there
from rbpsym.expr.tree import Node, Sym, walk
from rbpsym.field import Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.inertia import Inertia, inertia
from rbpsym.mechanics.numbers import Values
from rbpsym.statement.model import Body, Element, PointRef, Problem

State = Sequence[float] | np.ndarray  # of all bodies, X or V


class Spot(Frozen):
    """A point of body number `body` relative to its centre of mass, in its frame; body -1: fixed."""

    body: int
    x: float
    y: float


class Placed(Frozen):
    """A spot in motion: lever from the centre of mass, place, velocity, acceleration at A = α = 0."""

    body: int
    lever: tuple[float, float]
    place: tuple[float, float]
    velocity: tuple[float, float]
    bias: tuple[float, float]

    def along(self, dx: float, dy: float) -> list[tuple[int, float]]:
        """∂(d·place)/∂X as (column, entry); none for a fixed spot."""
        if self.body < 0:
            return []
        (rx, ry), k = self.lever, 3 * self.body
        return [(k, dx), (k + 1, dy), (k + 2, dy * rx - dx * ry)]


STILL = (0.0, 0.0)


def placed(spot: Spot, where: State, speed: State) -> Placed:
    """The spot at a state."""
    if spot.body < 0:
        return Placed(-1, STILL, (spot.x, spot.y), STILL, STILL)
    k = 3 * spot.body
    c, s, omega = math.cos(where[k + 2]), math.sin(where[k + 2]), speed[k + 2]
    rx, ry = c * spot.x - s * spot.y, s * spot.x + c * spot.y
    return Placed(
        spot.body,
        (rx, ry),
        (where[k] + rx, where[k + 1] + ry),
        (speed[k] - omega * ry, speed[k + 1] + omega * rx),
        (-omega * omega * rx, -omega * omega * ry),
    )


class Mechanism:
    """The bodies of a statement as numbers, and the meaning of its references."""

    def __init__(self, problem: Problem, numbers: Mapping[str, float], slips: Mapping[str, Any] | None = None) -> None:
        self.problem, self.slips, self.clock = problem, slips or {}, 0.0
        self.constants = {q.name for q in problem.parameters} | set(problem.implicit)
        self.numbers = {name: value for name, value in numbers.items() if name in self.constants}
        self.known = Values(self.numbers)
        self.place = {name: k for k, name in enumerate(problem.body_names)}
        inertias = [inertia(body) for body in problem.bodies]
        self.centers = [tuple(self.known.row((own.x, own.y))) for own in inertias]
        self.masses = [entry for own in inertias for entry in self._masses(own)]

    def _masses(self, own: Inertia) -> list[float]:
        mass, moment = self.known.row((own.mass, own.moment))
        return [mass, mass, moment]

    def number(self, node: Node) -> float:
        """The value of an expression in parameters."""
        return self.known.of(scalar(node))

    def pair(self, nodes: tuple[Node, Node]) -> tuple[float, float]:
        """The values of a pair."""
        return self.number(nodes[0]), self.number(nodes[1])

    def at_time(self, value: Scalar) -> float:
        """The value of an expression in parameters and t, at the time that the clock shows."""
        return Values({**self.numbers, "t": self.clock}).of(value)

    def is_constant(self, *nodes: Node) -> bool:
        """Whether only parameters occur."""
        names = {part.name for node in nodes for part in walk(node) if isinstance(part, Sym)}
        return names <= self.constants | {"pi"}

    def body_number(self, name: str | None) -> int:
        """Index of a body, -1 for the ground."""
        return self.place.get(name or "", -1)

    def spot(self, ref: PointRef) -> Spot:
        """The point that a reference means."""
        if ref.body is None:
            return Spot(-1, *self.pair(there(ref.at)))
        return self.spot_of(self.problem.body(ref.body), there(ref.point))

    def spot_of(self, body: Body, point: str) -> Spot:
        """A named point of a body."""
        k = self.place[body.name]
        if point == "cm":
            return Spot(k, 0.0, 0.0)
        x, y = self.pair(body.points[point])
        return Spot(k, x - self.centers[k][0], y - self.centers[k][1])

    def reach(self) -> float:
        """A typical length: the farthest named point from a centre of mass, 1 if there is none."""
        spots = [self.spot_of(body, point) for body in self.problem.bodies for point in body.points]
        return max((math.hypot(spot.x, spot.y) for spot in spots), default=0.0) or 1.0


class Load(Frozen):
    """Force and torque about the centre of mass on body number `body`, by the element `name`."""

    name: str
    body: int
    x: float
    y: float
    torque: float


Coordinates = Callable[[State, State], Mapping[str, float]]
Law = Callable[[State, State], list[Load]]


def load_at(name: str, at: Placed, x: float, y: float) -> Load:
    """A force at a point."""
    return Load(name, at.body, x, y, at.lever[0] * y - at.lever[1] * x)


def difference(values: State, first: int, second: int) -> float:
    """The angle (or its rate) of the second body less that of the first; -1 is the ground."""
    return (values[3 * second + 2] if second >= 0 else 0.0) - (values[3 * first + 2] if first >= 0 else 0.0)


# --- the known forces of a mechanism as numbers
# Each law of a force is written from its definition, apart from the mechanics: the `row` in the folder of its kind.


def between(element: Element, mechanism: Mechanism, pull: Callable[[float, float], float]) -> Law:
    """A force along the line of two points: pull(distance, its rate), times the vector between them."""
    spots = [mechanism.spot(ref) for ref in element["between"]]

    def law(where: State, speed: State) -> list[Load]:
        a, b = (placed(spot, where, speed) for spot in spots)
        dx, dy = b.place[0] - a.place[0], b.place[1] - a.place[1]
        vx, vy = b.velocity[0] - a.velocity[0], b.velocity[1] - a.velocity[1]
        share = pull(math.hypot(dx, dy), dx * vx + dy * vy)
        ends = ((a, share), (b, -share))
        return [load_at(element.name, end, f * dx, f * dy) for end, f in ends if end.body >= 0]

    return law


def couples(name: str, first: int, second: int, on_second: float) -> list[Load]:
    """A couple on the second body, and its opposite on the first."""
    pairs = ((second, on_second), (first, -on_second))
    return [Load(name, k, 0.0, 0.0, couple) for k, couple in pairs if k >= 0]


def values(nodes: tuple[Node, ...], mechanism: Mechanism, coordinates: Coordinates) -> Callable[..., list[float]]:
    """Values of expressions, which may hold coordinates and speeds, at a state."""
    if mechanism.is_constant(*nodes):
        fixed = [mechanism.number(node) for node in nodes]
        return lambda where, speed: fixed
    scalars = [scalar(node) for node in nodes]
    return lambda where, speed: Values(coordinates(where, speed)).row(scalars)


ROWS: KindParts[Callable[[Element, Mechanism, Coordinates], Law]] = KindParts(INTERACTIONS, "row", "row")


def laws(mechanism: Mechanism, coordinates: Coordinates) -> list[Law]:
    """The laws of all interactions; `coordinates` gives the values of q and q̇ at a state."""
    return [ROWS[element.kind](element, mechanism, coordinates) for element in mechanism.problem.interactions]
