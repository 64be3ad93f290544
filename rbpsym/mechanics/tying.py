"""What the constraints make of the coordinates: solved for, tied by equations, tied in their speeds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.evaluate import Scope, scalar, time_derivative
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Vector
from rbpsym.mechanics.conditions import all_conditions, solve_explicitly
from rbpsym.mechanics.geometry import Geometry, start_numbers
from rbpsym.mechanics.inertia import Inertia
from rbpsym.mechanics.placing import locator
from rbpsym.mechanics.rates import from_start, full_rates, integrated, rate_conditions
from rbpsym.mechanics.system import BodyState, Condition, Pose, at_point
from rbpsym.statement.model import Problem


@dataclass(frozen=True)
class Tied:
    """`solved`: names in terms of the others; `implicit`: conditions that stay as equations;
    `speeds`: conditions on the speeds that are no rates; `conditions`: all on the position."""

    solved: Mapping[str, Scalar]
    implicit: tuple[Condition, ...]
    speeds: tuple[Condition, ...]
    conditions: tuple[Condition, ...]


def tie(problem: Problem, inertias: Mapping[str, Inertia], given: Mapping[str, Pose], names: tuple[str, ...]) -> Tied:
    """Conditions on the position first; then those on the speeds, integrated one after the other."""
    conditions = all_conditions(problem, _geometry(problem, inertias, given))
    solved, implicit = solve_explicitly(conditions, names, problem)
    waiting = _rates(problem, inertias, given, solved, names)
    while (found := _first_integral(waiting, names, problem)) is not None:
        conditions = (*conditions, found)
        solved, implicit = solve_explicitly(conditions, names, problem)
        waiting = _rates(problem, inertias, given, solved, names)
    return Tied(solved, implicit, tuple(waiting), conditions)


def _geometry(problem: Problem, inertias: Mapping[str, Inertia], placed: Mapping[str, Pose]) -> Geometry:
    return Geometry(locator(problem, inertias, placed), placed, start_numbers(problem))


def _rates(problem: Problem, inertias, given, solved: Mapping[str, Scalar], names: tuple[str, ...]) -> list[Condition]:
    """The conditions on the speeds that do not hold identically, in the names that are left."""
    placed = {n: Pose(p.origin.substitute(solved), substitute(p.angle, solved)) for n, p in given.items()}
    scope = Scope(rates=full_rates([name for name in names if name not in solved]))
    geometry = _geometry(problem, inertias, placed)
    states = {name: _state(name, inertias[name], pose, scope) for name, pose in placed.items()}
    moving = Geometry(geometry.where, placed, geometry.numbers, states)
    return [c for c in rate_conditions(problem, moving) if not is_zero(c.value)]


def _state(name: str, own: Inertia, pose: Pose, scope: Scope) -> BodyState:
    center = at_point(pose, (own.x, own.y)) if own.x or own.y else pose.origin
    velocity = sum((center.derivative(n) * speed for n, speed in scope.rates.items()), Vector({}))
    return BodyState(name, own, pose, center, velocity, time_derivative(pose.angle, scope))


def _first_integral(waiting: list[Condition], names: tuple[str, ...], problem: Problem) -> Condition | None:
    """The first condition that is the rate of a position, integrated from the start."""
    start = {c.name: scalar(c.start) for c in problem.coordinates if c.start is not None}
    for condition in waiting:
        found = integrated(condition.value, names)
        if found is not None:
            return Condition(condition.constraint, from_start(found, names, start), condition.what)
    return None
