"""Points, bodies and pivots in maximal coordinates that are driven: functions of time."""

from __future__ import annotations

from collections.abc import Callable

from rbpsym.algebra.calculus import derivative
from rbpsym.algebra.evaluate import scalar
from rbpsym.notation.tree import Node
from rbpsym.statement.model import Element
from rbpsym.verify.simulation_bodies import Mechanism, Spot, State, placed
from rbpsym.verify.simulation_joints import Kept, Row


def _driven(
    name: str, multiplier: str, entries_of: Callable[[State, State], Row], node: Node, mechanism: Mechanism
) -> Kept:
    """A quantity of the bodies that equals a function of time."""
    wanted = scalar(node)
    speed_wanted = derivative(wanted, "t")
    gain_wanted = derivative(speed_wanted, "t")

    def row(where: State, speed: State) -> Row:
        own = entries_of(where, speed)
        at, rate, gain = (mechanism.at_time(value) for value in (wanted, speed_wanted, gain_wanted))
        return Row(own.value - at, own.entries, own.bias - gain, -rate)

    return Kept(name, multiplier, row)


def _component(spot: Spot, dx: float, dy: float) -> Callable[[State, State], Row]:
    def row(where: State, speed: State) -> Row:
        at = placed(spot, where, speed)
        return Row(dx * at.place[0] + dy * at.place[1], at.along(dx, dy), dx * at.bias[0] + dy * at.bias[1])

    return row


def driven_point(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """A point driven along a direction; the force is along it."""
    along = _component(mechanism.spot(element["point"]), *mechanism.pair(element["along"]))
    return [_driven(element.name, element.name, along, element["distance"], mechanism)]


def driven_angle(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """A body that is turned; the couple is the multiplier."""
    column = 3 * mechanism.body_number(element["body"]) + 2
    base = 3 * mechanism.body_number(element["of"]) + 2 if element["of"] else None

    def turn(where: State, speed: State) -> Row:
        if base is None:
            return Row(where[column], [(column, 1.0)], 0.0)
        return Row(where[column] - where[base], [(column, 1.0), (base, -1.0)], 0.0)

    return [_driven(element.name, element.name, turn, element["angle"], mechanism)]


def driven_pivot(element: Element, mechanism: Mechanism) -> list[Kept]:
    """A pivot whose support moves."""
    spot = mechanism.spot(element["point"])
    return [
        _driven(element.name, f"{element.name}_{axis}", _component(spot, *direction), node, mechanism)
        for axis, direction, node in zip("xy", ((1.0, 0.0), (0.0, 1.0)), element["at"], strict=True)
    ]
