"""A point that stays where it is, or where its support moves."""

from rbpsym.oracles.simulation_joints import Element, Kept, Mechanism, Spot, State, component, driven, placed, together


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """`start` says where it is held if the statement does not."""
    held, at = mechanism.spot(element["point"]), element["at"]
    if at is not None and not mechanism.is_constant(*at):
        ways = (("x", 1.0, 0.0, at[0]), ("y", 0.0, 1.0, at[1]))
        return [driven(element.name, f"{element.name}_{a}", component(held, *d), n, mechanism) for a, *d, n in ways]
    here = placed(held, start, [0.0] * len(start)).place if at is None else mechanism.pair(at)
    return together(Spot(-1, *here), held, element.name)
