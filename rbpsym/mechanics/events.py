"""Where a contact is lost: the first zero of its normal force along the motion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.scalar import Scalar
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.roots import factor_zeros, numerator_factors
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Element
from rbpsym.statement.paths import tensions

EDGE = 1e-9  # a zero at the end of the range is not a loss on the way


@dataclass(frozen=True, slots=True)
class Loss:
    """`force` vanishes where `factor` does; `at` are the places in closed form, by coordinate."""

    force: str
    factor: Scalar
    at: Mapping[str, Scalar]
    coordinate: str


def losses(system: System, along: Mapping[str, Scalar]) -> tuple[Loss, ...]:
    """The contacts that end during the motion from the start (none where coordinates stay tied implicitly)."""
    found: list[Loss] = []
    if system.implicit:
        return ()
    for element in system.problem.constraints:
        for name in pushes(element):
            found += _of(system, name, along[name]) if name in along else []
    return tuple(found)


def pushes(element: Element) -> tuple[str, ...]:
    """The unknown forces of an element that can push (or pull) only: normal forces, tensions."""
    if not JOINTS[element.kind].is_one_sided:
        return ()
    return tensions(element) if element.kind == "string" else (element.name,)


def _of(system: System, name: str, value: Scalar) -> list[Loss]:
    result = []
    for factor in map(Scalar, numerator_factors(value)):
        coordinate = next((n for n in system.independent if depends_on(factor, n)), None)
        if coordinate is None:
            continue
        places = [z for z in factor_zeros(factor, coordinate) if _reached(system, coordinate, z)]
        if places or _changes_sign(system, coordinate, factor):
            result.append(Loss(name, factor, {coordinate: places[0]} if places else {}, coordinate))
    return result


def _bounds(system: System, name: str, numbers: Mapping[str, float]) -> tuple[float, float]:
    from rbpsym.algebra.evaluate import scalar

    coordinate = next(c for c in system.problem.coordinates if c.name == name)
    low, high = (None if b is None else number(scalar(b), numbers) for b in (coordinate.lower, coordinate.upper))
    return (-3.2 if low is None else low), (3.2 if high is None else high)


def _reached(system: System, name: str, place: Scalar) -> bool:
    numbers = sample(system.problem)
    try:
        low, high = _bounds(system, name, numbers)
        return low + EDGE < number(place, numbers) < high - EDGE
    except (ValueError, ZeroDivisionError, KeyError):
        return False


def _changes_sign(system: System, name: str, factor: Scalar, steps: int = 200) -> bool:
    """Whether sample numbers show a zero inside the range (only then is a condition reported)."""
    numbers = sample(system.problem)
    low, high = _bounds(system, name, numbers)
    signs = set()
    for k in range(1, steps):
        value = number(factor, {**numbers, name: low + (high - low) * k / steps})
        signs.add(value > 0)
    return len(signs) == 2
