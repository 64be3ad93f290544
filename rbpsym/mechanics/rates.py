"""Conditions for the speeds: no slip, taut strings. Those that are rates of a position are integrated.

A condition Σ a_i(q, t) q̇_i + b(q, t) = 0 with ∂a_i/∂q_j = ∂a_j/∂q_i is the rate of a function
F(q, t), so F keeps the value that it has at the start; the others stay as equations for the speeds
(non-holonomic conditions). Goldstein, Classical Mechanics, 1.3.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.integration import antiderivative
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import NOTHING, UNITY, Scalar, symbol
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.geometry import Geometry
from rbpsym.mechanics.system import Condition, Force
from rbpsym.statement.model import Element, Problem

CLOCK = "t"


def rate_conditions(problem: Problem, geometry: Geometry) -> list[Condition]:
    """The conditions of all constraints that are linear in the speeds, at the states of `geometry`."""
    return [c for element in problem.constraints for c in _of(element, geometry)]


def _of(element: Element, geometry: Geometry) -> list[Condition]:
    joint = JOINTS[element.kind]
    wanted = joint.rates(element, geometry)
    forces = joint.forces(element, geometry) if wanted else ()
    return [
        Condition(element.name, short(factor * _power_of_unit(forces, name, geometry)), element.kind)
        for name, factor in wanted
    ]


def _power_of_unit(forces: Sequence[Force], name: str, geometry: Geometry) -> Scalar:
    """Σ F·v for the unknown force at 1."""
    total = NOTHING
    for force in forces:
        push = force.vector.derivative(name)
        if push:
            total = total + push.dot(geometry.velocity(force.on, force.point))
    return total


def integrated(value: Scalar, names: Sequence[str]) -> Scalar | None:
    """F(q, t) with dF/dt = value; None if there is none in the class of `antiderivative`."""
    slopes = {name: derivative(value, f"{name}_dot") for name in names}
    slopes[CLOCK] = substitute(value, {f"{name}_dot": NOTHING for name in names})
    slopes = {name: slope for name, slope in slopes.items() if not is_zero(slope)}
    total = NOTHING
    for name, slope in slopes.items():
        rest = short(slope - derivative(total, name))
        part = antiderivative(rest, name) if rest else NOTHING
        if part is None:
            return None
        total = total + part
    wanted = (slopes.get(name, NOTHING) - derivative(total, name) for name in (*names, CLOCK))
    return total if all(map(is_zero, wanted)) else None


def from_start(value: Scalar, names: Sequence[str], start: Mapping[str, Scalar]) -> Scalar:
    """F - F(start) if all coordinates in it have a declared start; else F: the others count from there."""
    used = [name for name in names if depends_on(value, name)]
    if not all(name in start for name in used):
        return value
    return short(value - substitute(value, {name: start[name] for name in used} | {CLOCK: NOTHING}))


def full_rates(names: Sequence[str]) -> dict[str, Scalar]:
    """Rates of coordinates whose speeds are all free, and of the time."""
    return {name: symbol(f"{name}_dot") for name in names} | {CLOCK: UNITY}
