"""A tension for each run of a string: for the speeds along it, or the length of a straight piece."""

import cmath

from rbpsym.expr.tree import neg
from rbpsym.oracles.simulation_contacts import Complex, Point, Push, Pushes, kept_by, spot_at
from rbpsym.oracles.simulation_joints import Element, Kept, Mechanism, State, driven
from rbpsym.statement.model import Turn
from rbpsym.statement.paths import runs, tensions


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """A condition for each run."""
    found = zip(tensions(element), runs(element["path"]), strict=True)
    return [_along_run(element, name, run, mechanism) for name, run in found]


def _along_run(element: Element, name: str, run: tuple[Turn, ...], mechanism: Mechanism) -> Kept:
    pushes, length = _pulls(run, mechanism), element["length"]
    if length is None:
        return kept_by(element.name, name, pushes)
    first, second = (mechanism.spot(turn.center) for turn in run)

    def shrunk(where: Complex) -> complex:
        (ax, ay), (bx, by) = spot_at(first, where), spot_at(second, where)
        return -cmath.sqrt((bx - ax) ** 2 + (by - ay) ** 2)

    return driven(element.name, name, kept_by(element.name, name, pushes, shrunk).at, neg(length), mechanism)


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
    """u with d = L u + offset k×u; none where the two are at one place."""
    square = dx * dx + dy * dy
    if not square:
        return 0j, 0j
    length = cmath.sqrt(square - offset * offset)
    return (dx * length + dy * offset) / square, (dy * length - dx * offset) / square
