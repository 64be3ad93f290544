"""Constraints in maximal coordinates, each a list of scalar conditions: what the rows of joints and of what is driven share.

A multiplier is the unknown force (or couple) of the statement itself: the row of a condition is
the force's direction on the body that the statement means.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from rbpsym.elements.interactions import INTERACTIONS, LETTERS
from rbpsym.elements.kinds import KindParts
from rbpsym.expr.tree import Node
from rbpsym.field import derivative, names_in
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.numbers import Values
from rbpsym.oracles.simulation_bodies import Coordinates, Law, Load, Mechanism, Spot, State, placed
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.model import Element

Entries = list[tuple[int, float]]


class StateRow(Frozen):
    """A condition at a state: value (to vanish), its derivatives by X and by t, and d²/dt² at A = 0."""

    value: float
    entries: Entries
    bias: float
    drift: float = 0.0


class Drag(Frozen):
    """A force `name` in proportion to a multiplier that is no ideal force (kinetic friction μN); `strikes`: in a blow too."""

    name: str
    at: Callable[[State, State], Entries]
    strikes: bool = True


class Kept(Frozen):
    """A scalar condition that the `multiplier` of the force (or couple) `name` keeps.

    `is_place`: whether it is one for the position (else for the speeds alone, its value 0).
    """

    name: str
    multiplier: str
    at: Callable[[State, State], StateRow]
    is_place: bool = True
    drags: tuple[Drag, ...] = ()

    @property
    def force(self) -> str:
        """The name of the force in the ledger: the constraint's, or (friction, tension) its own."""
        return self.name if self.is_place else self.multiplier


Condition = Callable[[State, State], StateRow]


def component(spot: Spot, dx: float, dy: float) -> Condition:
    """The place of a spot along a direction."""

    def row(where: State, speed: State) -> StateRow:
        at = placed(spot, where, speed)
        return StateRow(dx * at.place[0] + dy * at.place[1], at.along(dx, dy), dx * at.bias[0] + dy * at.bias[1])

    return row


def turn(first: int, second: int) -> Condition:
    """φ_second - φ_first of two bodies by their numbers, -1 for the ground."""
    ends = [(3 * k + 2, sign) for k, sign in ((second, 1.0), (first, -1.0)) if k >= 0]
    return lambda where, speed: StateRow(sum(sign * where[column] for column, sign in ends), ends, 0.0)


def difference(first: Condition, second: Condition) -> Condition:
    """The second less the first."""
    def row(where: State, speed: State) -> StateRow:
        a, b = first(where, speed), second(where, speed)
        return StateRow(b.value - a.value, b.entries + [(k, -entry) for k, entry in a.entries], b.bias - a.bias)

    return row


def together(first: Spot, second: Spot, name: str) -> list[Kept]:
    """second - first = 0; the force is on the body of the second."""
    ways = (("x", 1.0, 0.0), ("y", 0.0, 1.0))
    rows = ((axis, difference(component(first, *way), component(second, *way))) for axis, *way in ways)
    return [Kept(name, f"{name}_{axis}", row) for axis, row in rows]


def turning(first: int, second: int, offset: float, element: Element) -> Kept:
    """φ_second - φ_first = offset; the couple is on the second."""
    angle = turn(first, second)

    def row(where: State, speed: State) -> StateRow:
        found = angle(where, speed)
        return StateRow(found.value - offset, found.entries, found.bias)

    return Kept(element["couple"], element["couple"], row)


def ends_of(element: Element, mechanism: Mechanism) -> tuple[Spot, Spot]:
    """The two ends, the one on a body second."""
    first, second = (mechanism.spot(ref) for ref in element["points"])
    return (first, second) if second.body >= 0 else (second, first)


def driven(name: str, multiplier: str, quantity: Condition, node: Node, mechanism: Mechanism) -> Kept:
    """A quantity of the bodies that equals a function of time."""
    wanted = scalar(node)
    speed_wanted = derivative(wanted, "t")
    gain_wanted = derivative(speed_wanted, "t")

    def row(where: State, speed: State) -> StateRow:
        own = quantity(where, speed)
        at, rate, gain = (mechanism.at_time(value) for value in (wanted, speed_wanted, gain_wanted))
        return StateRow(own.value - at, own.entries, own.bias - gain, -rate)

    return Kept(name, multiplier, row)


# --- resistances as numbers: a force against the velocity of a point, a couple against the turning of two bodies
# Of the derivation only the sense of the motion is taken: the size, the direction and the share of each unknown force are worked
# out from the statement.


Sizes = Callable[[State, State, float], list[float]]
Against = Callable[[State, State], tuple[float, list[Load]]]  # what the letter for the speed is, and the loads of size 1


AGAINST: KindParts[Callable[[Element, Mechanism, Coordinates], Against]] = KindParts(INTERACTIONS, "row", "against")


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
