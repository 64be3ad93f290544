"""Fixed points about which angular momenta and torques are taken."""

from __future__ import annotations

from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.vector import ORIGIN, Vector
from rbpsym.mechanics.placing import locator
from rbpsym.mechanics.points import pair
from rbpsym.mechanics.system import System
from rbpsym.statement.letters import letters_of


def origins(system: System) -> dict[str, Vector]:
    """Name → position: O, the places of pivots that are elsewhere, the author's origins."""
    found, letters = {"O": ORIGIN}, letters_of(system.problem)
    where = locator(
        system.problem, {n: s.inertia for n, s in system.bodies.items()}, {n: s.pose for n, s in system.bodies.items()}
    )
    for element in system.problem.constraints:
        if element.kind == "pivot":
            place = where(element["point"])
            if _is_fixed(place, system) and not any(_same(place, other) for other in found.values()):
                found[letters.free(f"P_{element.name}", taken=letters.things)] = place
    for name, ref in system.problem.origins.items():
        place = pair(ref.at) if ref.body is None else where(ref)
        if _is_fixed(place, system) and not any(_same(place, other) for other in found.values()):
            found[name] = place
    return found


def _is_fixed(place: Vector, system: System) -> bool:
    rates = [place.derivative(name) for name in (*system.coordinates, "t")]
    return all(is_zero(rate.x) and is_zero(rate.y) for rate in rates)


def _same(a: Vector, b: Vector) -> bool:
    difference = a - b
    return is_zero(difference.x) and is_zero(difference.y)
