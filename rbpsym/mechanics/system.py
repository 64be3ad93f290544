"""The values that mechanics passes on: states of bodies, forces, the assembled system."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from rbpsym.errors import StatementError
from rbpsym.field import NOTHING, ORIGIN, QUARTER, Meanings, Scalar, Vector, kept, substitute, time_derivative
from rbpsym.field.vector import vector_sum
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.inertia import Inertia
from rbpsym.statement.model import Element, Problem
from rbpsym.statement.paths import tensions


class Pose(Frozen):
    """Where the frame of a body is: position of its origin, angle of its x' axis from +x."""

    origin: Vector
    angle: Scalar


class BodyState(Frozen):
    """A body in motion. All vectors in space; angles, ω and α counter-clockwise positive."""

    name: str
    inertia: Inertia
    pose: Pose
    center: Vector
    velocity: Vector = ORIGIN
    omega: Scalar = NOTHING
    acceleration: Vector = ORIGIN
    alpha: Scalar = NOTHING

    @property
    def mass(self) -> Scalar:
        """Total mass."""
        return self.inertia.mass

    @property
    def moment(self) -> Scalar:
        """Moment of inertia about the centre of mass."""
        return self.inertia.moment

    @property
    def pole(self) -> Vector | None:
        """The instantaneous centre, the point of its plane that has no velocity; None where it does not turn."""
        return self.center + self.velocity.turned() * (1 / self.omega) if self.omega else None


class Force(Frozen):
    """A force, a couple, or both, on one body.

    `name` is that of the interaction or constraint; `by` is the body that exerts it, or
    "earth", "ground", "agent"; `point` where it acts (in space); `unknowns` the names of
    the unknown components in it; `law` "constraint" or the kind of the interaction.
    """

    name: str
    on: str
    by: str
    point: Vector
    vector: Vector = ORIGIN
    couple: Scalar = NOTHING
    unknowns: tuple[str, ...] = ()
    law: str = "constraint"
    where: str = ""

    def torque(self, origin: Vector) -> Scalar:
        """Its torque about a point, the couple included, counter-clockwise positive."""
        return (self.point - origin).cross(self.vector) + self.couple


End = tuple[str | None, Vector, str]  # a body (None: what is outside), a place, the name of that place


def opposed(
    name: str, ends: Iterable[End], vector: Vector = ORIGIN, couple: Scalar = NOTHING, outside: str = "ground", **told: Any
) -> tuple[Force, ...]:
    """A force and a couple on the body of the first end, and their opposites on that of the second."""
    first, second = ends
    both = ((first, second, vector, couple), (second, first, -vector, -couple))
    return tuple(
        Force(name, on, by or outside, place, push, turn, where=where, **told)
        for (on, place, where), (by, _, _), push, turn in both
        if on is not None
    )


class ConstraintCondition(Frozen):
    """One scalar geometric condition `value = 0` of a constraint."""

    constraint: str
    value: Scalar
    what: str = ""


class System(Frozen):
    """A problem with kinematics and forces worked out.

    `coordinates` are the independent ones, `dependent` what the constraints make of the
    others; `conditions` all geometric conditions of the constraints as they stand in the given
    poses; `identities` those that hold identically; `implicit` those that stay as equations;
    `speed_ties` conditions on the speeds that are no rates of a position (linear in the speeds).
    """

    problem: Problem
    coordinates: tuple[str, ...]
    dependent: Mapping[str, Scalar]
    bodies: Mapping[str, BodyState]
    forces: tuple[Force, ...]
    conditions: tuple[ConstraintCondition, ...]
    implicit: tuple[ConstraintCondition, ...] = ()
    scope: Meanings = field(default_factory=Meanings)
    independent: tuple[str, ...] = ()
    speed_ties: tuple[ConstraintCondition, ...] = ()

    def named(self, name: str) -> list[Force]:
        """The forces of a name on all bodies."""
        return [force for force in self.forces if force.name == name]

    def is_reaction(self, force: Force) -> bool:
        """Whether it is the opposite of a force of the same name that comes first."""
        first = self.named(force.name)[0]
        return first is not force and first.on == force.by and first.by == force.on

    @kept
    def speeds(self) -> tuple[str, ...]:
        """Names of the independent speeds."""
        return tuple(f"{name}_dot" for name in self.independent)

    @kept
    def accelerations(self) -> tuple[str, ...]:
        """Names of the independent accelerations."""
        return tuple(f"{name}_ddot" for name in self.independent)

    @kept
    def unsettled(self) -> frozenset[str]:
        """The names of which nobody knows how they change: accelerations and unknown forces."""
        return frozenset((*self.accelerations, *self.unknowns))

    @kept
    def unknowns(self) -> tuple[str, ...]:
        """Names of all unknown force components, in the order of the statement."""
        return tuple(dict.fromkeys(n for force in self.forces for n in force.unknowns))

    @property
    def defined(self) -> dict[str, Scalar]:
        """The dependent coordinates and all speeds that are not independent, as formulas."""
        rates = {name: self.scope.rates[name] for name in self.coordinates if name not in self.independent}
        rates |= {name: time_derivative(value, self.scope) for name, value in self.dependent.items()}
        return {**self.dependent, **{f"{name}_dot": rate for name, rate in rates.items()}}

    @property
    def has_clock(self) -> bool:
        """Whether something depends on the time explicitly (a support that is driven)."""
        return "t" in self.scope.rates

    def tied(self) -> dict[str, Scalar]:
        """Coordinates that the constraints tie to others, with their rates: x is Rφ where it rolls."""
        found = {}
        for name, value in self.dependent.items():
            for tail in ("", "_dot", "_ddot"):
                found[f"{name}{tail}"] = value
                value = time_derivative(value, self.scope)
        return found

    def on(self, body: str) -> tuple[Force, ...]:
        """The forces on one body."""
        return tuple(force for force in self.forces if force.on == body)

    def element(self, name: str) -> Element:
        """The interaction or constraint to which a force of that name belongs (its own name, f_N, T_1). Raises StatementError."""
        both = self.problem.elements
        known = {element.name: element for element in both}
        found = known.get(name) or next((e for e in both if name in _names_of(e)), None)
        if found is None:
            raise StatementError(f"“{name}” does not act in this phase", instead="name one in which it does.")
        return found


def _names_of(element: Element) -> tuple[str, ...]:
    """Further names of the forces of an element."""
    if element.kind == "string":
        return tensions(element)
    return tuple(element.values[key] for key in ("friction", "couple") if isinstance(element.values.get(key), str))


def rotated(x: Scalar, y: Scalar, angle: Scalar) -> Vector:
    """The vector (x, y) of a body frame in space."""
    return vector_sum(((x, angle), (y, angle + QUARTER)))


def at_point(state: BodyState | Pose, local: tuple[Scalar, Scalar]) -> Vector:
    """Position in space of a point given in the body frame."""
    pose = state.pose if isinstance(state, BodyState) else state
    return pose.origin + rotated(*local, pose.angle)


def by_letters(speeds: Mapping[str, Scalar]) -> dict[str, Scalar]:
    """The speeds of coordinates by their letters, of q by that of q̇."""
    return {f"{name}_dot": speed for name, speed in speeds.items()}


def in_state(value: Scalar, places: Mapping[str, Scalar], speeds: Mapping[str, Scalar]) -> Scalar:
    """A value with the speeds of coordinates, and then their places, put in."""
    return substitute(substitute(value, by_letters(speeds)), places)
