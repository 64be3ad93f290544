"""Strings in maximal coordinates: the tension's direction at every place where it pulls."""

from __future__ import annotations

import cmath
from collections.abc import Callable

from rbpsym.statement.model import Element, Turn
from rbpsym.statement.paths import runs, tensions
from rbpsym.verify.simulation_bodies import Mechanism, State
from rbpsym.verify.simulation_contacts import Complex, Point, Push, Pushes, kept_by, spot_at
from rbpsym.verify.simulation_joints import Kept


def string(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """A tension for each run of the string, for the speeds along it."""
    return [
        kept_by(element.name, name, _pulls(run, mechanism), _stretch(element, run, mechanism))
        for name, run in zip(tensions(element), runs(element["path"]), strict=True)
    ]


def _stretch(element: Element, run: tuple[Turn, ...], mechanism: Mechanism) -> Callable[[Complex], complex] | None:
    """Natural length minus length, for a straight piece whose length is given."""
    if element["length"] is None:
        return None
    first, second = (mechanism.spot(turn.center) for turn in run)
    length = mechanism.number(element["length"])

    def gap(where: Complex) -> complex:
        (ax, ay), (bx, by) = spot_at(first, where), spot_at(second, where)
        return length - cmath.sqrt((bx - ax) ** 2 + (by - ay) ** 2)

    return gap


def _pulls(run: tuple[Turn, ...], mechanism: Mechanism) -> Pushes:
    circles = [(mechanism.spot(turn.center), turn.sense * mechanism.number(turn.radius)) for turn in run]

    def pushes(where: Complex) -> list[Push]:
        found = []
        for (first, r1), (second, r2) in zip(circles, circles[1:], strict=False):
            (ax, ay), (bx, by) = spot_at(first, where), spot_at(second, where)
            ux, uy = _along(bx - ax, by - ay, r2 - r1)
            found += [
                Push(first.body, (ax + r1 * uy, ay - r1 * ux), ux, uy),
                Push(second.body, (bx + r2 * uy, by - r2 * ux), -ux, -uy),
            ]
        return found

    return pushes


def _along(dx: complex, dy: complex, offset: complex) -> Point:
    """u with d = L u + offset k×u."""
    square = dx * dx + dy * dy
    length = cmath.sqrt(square - offset * offset)
    return (dx * length + dy * offset) / square, (dy * length - dx * offset) / square
