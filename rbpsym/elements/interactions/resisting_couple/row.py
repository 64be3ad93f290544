"""A couple against the turning of two bodies."""

from rbpsym.oracles.simulation_bodies import Coordinates, Element, Load, Mechanism, State, couples, difference
from rbpsym.oracles.simulation_joints import Against, law

row = law


def against(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Against:
    """The rate at which the second turns, in its sense, and the couple of size 1."""
    first, second = map(mechanism.body_number, element["between"])
    sense = float(mechanism.slips.get(element.name, 1))

    def found(where: State, speed: State) -> tuple[float, list[Load]]:
        return difference(speed, first, second) * sense, couples(element.name, first, second, -sense)

    return found
