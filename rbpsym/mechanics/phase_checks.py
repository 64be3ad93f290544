"""What must be so where one phase ends and the next begins, seen at sample numbers: else a sentence."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace

from rbpsym.errors import NoNumber, NotApplicable, StatementError
from rbpsym.field import NOTHING, Scalar, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.contacts import meeting, side_taken, slip_speed
from rbpsym.mechanics.endings import State, gap
from rbpsym.mechanics.friction import geometry_of, slips
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.impulse import approach
from rbpsym.mechanics.numbers import number, samples
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Element, Phase, PointRef
from rbpsym.statement.paths import round_size

CLOSE = 1e-7


def check_still_slipping(study: Study, phase: Phase, state: State) -> None:
    """What slips at the start slips until the phase ends, in the same sense."""
    known = _numbers(study, state)
    for name, slip in slips(study.system).items():
        if name == phase.subject:
            continue
        element = study.system.element(name)
        if number(slip, known) < -CLOSE:
            raise StatementError(
                f"the phase “{phase.name}” would begin after “{name}” has stopped slipping",
                instead=f'let a phase with event = "no slip" and of = "{name}" come before it.',
                place=element.place,
            )


def check_in_place(study: Study, phase: Phase, placed: Study, state: State) -> None:
    """The constraints of the new phase hold where the bodies are."""
    known = _numbers(study, state)
    for name, value in placed.system.dependent.items():
        if abs(number(value, known) - known[name]) > CLOSE:
            raise _apart(phase, placed, name)
    for condition in placed.system.implicit:
        if abs(number(condition.value, known)) > CLOSE:
            raise _apart(phase, placed, condition.constraint)


def _apart(phase: Phase, placed: Study, name: str) -> StatementError:
    """`name` is that of a constraint, or of a coordinate that a new constraint would move."""
    element = next((e for e in placed.problem.constraints if e.name == name), None)
    what = f"“{name}” does not hold" if element else f"the constraints do not hold: they would move “{name}”"
    return StatementError(
        f"when the phase “{phase.name}” begins, {what} where the bodies are",
        instead="check the places in its constraints, or the event at which it begins.",
        place=element.place if element else next((e.place for e in placed.problem.constraints), None),
    )


def check_collision(study: Study, element: Element, state: State) -> None:
    """Two points that collide are in one place, and come nearer along a unit vector."""
    known, along = _numbers(study, state), pair(element["along"])
    if abs(_at(study, along.dot(along), known) - 1) > CLOSE:
        raise _wrong(element, "goes along a direction that is no unit vector", 'write along = ["1", "0"].')
    gap = _where(study.system, element["points"][1]) - _where(study.system, element["points"][0])
    reach = sum((_radius(study.system, ref) for ref in element["points"]), NOTHING)
    if min(_at(study, apart.dot(apart), known) for apart in (gap, gap - along * reach)) > CLOSE**2:
        raise _wrong(element, "is between points that do not meet at that moment", "check the points, the start, or the event.")
    first, second = (_velocity(study.system, ref) for ref in element["points"])
    if _at(study, along.dot(second - first), known) > -CLOSE:
        raise _wrong(
            element,
            "is between points that do not approach each other",
            "along points from the first to the second body: check it, the order of the points, and the speeds before.",
        )


def check_bounce(study: Study, element: Element, state: State, after: System) -> None:
    """What bounces is where it meets, and comes nearer."""
    known, geometry = _numbers(study, state), geometry_of(study.system)
    if abs(_at(study, gap(element, geometry), known)) > CLOSE:
        raise _wrong(element, "does not meet at that moment", "check the line or the length, the start, or the event.")
    if _at(study, approach(study.system, element, element.name, after), known) > -CLOSE:
        raise _wrong(element, "does not approach", "check the side and the speeds before.")


def with_senses(study: Study, phase: Phase, state: State) -> Phase:
    """The phase with the side and the sense of slip of what begins, and of bounces, as just before where nothing says them."""
    geometry, begun = geometry_of(study.system), phase.gap

    def told(element: Element) -> Element:
        if element is not begun and element.kind != "bounce":
            return element
        if element.values.get("side") == "auto":
            element = element.with_values(side=side_taken(element, geometry))
        if element.values.get("coefficient") is not None and element["slip"] == "auto":
            slip = _at(study, slip_speed(geometry, meeting(element, geometry)), _numbers(study, state))
            if abs(slip) < CLOSE:
                raise _wrong(element, "has friction, but just before nothing slips there", 'say how: slip = "forward".')
            element = element.with_values(slip="forward" if slip > 0 else "backward")
        return element

    constraints, impulses = (tuple(map(told, each)) for each in (phase.problem.constraints, phase.impulses))
    return replace(phase, impulses=impulses, problem=replace(phase.problem, constraints=constraints))


def _radius(system: System, ref: PointRef) -> Scalar:
    """How far its rim is from the point that is named: its radius for the centre of a round body."""
    if ref.body is None or ref.point not in ("center", "cm"):
        return NOTHING
    size = round_size(system.problem.body(ref.body))
    return NOTHING if size is None else scalar(size)


def _wrong(element: Element, what: str, cure: str) -> StatementError:
    return StatementError(f"the {element.kind} “{element.name}” {what}", instead=cure, place=element.place)


def _where(system: System, ref: PointRef):
    return geometry_of(system).where(ref)


def _velocity(system: System, ref: PointRef):
    geometry = geometry_of(system)
    return geometry.velocity(ref.body, geometry.where(ref))


def _numbers(study: Study, state: State) -> dict[str, float]:
    """Sample numbers with the places and speeds of a state: the first at which the motion comes there."""
    for known in samples(study.problem):
        with suppress(NoNumber):
            places = {name: number(value, known) for name, value in state.places.items()}
            return known | places | {f"{name}_dot": number(value, known) for name, value in state.speeds.items()}
    raise NotApplicable("at none of the sample numbers does the motion come to the end of a phase")


def _at(study: Study, value: Scalar, known: Mapping[str, float]) -> float:
    return number(substitute(value, study.system.dependent), known)
