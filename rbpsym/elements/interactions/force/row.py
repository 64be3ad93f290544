"""A force at a point."""

import math

from rbpsym.oracles.simulation_bodies import Coordinates, Element, Law, Load, Mechanism, State, load_at, placed, values


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """Turned with the body, if its components are those in the body's frame."""
    spot, turns = mechanism.spot(element["on"]), element["frame"] == "body"
    components = values(element["force"], mechanism, coordinates)

    def law(where: State, speed: State) -> list[Load]:
        x, y = components(where, speed)
        angle = where[3 * spot.body + 2] if turns else 0.0
        c, s = math.cos(angle), math.sin(angle)
        return [load_at(element.name, placed(spot, where, speed), c * x - s * y, s * x + c * y)]

    return law
