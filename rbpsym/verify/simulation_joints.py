"""Constraints in maximal coordinates: each a list of scalar conditions with a multiplier.

A multiplier is the unknown force (or couple) of the statement itself: the row of a condition is
the force's direction on the body that the statement means. A new kind is a new entry of
`JOINTS`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from rbpsym.errors import NotApplicable
from rbpsym.statement.model import Element
from rbpsym.verify.simulation_bodies import Mechanism, Spot, State, placed

Entries = list[tuple[int, float]]


@dataclass(frozen=True, slots=True)
class Row:
    """A condition at a state: value (to vanish), its derivatives by X and by t, and d²/dt² at A = 0."""

    value: float
    entries: Entries
    bias: float
    drift: float = 0.0


@dataclass(frozen=True, slots=True)
class Drag:
    """A force `name` in proportion to a multiplier that is no ideal force (kinetic friction μN)."""

    name: str
    at: Callable[[State, State], Entries]


@dataclass(frozen=True, slots=True)
class Kept:
    """A scalar condition that the `multiplier` of the force (or couple) `name` keeps.

    `is_place`: whether it is one for the position (else for the speeds alone, its value 0).
    """

    name: str
    multiplier: str
    at: Callable[[State, State], Row]
    is_place: bool = True
    drag: Drag | None = None

    @property
    def force(self) -> str:
        """The name of the force in the ledger: the constraint's, or (friction, tension) its own."""
        return self.name if self.is_place else self.multiplier


def _meeting(first: Spot, second: Spot, name: str) -> list[Kept]:
    """second - first = 0; the force is on the body of the second."""

    def along(dx: float, dy: float) -> Callable[[State, State], Row]:
        def row(where: State, speed: State) -> Row:
            a, b = placed(first, where, speed), placed(second, where, speed)
            gap = [dx * (q[0] - p[0]) + dy * (q[1] - p[1]) for p, q in ((a.place, b.place), (a.bias, b.bias))]
            return Row(gap[0], b.along(dx, dy) + a.along(-dx, -dy), gap[1])

        return row

    return [Kept(name, f"{name}_x", along(1.0, 0.0)), Kept(name, f"{name}_y", along(0.0, 1.0))]


def turning(first: int, second: int, offset: float, element: Element) -> Kept:
    """φ_second - φ_first = offset; the couple is on the second."""

    def row(where: State, speed: State) -> Row:
        ends = [(k, sign) for k, sign in ((second, 1.0), (first, -1.0)) if k >= 0]
        value = sum(sign * where[3 * k + 2] for k, sign in ends) - offset
        return Row(value, [(3 * k + 2, sign) for k, sign in ends], 0.0)

    return Kept(element["couple"], element["couple"], row)


def _pivot(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    held = mechanism.spot(element["point"])
    if element["at"] is not None and not mechanism.is_constant(*element["at"]):
        from rbpsym.verify.simulation_drives import driven_pivot

        return driven_pivot(element, mechanism)
    here = placed(held, start, [0.0] * len(start)).place if element["at"] is None else mechanism.pair(element["at"])
    return _meeting(Spot(-1, *here), held, element.name)


def _ends(element: Element, mechanism: Mechanism) -> tuple[Spot, Spot]:
    """The two ends, the one on a body second."""
    first, second = (mechanism.spot(ref) for ref in element["points"])
    return (first, second) if second.body >= 0 else (second, first)


def _pin(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    return _meeting(*_ends(element, mechanism), element.name)


def _weld(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    first, second = _ends(element, mechanism)
    offset = _weld_angle(element, mechanism, first, second, start)
    return [*_meeting(first, second, element.name), turning(first.body, second.body, offset, element)]


def _weld_angle(element: Element, mechanism: Mechanism, first: Spot, second: Spot, start: State) -> float:
    """As stated; else as in the poses if they have all angles; else 0."""
    if element["angle"] is not None:
        stated = mechanism.number(element["angle"])
        return stated if element["points"][1].body is not None else -stated
    joined = [spot.body for spot in (first, second) if spot.body >= 0]
    if any(mechanism.problem.bodies[k].angle is None for k in joined):
        return 0.0
    return start[3 * second.body + 2] - (start[3 * first.body + 2] if first.body >= 0 else 0.0)


JOINTS: Mapping[str, Callable[[Element, Mechanism, State], list[Kept]]] = {
    "pivot": _pivot,
    "pin": _pin,
    "weld": _weld,
}


def conditions(mechanism: Mechanism, start: State) -> list[Kept]:
    """All conditions of a statement; `start` says where a pivot without a place holds its point."""
    from rbpsym.verify.simulation_kinds import KINDS

    found, known = [], {**JOINTS, **KINDS}
    for element in mechanism.problem.constraints:
        if element.kind not in known:
            raise NotApplicable(f"the simulation does not know the constraint {element.kind}")
        found += known[element.kind](element, mechanism, start)
    return found
