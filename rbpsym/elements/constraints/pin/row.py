"""Two points that stay together."""

from rbpsym.oracles.simulation_joints import Element, Kept, Mechanism, State, ends_of, together


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """The second less the first."""
    return together(*ends_of(element, mechanism), element.name)
