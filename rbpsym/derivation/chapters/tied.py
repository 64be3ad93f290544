"""What the conditions of the constraints determine: angular velocities, coordinates, or only speeds."""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.evaluate import Scope, time_derivative
from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Vector
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import BodyRef
from rbpsym.mechanics.assemble import vector_rate
from rbpsym.mechanics.conditions import full_rates
from rbpsym.mechanics.geometry import Geometry, start_numbers, unsaid
from rbpsym.mechanics.placing import locator, open_names, poses
from rbpsym.mechanics.system import BodyState, Pose, System, at_point
from rbpsym.notation import tree as t


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


def found_spins(draft: Draft, given: Given) -> None:
    """The angular velocity of bodies whose angle was left to rolling or to a string."""
    for name in draft.study.problem.body_names:
        state = draft.study.system.bodies[name]
        premises = [s.id for s in draft.steps if s.rule in ("no_slip", "taut")]
        if name in given.unturned and state.omega and premises:
            omega = draft.define(draft.of_body("omega", name), state.omega)
            draft.add(
                f"turning.{name}",
                "tied",
                t.equation(omega, draft.show(state.omega)),
                "kinematics.turning.found",
                premises=premises,
                body=BodyRef(name),
                data={"pairs": [(state.pose.angle, state.omega)]},
            )


def tied(draft: Draft) -> None:
    """Coordinates, or only speeds, in terms of the free ones."""
    system = draft.study.system
    shown = {name for step in draft.steps if step.rule == "constraint" for name in _solved_already(step.statement)}
    premises = [s.id for s in draft.steps if s.rule in ("constraint", "no_slip", "taut")]
    for name, value in system.dependent.items():
        statement = t.equation(t.Sym(name), draft.show(value))
        if name not in shown:
            draft.add(
                f"dependent.{name}",
                "tied",
                statement,
                "kinematics.dependent",
                premises=premises,
                coordinate=t.Sym(name),
                variant="rate" if _from_rate(draft, name) else "place",
            )
    for name in system.coordinates:
        if name not in system.independent:
            draft.add(
                f"tied_speed.{name}",
                "tied",
                t.equation(t.Sym(f"{name}_dot"), draft.show(system.scope.rates[name], factor=True)),
                "kinematics.tied_speed",
                premises=premises,
                coordinate=t.Sym(name),
            )


def _solved_already(statement: t.Node) -> list[str]:
    """Names that stand alone on the left of a condition, and not on the right of it."""
    rows = statement.rows if isinstance(statement, t.System) else (statement,)
    pairs = [(row.items[0], row.items[-1]) for row in rows]
    return [left.name for left, right in pairs if isinstance(left, t.Sym) and left.name not in t.names(right)]


def _from_rate(draft: Draft, name: str) -> bool:
    """Was it found by integrating a condition on the speeds?"""
    kinds = {"rolling", "gear", "sticking", "string"}
    named = {c.constraint for c in draft.study.system.conditions if depends_on(c.value, name) and c.what in kinds}
    return bool(named)
