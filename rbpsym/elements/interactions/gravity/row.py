"""The weights."""

from rbpsym.oracles.simulation_bodies import Coordinates, Law, Load, Mechanism
from rbpsym.statement.model import Element


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """m g at each centre of mass."""
    g, (dx, dy) = mechanism.number(element["g"]), mechanism.pair(element["direction"])
    bodies = [mechanism.body_number(name) for name in element["bodies"]]
    weights = [(k, mechanism.masses[3 * k] * g) for k in bodies]
    return lambda where, speed: [Load(element.name, k, weight * dx, weight * dy, 0.0) for k, weight in weights]
