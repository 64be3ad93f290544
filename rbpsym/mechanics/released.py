"""A system with all bodies free: each has its own x, y and angle, and each constraint is a condition that may hold or not."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from rbpsym.errors import NotApplicable
from rbpsym.field import Meanings, cartesian, depends_on, derivative, is_zero, names_in, substitute, time_derivative
from rbpsym.field.scalar import NOTHING, Scalar, lift, symbol
from rbpsym.frozen import replace
from rbpsym.mechanics.assemble import moving, with_clock, with_forces
from rbpsym.mechanics.conditions import all_conditions, full_rates, rate_conditions
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.friction import geometry_of, slip_senses
from rbpsym.mechanics.geometry import Geometry, start_numbers
from rbpsym.mechanics.numbers import sample
from rbpsym.mechanics.placing import locator, open_name
from rbpsym.mechanics.system import ConstraintCondition, Pose, System
from rbpsym.present.forms import present
from rbpsym.quantities import LENGTH, NUMBER, Quantity
from rbpsym.statement.model import Coordinate, Element, Problem

AXES = ("x", "y", "angle")  # of the frame of a body
Values = Mapping[str, Scalar]


def released(tight: System) -> System:
    """The system of free bodies: its `implicit` and `speed_ties` are all conditions, those of one-sided constraints positive
    where they are open; its `dependent` the coordinates of the statement, in terms of poses.

    Raises NotApplicable where something needs a coordinate that no pose tells.
    """
    told = {open_name(body, axis): value for body in tight.bodies for axis, value in _pose(tight, body)}
    rates = {name: time_derivative(value, tight.scope) for name, value in told.items()}
    start, names = _begun(tight), tuple(told)
    coordinates = tuple(
        Coordinate(
            Quantity(name, NUMBER if name.endswith(".angle") else LENGTH, sign="real"),
            start=present(substitute(value, start)),
            speed=present(substitute(substitute(rates[name], start), start)),
        )
        for name, value in told.items()
    )
    problem = replace(tight.problem, coordinates=coordinates, constraints=tuple(_placed(tight)), phases=(), text="")
    own = {name: symbol(name) for name in names}
    placed = {
        body: Pose(cartesian(*(own[open_name(body, axis)] for axis in "xy")), own.get(open_name(body, "angle"), NOTHING))
        for body in tight.bodies
    }
    scope = Meanings(rates=full_rates(names) | {f"{n}_dot": symbol(f"{n}_ddot") for n in names})
    states = {name: moving(name, state.inertia, placed[name], scope) for name, state in tight.bodies.items()}
    where = locator(problem, {name: state.inertia for name, state in tight.bodies.items()}, placed)
    geometry = Geometry(where, placed, start_numbers(problem), states)
    images = _images(tight, told)
    known = images | {f"{name}_dot": time_derivative(value, scope) for name, value in images.items()}
    places, speeds = (
        tuple(replace(c, value=substitute(c.value, known)) for c in found if not is_zero(c.value))
        for found in (_one_sided(all_conditions(problem, geometry), problem, geometry), rate_conditions(problem, geometry))
    )
    scope = with_clock(scope, problem, placed, places)
    bare = System(problem, names, images, states, (), (), places, scope, names, speeds)
    return _closed(with_forces(bare, where), tight)


def _pose(tight: System, body: str) -> Iterator[tuple[str, Scalar]]:
    """What is free of a body: a particle has no angle."""
    pose = tight.bodies[body].pose
    yield from (("x", pose.origin.x), ("y", pose.origin.y))
    if tight.problem.body(body).shape.kind != "particle":
        yield "angle", pose.angle


def _begun(tight: System) -> dict[str, Scalar]:
    """The start as it is declared; sample numbers where it is left open."""
    guess = sample(tight.problem)
    open_ = {name: lift(Fraction(guess[name]).limit_denominator(10**6)) for name in tight.coordinates}
    return open_ | dict.fromkeys(tight.speeds, NOTHING) | dict(tight.scope.start)


def _placed(tight: System) -> Iterator[Element]:
    """The constraints; a pivot without a place is where the poses have it, a slip has the sense of the start."""
    senses = slip_senses(tight)
    for element in tight.problem.constraints:
        if element.name in senses:
            element = element.with_values(slip="forward" if senses[element.name] > 0 else "backward")
        if element.kind == "pivot" and element["at"] is None:
            place = geometry_of(tight).where(element["point"])
            element = element.with_values(at=(present(place.x), present(place.y)))
        yield element


def _images(tight: System, told: Values) -> dict[str, Scalar]:
    """The coordinates of the statement in terms of the poses: those in which a place or an angle is linear."""
    found: dict[str, Scalar] = {}
    for own, value in told.items():
        used = [name for name in tight.coordinates if depends_on(value, name)]
        slope = derivative(value, used[0]) if len(used) == 1 and used[0] not in found else NOTHING
        if slope and not names_in(slope) & {*tight.coordinates, "t"}:
            found[used[0]] = (symbol(own) - substitute(value, {used[0]: NOTHING})) / slope
    tied = {name: value for name, value in tight.dependent.items() if names_in(value) & {*tight.coordinates} <= found.keys()}
    return found | {name: substitute(value, found) for name, value in tied.items()}


def _one_sided(
    conditions: tuple[ConstraintCondition, ...], problem: Problem, geometry: Geometry
) -> Iterator[ConstraintCondition]:
    """The conditions; of what pushes or pulls only, positive where it is open."""
    pushing = {e.name: e for e in problem.constraints if pushes(e)}
    for condition in conditions:
        element = pushing.get(condition.constraint)
        if element is not None and condition.what == "length":
            yield replace(condition, value=-condition.value)
        elif element is not None and condition.what in ("line", "gap") and element.values.get("curve") is None:
            yield replace(condition, value=meeting(element, geometry).gap)
        else:
            yield condition


def _closed(system: System, tight: System) -> System:
    """The system, if nothing in it needs another coordinate. Raises NotApplicable."""
    lost = {*tight.coordinates, *tight.dependent} - system.dependent.keys()
    names = [name for one in lost for name in (one, f"{one}_dot", f"{one}_ddot")]
    values = [condition.value for condition in (*system.implicit, *system.speed_ties)]
    values += [part for force in system.forces for vector in (force.vector, force.point) for part in (vector.x, vector.y)]
    if any(depends_on(value, name) for value in (*values, *(f.couple for f in system.forces)) for name in names):
        raise NotApplicable(f"nothing tells {', '.join(sorted(lost))} where all bodies are free")
    return system
