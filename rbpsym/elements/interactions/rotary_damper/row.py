"""The couple of a rotary dashpot."""

from rbpsym.oracles.simulation_bodies import Coordinates, Element, Law, Mechanism, couples, difference


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """−c φ̇."""
    c = mechanism.number(element["coefficient"])
    a, b = map(mechanism.body_number, element["between"])
    return lambda where, speed: couples(element.name, a, b, -c * difference(speed, a, b))
