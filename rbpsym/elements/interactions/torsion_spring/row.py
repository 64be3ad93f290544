"""The couple of a spiral spring."""

from rbpsym.oracles.simulation_bodies import Coordinates, Element, Law, Mechanism, couples, difference


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """−k (φ − φ₀)."""
    k, rest = mechanism.number(element["stiffness"]), mechanism.number(element["rest_angle"])
    a, b = map(mechanism.body_number, element["between"])
    return lambda where, speed: couples(element.name, a, b, -k * (difference(where, a, b) - rest))
