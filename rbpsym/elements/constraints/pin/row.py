"""Two points that stay together."""

from rbpsym.oracles.simulation_bodies import Mechanism, State
from rbpsym.oracles.simulation_joints import Kept, ends_of, together
from rbpsym.statement.model import Element


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """The second less the first."""
    return together(*ends_of(element, mechanism), element.name)
