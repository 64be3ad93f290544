"""Motion from the start state: squares of speeds and forces as functions of position."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.integration import definite
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.poly import Poly
from rbpsym.algebra.roots import without_even_roots
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.system import System


def speed_squared(system: System, dynamics: Dynamics, integral: Scalar | None) -> dict[str, Scalar]:
    """For each coordinate for which it is a function of position: the square of its speed.

    For several degrees of freedom, for each coordinate whose acceleration depends on itself alone; then,
    for the one that is left, from the first integral. Coordinates without a start are left out.
    """
    alone = len(system.independent) == 1 and integral is not None
    found = {} if alone else _decoupled(system, dynamics)
    left = [name for name in system.independent if name not in found]
    if len(left) == 1 and integral is not None:
        square = from_integral(system, integral, left[0], found)
        found |= {} if square is None else {left[0]: square}
    return found


def from_integral(system: System, integral: Scalar, name: str, known: Mapping[str, Scalar]) -> Scalar | None:
    """q̇² from (½ m(q) q̇² + U(q)) at start and now, the squares of the other speeds being known."""
    speed = f"{name}_dot"
    if any(other not in system.scope.start for other in (name, *_coordinates_in(integral, system))):
        return None
    now: Scalar | None = integral
    for other, square in known.items():
        now = now if now is None else _without_speed(_at_rest(now, other, square), f"{other}_dot", square)
    if now is None:
        return None
    half_mass = derivative(derivative(now, speed), speed) / 2
    rest = substitute(now, {speed: NOTHING})
    if not is_zero(now - half_mass * symbol(speed) ** 2 - rest):
        return None
    start = substitute(integral, system.scope.start)
    return short(without_even_roots((start - rest) / half_mass))


def _at_rest(value: Scalar, name: str, square: Scalar) -> Scalar:
    """The value with a speed that is known to stay zero."""
    return value if square else substitute(value, {f"{name}_dot": NOTHING})


def _coordinates_in(value: Scalar, system: System) -> list[str]:
    return [name for name in (*system.coordinates, "t") if depends_on(value, name)]


def _decoupled(system: System, dynamics: Dynamics) -> dict[str, Scalar]:
    found = {}
    for name in system.independent:
        acceleration = (dynamics.accelerations or {}).get(f"{name}_ddot")
        if acceleration is None or name not in system.scope.start or not _alone(system, acceleration, name):
            continue
        gained = definite(acceleration, name, system.scope.start[name], symbol(name))
        if gained is not None:
            speed = system.scope.start.get(f"{name}_dot", NOTHING)
            found[name] = short(speed * speed + gained * 2)
    return found


def _alone(system: System, value: Scalar, name: str) -> bool:
    others = [n for n in system.coordinates if n != name] + [f"{n}_dot" for n in system.coordinates] + ["t"]
    return not any(depends_on(value, other) for other in others)


def along_motion(value: Scalar, squares: Mapping[str, Scalar]) -> Scalar | None:
    """The value with even powers of speeds replaced; None if a speed remains."""
    for name, square in squares.items():
        value = _without_speed(value, f"{name}_dot", square)
        if value is None:
            return None
    remaining = [n for i in value.atoms() if (n := atoms.symbol_name(i)) and n.endswith(("_dot", "_ddot"))]
    return None if remaining else short(value)


def _without_speed(value: Scalar, speed: str, square: Scalar) -> Scalar | None:
    index = atoms.intern("symbol", speed)
    if index not in value.atoms():
        return value
    top = _replaced(value.num, index, square)
    low = _replaced(value.den, index, square)
    return None if top is None or low is None else top / low


def _replaced(poly: Poly, index: int, square: Scalar) -> Scalar | None:
    total = NOTHING
    for power, part in poly.by_power(index).items():
        if power % 2 or power < 0:
            return None
        total = total + Scalar(part) * square ** (power // 2)
    return total
