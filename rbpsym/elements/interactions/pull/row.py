"""The pull along the line of two points."""

from rbpsym.oracles.simulation_bodies import Coordinates, Element, Law, Load, Mechanism, State, between, values


def row(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """F/d times the vector between the ends."""
    sizes = values((element["size"],), mechanism, coordinates)

    def law(where: State, speed: State) -> list[Load]:
        size = sizes(where, speed)[0]
        return between(element, mechanism, lambda d, rate: size / d)(where, speed)

    return law
