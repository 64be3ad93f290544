"""The position of rest of one coordinate whose equation has no solution in closed form."""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.algebra import NOTHING, Scalar, derivative, substitute, symbol
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.signs import sign
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.rest import resting_forces
from rbpsym.mechanics.system import System

OPPOSITE = {"positive": "negative", "negative": "positive"}


@dataclass(frozen=True, slots=True)
class Balance:
    """The one coordinate, the generalized `force` along it at rest and its derivative (the `slope`).

    `stable`: whether the slope is negative (positive: False) throughout the range, None if its sign
    is not known; `ends`: the force at the two ends of the range where its signs differ, else empty.
    `place` is the name of the coordinate's value there; `frequency_squared` of the small
    oscillation about it, in that name, if it is stable and nothing damps it; `decay`, where something does, the squares of the
    frequency without it and what the acceleration loses per speed.
    """

    name: str
    force: Scalar
    slope: Scalar
    stable: bool | None
    ends: tuple[Scalar, ...]
    place: str
    frequency_squared: Scalar | None
    decay: tuple[Scalar, Scalar] | None = None


def balance(system: System, dynamics: Dynamics, assumptions: Assumptions) -> Balance | None:
    """The position of rest of a system with one coordinate whose equation has no solution in closed form."""
    if len(system.independent) != 1:
        return None
    [name], [force] = system.independent, resting_forces(system, dynamics)
    slope = short(derivative(force, name))
    stable = {"negative": True, "positive": False}.get(sign(slope, assumptions).kind)
    place = _free(f"{name}_e", system)
    there = {name: symbol(place)}
    mass, drag = substitute(dynamics.mass_matrix[0][0], there), _drag(system, dynamics, there)
    square = short(-(substitute(slope, there) / mass)) if stable else None
    ends = _ends(system, force, name, assumptions)
    if square is None or not drag:
        return Balance(name, force, slope, stable, ends, place, square)
    decay = (square, short(-(drag / mass))) if sign(drag, assumptions).kind == "negative" else None
    return Balance(name, force, slope, stable, ends, place, None, decay)


def _drag(system: System, dynamics: Dynamics, there: dict[str, Scalar]) -> Scalar:
    """What the force along the coordinate has per speed, close to the place."""
    [force], [speed] = dynamics.forcing, system.speeds
    return short(substitute(substitute(derivative(force, speed), {speed: NOTHING}), there))


def _free(name: str, system: System) -> str:
    taken = {q.name for q in (*system.problem.parameters, *system.problem.coordinates)}
    return f"{name}q" if name in taken else name


def _ends(system: System, force: Scalar, name: str, assumptions: Assumptions) -> tuple[Scalar, ...]:
    bounds = assumptions.range_of(name)
    if None in bounds:
        return ()
    try:
        found = tuple(short(substitute(force, {name: bound})) for bound in bounds)
    except ZeroDivisionError:
        return ()
    lower, upper = (sign(value, assumptions).kind for value in found)
    return found if lower in OPPOSITE and upper == OPPOSITE[lower] else ()
