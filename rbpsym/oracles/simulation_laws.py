"""The known forces of a mechanism as numbers.

Each law of a force is written from its definition, apart from the mechanics: the `row` in the folder of its kind.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import Parts
from rbpsym.expr.tree import Node
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.numbers import Values
from rbpsym.oracles.simulation_bodies import Coordinates, Law, Load, Mechanism, State, load_at, placed
from rbpsym.statement.model import Element


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


ROWS: Parts[Callable[[Element, Mechanism, Coordinates], Law]] = Parts(INTERACTIONS, "row", "row")


def laws(mechanism: Mechanism, coordinates: Coordinates) -> list[Law]:
    """The laws of all interactions; `coordinates` gives the values of q and q̇ at a state."""
    return [ROWS[element.kind](element, mechanism, coordinates) for element in mechanism.problem.interactions]
