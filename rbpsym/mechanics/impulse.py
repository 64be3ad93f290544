"""Impulses at an instant: the velocities after, and the impulses of constraints, collisions and bounces."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.impulses import IMPULSES
from rbpsym.elements.kinds import KindParts
from rbpsym.errors import StatementError
from rbpsym.field import NOTHING, ORIGIN, Scalar, Vector, is_zero, substitute, time_derivative
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.contacts import meeting, slip_speed
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import Geometry, start_numbers
from rbpsym.mechanics.system import Force, System, in_state
from rbpsym.statement.model import Element, PointRef

if TYPE_CHECKING:
    from rbpsym.mechanics.arrivals import ArrivalState
    from rbpsym.mechanics.study import Study

Values = Mapping[str, Scalar]


class Strike(Frozen):
    """The law of a kind of impulse, the `STRIKE` of the module `law` in its folder: its impulses as forces, which can push only
    if it is one-sided; what must be so just before (`check`, with the system after), else a sentence."""

    forces: Callable[[Element, Geometry], tuple[Force, ...]]
    check: Callable[[Study, Element, ArrivalState, System], None] = lambda study, element, before, after: None
    is_one_sided: bool = False


STRIKES: KindParts[Strike] = KindParts(IMPULSES, "law", "STRIKE")


class Struck(Frozen):
    """Speeds of all coordinates just after; impulses by the name of their unknown (where determined); what is `asked` for
    contacts to push and for friction to do as it is said, by the name of the contact."""

    speeds: Values
    impulses: Values
    asked: Mapping[str, tuple[Demand, ...]]


class BeforeAndAfter(Frozen):
    """The systems before and after, at one configuration."""

    before: System
    after: System
    places: Values
    speeds: Values

    def old(self, value: Scalar) -> Scalar:
        """A value of the system before, in numbers of the start."""
        return in_state(value, self.places, self.speeds)

    def new(self, value: Scalar) -> Scalar:
        """A value of the system after; its speeds stay as unknowns."""
        tied = {f"{n}_dot": rate for n, rate in self.after.scope.rates.items() if f"{n}_dot" not in self.after.speeds}
        return substitute(substitute(value, tied), self.places)

    def there(self, place: Vector) -> Vector:
        """A place at that configuration."""
        return place.substitute(self.places)


def strike(before: System, after: System, impulses: tuple[Element, ...], places: Values, speeds: Values) -> Struck:
    """Raises StatementError if the impulses contradict the constraints."""
    moment = BeforeAndAfter(before, after, places, speeds)
    rows = [row for name in after.bodies for row in body_rows(moment, name, impulses)]
    rows += [parting(moment, e, name, factor) for e in impulses for name, factor in restitutions(e).items()]
    rows += [moment.new(time_derivative(c.value, after.scope)) for c in after.implicit]
    rows += [moment.new(c.value) for c in after.speed_ties]
    unknowns = (*after.speeds, *(name for e in impulses for name in restitutions(e)), *after.unknowns)
    solution = solve_linear(rows, unknowns)
    missing = [name for name in after.speeds if name not in solution.values]
    if missing or not all(map(is_zero, solution.left)):
        open_ = f"do not tell how fast “{missing[0].removesuffix('_dot')}” then changes" if missing else ""
        raise StatementError(
            f"the impulses and the constraints of the next phase {open_ or 'contradict each other, or the poses of the bodies'}",
            instead="check that the constraints hold where the bodies are at that moment, and give each body a coordinate for "
            'every way in which it moves from then on: center = ["x", "y"] where a pose keeps it on a line.',
            place=impulses[0].place if impulses else None,
        )
    found = {n: v for n, v in solution.values.items() if n not in after.speeds}
    asked = {e.name: tuple(_asked(moment, e, solution.values)) for e in (*impulses, *after.problem.constraints)}
    return Struck(_all_speeds(moment, solution.values), found, asked)


def _asked(moment: BeforeAndAfter, element: Element, values: Values) -> Iterator[Demand]:
    """A contact pushes, a string pulls; friction that holds stays within its limit, what slips goes on in its sense."""
    pushed: Iterable[str] = pushes(element) if element.kind in CONSTRAINTS else ()
    if element.kind in IMPULSES and STRIKES[element.kind].is_one_sided:
        pushed = restitutions(element)
    for name in pushed:
        if name in values and name != element.values.get("friction"):
            yield Demand(values[name], ">=")
    limit = element.values.get("limit") or (element.values.get("coefficient") if is_holding(element) else None)
    if limit is not None and element["friction"] in values:
        most, grip = scalar(limit) * values[element.name], values[element["friction"]]
        yield from (Demand(most - grip * side, ">=") for side in (1, -1))
    sense = {"forward": 1, "backward": -1}.get(element.values.get("slip", ""))
    if sense and element["coefficient"] is not None and not is_zero(values.get(element.name, NOTHING)):
        for system, seen in ((moment.before, moment.old), (moment.after, moment.new)):
            geometry = geometry_of(system)
            slip = seen(slip_speed(geometry, meeting(element, geometry)))
            yield Demand(substitute(slip, values) * sense, ">=")


def is_holding(element: Element) -> bool:
    """Whether friction lets nothing slip when a bounce is over."""
    return element.values.get("slip") == "none"


def restitutions(element: Element) -> dict[str, Scalar]:
    """By unknown impulse of a collision or a bounce: the speed of parting along it over that of approach."""
    found = {element.name: scalar(element["restitution"])} if "restitution" in element.values else {}
    return found | ({element["friction"]: scalar(element["tangential"])} if is_holding(element) else {})


def _all_speeds(moment: BeforeAndAfter, values: Values) -> dict[str, Scalar]:
    """Speeds of dependent coordinates follow."""
    found, system = {}, moment.after
    for coordinate in system.problem.coordinates:
        rate = system.scope.rates.get(coordinate.name)
        if rate is None:
            rate = time_derivative(system.dependent[coordinate.name], system.scope)
        found[coordinate.name] = substitute(moment.new(rate), values)
    return found


def body_rows(moment: BeforeAndAfter, name: str, impulses: tuple[Element, ...]) -> list[Scalar]:
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
    """What can change velocities in no time: the forces of constraints, blows, collisions and bounces, on all bodies."""
    return (*(force for force in system.forces if force.unknowns), *_given(system, impulses))


def _given(system: System, impulses: tuple[Element, ...]) -> list[Force]:
    """Blows and the impulses of collisions and bounces as forces (of the dimension of an impulse)."""
    geometry = geometry_of(system)
    return [replace(force, law="impulse") for element in impulses for force in STRIKES[element.kind].forces(element, geometry)]


def at_points(element: Element, geometry: Geometry, *ends: tuple[PointRef, Vector]) -> tuple[Force, ...]:
    """An impulse at each point of a body."""
    return tuple(
        Force(element.name, ref.body, "agent", geometry.where(ref), vector, where=ref.label)
        for ref, vector in ends
        if ref.body is not None
    )


def parting(moment: BeforeAndAfter, element: Element, name: str, factor: Scalar) -> Scalar:
    """The speed of parting along an impulse just after, and e times that before: 0."""
    before, after = (approach(system, element, name, moment.after) for system in (moment.before, moment.after))
    return moment.new(after) + factor * moment.old(before)


def approach(system: System, element: Element, name: str, after: System) -> Scalar:
    """The speed with which what a collision or bounce pushes apart parts along an impulse: the power of one that is 1.
    Which way a string runs is seen where the phase `after` starts."""
    geometry = replace(geometry_of(system), numbers=start_numbers(after.problem))
    pushes = (force for force in STRIKES[element.kind].forces(element, geometry) if force.name == name)
    return sum((f.vector.derivative(name).dot(geometry.velocity(f.on, f.point)) for f in pushes), NOTHING)
