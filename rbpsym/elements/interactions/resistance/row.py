"""A force against the velocity of a point."""

import math

from rbpsym.mechanics.numbers import Values
from rbpsym.oracles.simulation_bodies import Coordinates, Load, Mechanism, State, load_at, placed
from rbpsym.oracles.simulation_joints import Against, law
from rbpsym.statement.model import Element

RESTING = 1e-12
row = law


def against(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Against:
    """The speed through the medium, and the force of size 1."""
    spot, drift = mechanism.spot(element["on"]), mechanism.pair(element["medium"])
    toward = (1.0, 0.0) if element["toward"] is None else mechanism.pair(element["toward"])

    def found(where: State, speed: State) -> tuple[float, list[Load]]:
        at = placed(spot, where, speed)
        x, y = (v - u for v, u in zip(at.velocity, drift, strict=True))
        size = math.hypot(x, y)
        if size < RESTING:
            (x, y), size = toward, math.hypot(*toward)
            return 0.0, [load_at(element.name, at, -x / size, -y / size)]
        slip = mechanism.slips.get(element.name)
        sense = 1.0 if slip is None else math.copysign(1.0, Values(coordinates(where, speed)).of(slip))
        return size * sense, [load_at(element.name, at, -sense * x / size, -sense * y / size)]

    return found
