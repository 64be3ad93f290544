"""The pull of a dashpot."""

from rbpsym.oracles.simulation_bodies import Coordinates, Element, Law, Mechanism, between


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """c (Δ·V)/d² times the vector between the ends."""
    c = mechanism.number(element["coefficient"])
    return between(element, mechanism, lambda d, rate: c * rate / (d * d))
