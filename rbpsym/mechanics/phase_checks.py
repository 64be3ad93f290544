"""What must be so where one phase ends and the next begins, seen at sample numbers: else a sentence."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace

from rbpsym.errors import NoNumber, NotApplicable, StatementError
from rbpsym.field import Scalar, substitute
from rbpsym.mechanics.arrivals import ArrivalState
from rbpsym.mechanics.contacts import meeting, side_taken, slip_speed
from rbpsym.mechanics.friction import geometry_of, slips
from rbpsym.mechanics.numbers import number, samples
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Element, Phase

CLOSE = 1e-7


def check_still_slipping(study: Study, phase: Phase, state: ArrivalState) -> None:
    """What slips at the start slips until the phase ends, in the same sense."""
    known = numbers_then(study, state)
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


def check_in_place(study: Study, phase: Phase, placed: Study, state: ArrivalState) -> None:
    """The constraints of the new phase hold where the bodies are."""
    known = numbers_then(study, state)
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


def with_senses(study: Study, phase: Phase, state: ArrivalState) -> Phase:
    """The phase with the side and the sense of slip of what begins, and of bounces, as just before where nothing says them; so
    with what goes on slipping where nothing strikes."""
    geometry, begun = geometry_of(study.system), phase.gap
    is_smooth = not phase.impulses and {e.name for e in phase.problem.constraints} <= {e.name for e in study.problem.constraints}

    def told(element: Element) -> Element:
        meets = element is begun or element in phase.impulses
        if not meets and not is_smooth:
            return element
        if meets and element.values.get("side") == "auto":
            element = element.with_values(side=side_taken(element, geometry))
        if element.values.get("coefficient") is not None and element["slip"] == "auto":
            slip = value_then(study, slip_speed(geometry, meeting(element, geometry)), numbers_then(study, state))
            if abs(slip) < CLOSE and not meets:
                return element
            if abs(slip) < CLOSE:
                raise wrong(element, "has friction, but just before nothing slips there", 'say how: slip = "forward".')
            element = element.with_values(slip="forward" if slip > 0 else "backward")
        return element

    constraints, impulses = (tuple(map(told, each)) for each in (phase.problem.constraints, phase.impulses))
    return replace(phase, impulses=impulses, problem=replace(phase.problem, constraints=constraints))


def wrong(element: Element, what: str, cure: str) -> StatementError:
    """The sentence for an element that can't be so when the phase begins."""
    return StatementError(f"the {element.kind} “{element.name}” {what}", instead=cure, place=element.place)


def numbers_then(study: Study, state: ArrivalState) -> dict[str, float]:
    """Sample numbers with the places and speeds of a state: the first at which the motion comes there."""
    for known in samples(study.problem):
        with suppress(NoNumber):
            places = {name: number(value, known) for name, value in state.places.items()}
            return known | places | {f"{name}_dot": number(value, known) for name, value in state.speeds.items()}
    raise NotApplicable("at none of the sample numbers does the motion come to the end of a phase")


def value_then(study: Study, value: Scalar, known: Mapping[str, float]) -> float:
    """A value at these numbers."""
    return number(substitute(value, study.system.dependent), known)
