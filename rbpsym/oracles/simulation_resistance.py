"""Resistances as numbers: a force against the velocity of a point, a couple against the turning of two bodies.

Of the derivation only the sense of the motion is taken: the size, the direction and the share of each unknown force are worked
out from the statement.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from rbpsym.elements.interactions import INTERACTIONS, LETTERS
from rbpsym.elements.kinds import Parts
from rbpsym.field import names_in
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.numbers import Values
from rbpsym.oracles.simulation_bodies import Coordinates, Law, Load, Mechanism, State
from rbpsym.oracles.simulation_joints import Drag, Entries, Kept
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.model import Element

Sizes = Callable[[State, State, float], list[float]]
Against = Callable[[State, State], tuple[float, list[Load]]]  # what the letter for the speed is, and the loads of size 1


AGAINST: Parts[Callable[[Element, Mechanism, Coordinates], Against]] = Parts(INTERACTIONS, "row", "against")


def _sizes(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> tuple[tuple[str, ...], Sizes]:
    """(unknown forces, what gives the size without them and the share of each)."""
    size, letter = scalar(element["size"]), LETTERS[element.kind]
    unknown = {name for each in mechanism.problem.constraints for name in unknowns_of(each)}
    used = tuple(sorted(names_in(size) & unknown))

    def sizes(where: State, speed: State, rate: float) -> list[float]:
        known = {**coordinates(where, speed), letter: rate, **dict.fromkeys(used, 0.0)}
        bare = Values(known).of(size)
        return [bare, *(Values({**known, name: 1.0}).of(size) - bare for name in used)]

    return used, sizes


def law(element: Element, mechanism: Mechanism, coordinates: Coordinates) -> Law:
    """The part of it that no unknown force has to do with."""
    against, (_, sizes) = AGAINST[element.kind](element, mechanism, coordinates), _sizes(element, mechanism, coordinates)

    def loads(where: State, speed: State) -> list[Load]:
        rate, found = against(where, speed)
        bare = sizes(where, speed, rate)[0]
        return [replace(load, x=bare * load.x, y=bare * load.y, torque=bare * load.torque) for load in found]

    return loads


def with_shares(kept: list[Kept], mechanism: Mechanism, coordinates: Coordinates) -> list[Kept]:
    """The conditions with what resists in proportion to the unknown forces that keep them."""
    for element in mechanism.problem.of_kind(*LETTERS):
        against, (used, sizes) = AGAINST[element.kind](element, mechanism, coordinates), _sizes(element, mechanism, coordinates)
        for place, name in enumerate(used, 1):
            drag = Drag(element.name, _share(against, sizes, place), strikes=False)
            kept = [replace(one, drags=(*one.drags, drag)) if one.multiplier == name else one for one in kept]
    return kept


def _share(against: Against, sizes: Sizes, place: int) -> Callable[[State, State], Entries]:
    def entries(where: State, speed: State) -> Entries:
        rate, found = against(where, speed)
        share = sizes(where, speed, rate)[place]
        return [(3 * load.body + k, share * part) for load in found for k, part in enumerate((load.x, load.y, load.torque))]

    return entries
