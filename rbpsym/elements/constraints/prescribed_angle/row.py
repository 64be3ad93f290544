"""A body that is turned; the couple is the multiplier."""

from rbpsym.oracles.simulation_joints import Element, Kept, Mechanism, State, driven, turn


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """Its angle, or that against another body."""
    angle = turn(mechanism.body_number(element["of"]), mechanism.body_number(element["body"]))
    return [driven(element.name, element.name, angle, element["angle"], mechanism)]
