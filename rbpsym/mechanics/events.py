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


def losses(system: System, along: Mapping[str, Scalar], squares: Mapping[str, Scalar]) -> tuple[Loss, ...]:
    """The contacts that end during the motion from the start (none where coordinates stay tied implicitly).

    `squares` are those of the speeds as functions of position: where one is negative, the motion does not come.
    """
    found: list[Loss] = []
    if system.implicit:
        return ()
    for element in system.problem.constraints:
        for name in pushes(element):
            found += _of(system, name, along[name], squares) if name in along else []
    return tuple(found)


def pushes(element: Element) -> tuple[str, ...]:
    """The unknown forces of an element that can push (or pull) only: normal forces, tensions."""
    if not JOINTS[element.kind].is_one_sided or element.values.get("rigid"):
        return ()
    return tensions(element) if element.kind == "string" else (element.name,)


def _of(system: System, name: str, value: Scalar, squares: Mapping[str, Scalar]) -> list[Loss]:
    result = []
    for factor in map(Scalar, numerator_factors(value)):
        coordinate = next((n for n in system.independent if depends_on(factor, n)), None)
        if coordinate is None:
            continue
        square = squares.get(coordinate)
        places = [z for z in factor_zeros(factor, coordinate) if _reached(system, coordinate, z, square)]
        if places or _changes_sign(system, coordinate, factor, square):
            result.append(Loss(name, factor, {coordinate: places[0]} if places else {}, coordinate))
    return result


def _bounds(system: System, name: str, numbers: Mapping[str, float]) -> tuple[float, float]:
    from rbpsym.algebra.evaluate import scalar

    coordinate = system.problem.coordinate(name)
    low, high = (None if b is None else number(scalar(b), numbers) for b in (coordinate.lower, coordinate.upper))
    return (-3.2 if low is None else low), (3.2 if high is None else high)


def _reached(system: System, name: str, place: Scalar, square: Scalar | None) -> bool:
    numbers = sample(system.problem)
    try:
        low, high = _bounds(system, name, numbers)
        here = number(place, numbers)
        return low + EDGE < here < high - EDGE and _is_on_the_way(name, here, square, numbers)
    except (ValueError, ZeroDivisionError, KeyError):
        return False


def _is_on_the_way(name: str, here: float, square: Scalar | None, numbers: Mapping[str, float]) -> bool:
    """Does the motion come there: is the square of the speed not negative?"""
    return square is None or number(square, {**numbers, name: here}) > -EDGE


def _changes_sign(system: System, name: str, factor: Scalar, square: Scalar | None, steps: int = 200) -> bool:
    """Whether sample numbers show a zero inside the range (only then is a condition reported)."""
    numbers = sample(system.problem)
    low, high = _bounds(system, name, numbers)
    signs = set()
    for k in range(1, steps):
        here = low + (high - low) * k / steps
        if _is_on_the_way(name, here, square, numbers):
            signs.add(number(factor, {**numbers, name: here}) > 0)
    return len(signs) == 2
