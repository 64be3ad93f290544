"""The system in the coordinates as the author gave them: what the constraints tie is not yet put in.

Here a condition can be seen (ṡ = -R φ̇); in the assembled system it holds identically. What the
author left open to the constraints (a place or an angle that is not given) stands as it was found.
"""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.evaluate import Scope, time_derivative
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Vector
from rbpsym.mechanics.assemble import vector_rate
from rbpsym.mechanics.geometry import Geometry, start_numbers, unsaid
from rbpsym.mechanics.placing import locator, open_names, poses
from rbpsym.mechanics.rates import full_rates
from rbpsym.mechanics.system import BodyState, Pose, System, at_point


@dataclass(frozen=True)
class Given:
    """`geometry` with all speeds free; the bodies whose place or angle no one gave."""

    geometry: Geometry
    unplaced: frozenset[str]
    unturned: frozenset[str]

    def spin(self, body: str | None) -> Scalar | None:
        """Angular velocity of a body in the speeds as given; None if nothing was said of its angle."""
        return None if body is None or body in self.unturned else self.geometry.states[body].omega


def as_given(system: System) -> Given:
    """The poses of the statement; open places and angles are those that the constraints gave."""
    problem = system.problem
    inertias = {name: state.inertia for name, state in system.bodies.items()}
    raw = poses(problem, inertias)
    left = open_names(raw)
    unplaced = frozenset(n for n in raw if _is_open(left, raw[n].origin.x, raw[n].origin.y))
    unturned = frozenset(n for n in raw if _is_open(left, raw[n].angle))
    placed = {n: _closed(pose, system.bodies[n].pose, n in unplaced, n in unturned) for n, pose in raw.items()}
    scope = Scope(rates=full_rates([c.name for c in problem.coordinates]))
    states = {n: _state(system.bodies[n], pose, scope) for n, pose in placed.items()}
    where = locator(problem, inertias, placed)
    return Given(Geometry(where, placed, start_numbers(problem), states, unsaid(problem)), unplaced, unturned)


def _closed(raw: Pose, found: Pose, place: bool, angle: bool) -> Pose:
    """A pose in which nothing is open."""
    return Pose(found.origin if place else raw.origin, found.angle if angle else raw.angle)


def _is_open(names: tuple[str, ...], *values: Scalar) -> bool:
    return any(depends_on(value, name) for value in values for name in names)


def _state(state: BodyState, pose: Pose, scope: Scope) -> BodyState:
    own = state.inertia
    center = at_point(pose, (own.x, own.y)) if own.x or own.y else pose.origin
    return BodyState(state.name, own, pose, center, vector_rate(center, scope), time_derivative(pose.angle, scope))


def speed_along(given: Given, body: str | None, place: Vector, direction: Vector) -> Scalar:
    """Speed of the material point of a body at a place along a direction."""
    return direction.dot(given.geometry.velocity(body, place))
