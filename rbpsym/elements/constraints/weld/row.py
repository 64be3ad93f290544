"""Two points that stay together, and the angle between the bodies."""

from rbpsym.oracles.simulation_joints import Element, Kept, Mechanism, Spot, State, ends_of, together, turn, turning


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """The second less the first."""
    first, second = ends_of(element, mechanism)
    offset = _angle(element, mechanism, first, second, start)
    return [*together(first, second, element.name), turning(first.body, second.body, offset, element)]


def _angle(element: Element, mechanism: Mechanism, first: Spot, second: Spot, start: State) -> float:
    """As stated; else as in the poses if they have all angles; else 0."""
    if element["angle"] is not None:
        stated = mechanism.number(element["angle"])
        return stated if element["points"][1].body is not None else -stated
    joined = [spot.body for spot in (first, second) if spot.body >= 0]
    if any(mechanism.problem.bodies[k].angle is None for k in joined):
        return 0.0
    return turn(first.body, second.body)(start, start).value
