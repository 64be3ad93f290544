"""The pull along the line of two points."""

from rbpsym.oracles.simulation_bodies import Coordinates, Law, Load, Mechanism, State
from rbpsym.oracles.simulation_laws import between, values
from rbpsym.statement.model import Element


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """F/d times the vector between the ends."""
    sizes = values((element["size"],), mechanism, coordinates)

    def law(where: State, speed: State) -> list[Load]:
        size = sizes(where, speed)[0]
        return between(element, mechanism, lambda d, rate: size / d)(where, speed)

    return law
