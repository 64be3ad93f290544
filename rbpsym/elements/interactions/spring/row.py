"""The pull of a spring."""

from rbpsym.oracles.simulation_bodies import Coordinates, Element, Law, Mechanism, between


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """k (d − d₀)/d times the vector between the ends."""
    k, slack = mechanism.number(element["stiffness"]), mechanism.number(element["natural_length"])
    return between(element, mechanism, lambda d, rate: k if slack == 0 else k * (1 - slack / d))
