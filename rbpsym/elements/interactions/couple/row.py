"""A couple on a body."""

from rbpsym.oracles.simulation_bodies import Coordinates, Element, Law, Mechanism, couples, values


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """And its opposite on the body that exerts it."""
    on, other = mechanism.body_number(element["on"]), mechanism.body_number(element["reaction_on"])
    couple = values((element["couple"],), mechanism, coordinates)
    return lambda where, speed: couples(element.name, other, on, couple(where, speed)[0])
