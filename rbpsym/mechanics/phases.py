"""Motion in phases: the state that ends one is handed over to the next, through impulses if there are any.

At an event the bodies keep their places. Impulses Ĵ change the velocities: m ΔV = Σ Ĵ, I_cm Δω =
Σ r × Ĵ + couples for every body, with the unknown impulses of the constraints that hold afterwards and
of collisions (n·(v₂' - v₁') = -e n·(v₂ - v₁)); forces that stay finite don't count.
Kleppner & Kolenkow 4.4, 7.6; Meriam & Kraige, Dynamics, 3/12, 6/8.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from rbpsym.algebra.calculus import derivative, root, substitute
from rbpsym.algebra.evaluate import time_derivative
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.present import present
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.errors import NotApplicable, StatementError
from rbpsym.mechanics import energy
from rbpsym.mechanics.contacts import meeting, slip_speed
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.impulse import Struck, strike
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Phase, Problem


@dataclass(frozen=True)
class State:
    """Time since the start of the phase, coordinates and speeds (all that the problem has)."""

    time: Scalar
    places: Mapping[str, Scalar]
    speeds: Mapping[str, Scalar]


@dataclass(frozen=True)
class HandOver:
    """How a phase begins: the state that ended the one before, the speeds after, the impulses, the energy lost."""

    before: State
    speeds: Mapping[str, Scalar]
    impulses: Mapping[str, Scalar]
    energy_lost: Scalar


@dataclass(frozen=True)
class Stage:
    """A phase with its mechanics; `began` is None for the first."""

    name: str
    study: Study
    began: HandOver | None = None


def stages(problem: Problem) -> tuple[Stage, ...]:
    """All phases. Raises NotApplicable where the end of a phase has no closed form."""
    found = [Stage(problem.name, Study(replace(problem, phases=())))]
    for phase in problem.phases:
        found.append(_next(found[-1].study, phase))
    return tuple(found)


def _next(study: Study, phase: Phase) -> Stage:
    before = EVENTS[phase.event](study, phase)
    placed = Study(_started(phase.problem, before.places, {}))
    struck: Struck = strike(study.system, placed.system, phase.impulses, before.places, before.speeds)
    after = _started(phase.problem, before.places, struck.speeds)
    lost = _kinetic(study.system, before.places, before.speeds) - _kinetic(placed.system, before.places, struck.speeds)
    return Stage(phase.name, Study(after), HandOver(before, struck.speeds, struck.impulses, short(lost)))


def _started(problem: Problem, places: Mapping[str, Scalar], speeds: Mapping[str, Scalar]) -> Problem:
    """The problem with these starts."""
    coordinates = tuple(
        replace(c, start=present(places[c.name]), speed=present(speeds[c.name]) if c.name in speeds else None)
        for c in problem.coordinates
    )
    return replace(problem, coordinates=coordinates)


def _kinetic(system: System, places: Mapping[str, Scalar], speeds: Mapping[str, Scalar]) -> Scalar:
    total = sum(energy.kinetic_energy(system), NOTHING)
    return substitute(substitute(total, {f"{n}_dot": v for n, v in speeds.items()}), places)


# --- the ends of phases


def at_start(study: Study) -> State:
    """Coordinates and speeds of the declared start, dependent ones too."""
    system, start = study.system, study.system.scope.start
    places, speeds = {}, {}
    for coordinate in study.problem.coordinates:
        name = coordinate.name
        value = system.dependent.get(name, symbol(name))
        rate = system.scope.rates.get(name)
        rate = time_derivative(value, system.scope) if rate is None else rate
        places[name], speeds[name] = (short(substitute(part, start)) for part in (value, rate))
        _require_start(study, name, places[name], speeds[name])
    return State(NOTHING, places, speeds)


def _require_start(study: Study, name: str, *values: Scalar) -> None:
    names = {n for c in study.problem.coordinates for n in (c.name, f"{c.name}_dot")}
    if any(derivative(value, other) for value in values for other in names):
        raise StatementError(
            f"the phases need to know where “{name}” starts and how fast",
            instead=f'give [coordinates.{name}] a start = "..." and a speed = "...".',
            place=next(c.place for c in study.problem.coordinates if c.name == name),
        )


def _at_once(study: Study, phase: Phase) -> State:
    return at_start(study)


def _no_slip(study: Study, phase: Phase) -> State:
    """The moment at which a slip that changes uniformly has gone."""
    element = study.system.element(phase.subject)
    if element.values.get("coefficient") is None:
        raise StatementError(
            f"the phase “{phase.name}” begins when “{phase.subject}” stops slipping, but it has no kinetic friction",
            instead='give it a coefficient = "mu".',
            place=element.place,
        )
    slip = _on(study, slip_speed(geometry_of(study.system), meeting(element, geometry_of(study.system))))
    gain = short(substitute(time_derivative(slip, study.system.scope), _uniform(study, phase)))
    start = at_start(study)
    first = short(substitute(slip, _speeds(study, start)))
    if is_zero(gain) or _sign(study, -(first / gain)) < 0:
        raise StatementError(
            f"the phase “{phase.name}” is never reached: “{phase.subject}” does not stop slipping",
            instead="check the start speeds and the sense of the slip.",
            place=element.place,
        )
    return _after(study, phase, start, short(-(first / gain)))


def _on(study: Study, value: Scalar) -> Scalar:
    return short(substitute(value, study.system.dependent))


def _speeds(study: Study, state: State) -> dict[str, Scalar]:
    return {f"{n}_dot": v for n, v in state.speeds.items()} | dict(state.places)


def _sign(study: Study, value: Scalar) -> int:
    found = number(value, sample(study.problem))
    return 0 if abs(found) < 1e-12 else 1 if found > 0 else -1


def _uniform(study: Study, phase: Phase) -> Mapping[str, Scalar]:
    """The accelerations, if they are constants."""
    found = study.dynamics.accelerations
    names = [*study.system.coordinates, *study.system.speeds, "t"]
    if found is None or any(derivative(value, name) for value in found.values() for name in names):
        raise NotApplicable(
            f"the end of the phase before “{phase.name}” has no closed form: the accelerations are not constant",
            instead="state this phase as a problem of its own, or follow it in the simulation.",
        )
    return found


def _after(study: Study, phase: Phase, start: State, time: Scalar) -> State:
    """q + q̇ t + ½ q̈ t² and q̇ + q̈ t."""
    gains = {}
    for name in start.places:
        value = study.system.dependent.get(name)
        rate = study.system.scope.rates[name] if value is None else time_derivative(value, study.system.scope)
        gains[name] = substitute(time_derivative(rate, study.system.scope), _uniform(study, phase))
    places = {n: short(q + start.speeds[n] * time + gains[n] * time * time / 2) for n, q in start.places.items()}
    return State(time, places, {n: short(v + gains[n] * time) for n, v in start.speeds.items()})


def _lost(study: Study, phase: Phase) -> State:
    """The place at which a contact is lost, and the speed there from the first integral."""
    loss = next((item for item in study.losses if item.force == phase.subject and item.at), None)
    if loss is None or len(study.system.independent) != 1:
        raise NotApplicable(
            f"the place where “{phase.subject}” is lost has no closed form",
            instead="state the phase after it as a problem of its own, or follow it in the simulation.",
        )
    [name], at = study.system.independent, loss.at
    way = _sign(study, at[name] - study.system.scope.start[name]) or 1
    speed = root(short(substitute(study.squares[name], at))) * way
    here = {name: at[name], f"{name}_dot": speed}
    places, speeds = {}, {}
    for coordinate in study.problem.coordinates:
        value = study.system.dependent.get(coordinate.name, symbol(coordinate.name))
        places[coordinate.name] = short(substitute(value, here))
        speeds[coordinate.name] = short(substitute(time_derivative(value, study.system.scope), here))
    return State(NOTHING, places, speeds)


EVENTS = {"at once": _at_once, "no slip": _no_slip, "lost": _lost}
