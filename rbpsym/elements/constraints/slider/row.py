"""N, and the couple that keeps the angle as it is in the poses."""

from rbpsym.oracles.simulation_contacts import sliding
from rbpsym.oracles.simulation_joints import Element, Kept, Mechanism, State, turn, turning


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """That of a contact, and the angle against the body of the line."""
    first, second = mechanism.body_number(element["of"]), mechanism.spot(element["point"]).body
    offset = turn(first, second)(start, start).value
    return [*sliding(element, mechanism, start), turning(first, second, offset, element)]
