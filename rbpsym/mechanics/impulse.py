"""Impulses at an instant: the velocities after, and the impulses of constraints and collisions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.evaluate import scalar, time_derivative
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.algebra.vector import ORIGIN, Vector
from rbpsym.errors import StatementError
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.system import Force, System
from rbpsym.statement.model import Element, PointRef

Values = Mapping[str, Scalar]


@dataclass(frozen=True)
class Struck:
    """Speeds of all coordinates just after; impulses by the name of their unknown (where determined)."""

    speeds: Values
    impulses: Values


@dataclass(frozen=True)
class _Moment:
    """The systems before and after, at one configuration."""

    before: System
    after: System
    places: Values
    speeds: Values

    def old(self, value: Scalar) -> Scalar:
        """A value of the system before, in numbers of the start."""
        return substitute(substitute(value, {f"{n}_dot": v for n, v in self.speeds.items()}), self.places)

    def new(self, value: Scalar) -> Scalar:
        """A value of the system after; its speeds stay as unknowns."""
        tied = {f"{n}_dot": rate for n, rate in self.after.scope.rates.items() if f"{n}_dot" not in self.after.speeds}
        return substitute(substitute(value, tied), self.places)


def strike(before: System, after: System, impulses: tuple[Element, ...], places: Values, speeds: Values) -> Struck:
    """Raises StatementError if the impulses contradict the constraints."""
    moment = _Moment(before, after, places, speeds)
    rows = [row for name in after.bodies for row in _balances(moment, name, impulses)]
    rows += [_parting(moment, e) for e in impulses if e.kind == "collision"]
    rows += [moment.new(time_derivative(c.value, after.scope)) for c in after.implicit]
    rows += [moment.new(c.value) for c in after.speed_ties]
    unknowns = (*after.speeds, *(e.name for e in impulses if e.kind == "collision"), *after.unknowns)
    solution = solve_linear(rows, unknowns)
    missing = [name for name in after.speeds if name not in solution.values]
    if missing or not all(map(is_zero, solution.left)):
        raise StatementError(
            "the impulses and the constraints of the next phase do not determine the speeds after them",
            instead="check that the constraints hold where the bodies are at that moment.",
            place=impulses[0].place if impulses else None,
        )
    return Struck(
        _all_speeds(moment, solution.values), {n: v for n, v in solution.values.items() if n not in after.speeds}
    )


def _all_speeds(moment: _Moment, values: Values) -> dict[str, Scalar]:
    """Speeds of dependent coordinates follow."""
    found, system = {}, moment.after
    for coordinate in system.problem.coordinates:
        rate = system.scope.rates.get(coordinate.name)
        if rate is None:
            rate = time_derivative(system.dependent[coordinate.name], system.scope)
        found[coordinate.name] = substitute(moment.new(rate), values)
    return found


def _balances(moment: _Moment, name: str, impulses: tuple[Element, ...]) -> list[Scalar]:
    """m ΔV - Σ Ĵ (x and y) and I Δω - Σ moments of one body."""
    new, old = moment.after.bodies[name], moment.before.bodies[name]
    forces = [force for force in impulsive(moment.after, impulses) if force.on == name]
    push = sum((f.vector for f in forces), ORIGIN)
    turn = sum((torque_about_center(f, new) for f in forces), NOTHING)
    return [
        new.mass * (moment.new(new.velocity.x) - moment.old(old.velocity.x)) - moment.new(push.x),
        new.mass * (moment.new(new.velocity.y) - moment.old(old.velocity.y)) - moment.new(push.y),
        new.moment * (moment.new(new.omega) - moment.old(old.omega)) - moment.new(turn),
    ]


def impulsive(system: System, impulses: tuple[Element, ...]) -> tuple[Force, ...]:
    """What can change velocities in no time: the forces of constraints, blows and collisions, on all bodies."""
    return (*(force for force in system.forces if force.unknowns), *_given(system, impulses))


def _given(system: System, impulses: tuple[Element, ...]) -> list[Force]:
    """Blows and the impulses of collisions as forces (of the dimension of an impulse)."""
    found, where = [], geometry_of(system).where
    for element in impulses:
        ends = _ends(element)
        found += [
            Force(element.name, ref.body, "agent", where(ref), vector, law="impulse", where=ref.label)
            for ref, vector in ends
            if ref.body is not None
        ]
    return found


def _ends(element: Element) -> list[tuple[PointRef, Vector]]:
    if element.kind == "blow":
        return [(element["on"], pair(element["impulse"]))]
    first, second = element["points"]
    push = pair(element["along"]) * symbol(element.name)
    return [(first, -push), (second, push)]


def _parting(moment: _Moment, element: Element) -> Scalar:
    """n·(v₂' - v₁') + e n·(v₂ - v₁)."""
    along, speeds = pair(element["along"]), []
    for system, value in ((moment.after, moment.new), (moment.before, moment.old)):
        first, second = (point_velocity(system, ref) for ref in element["points"])
        speeds.append(value(along.dot(second - first)))
    return speeds[0] + scalar(element["restitution"]) * speeds[1]


def point_velocity(system: System, ref: PointRef) -> Vector:
    """Velocity of a point of a body (0 for a fixed one)."""
    if ref.body is None:
        return ORIGIN
    geometry = geometry_of(system)
    return geometry.velocity(ref.body, geometry.where(ref))
