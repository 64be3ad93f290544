"""The state in which a phase begins or ends: coordinates and speeds of all that a problem has."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rbpsym.algebra import NOTHING, Scalar, derivative, substitute, symbol, time_derivative
from rbpsym.errors import StatementError
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


@dataclass(frozen=True)
class State:
    """Time since the start of the phase (None: no closed form), coordinates and speeds of all that the problem has; the
    conditions under which the motion comes there."""

    time: Scalar | None
    places: Mapping[str, Scalar]
    speeds: Mapping[str, Scalar]
    valid: tuple[Demand, ...] = ()


def at_start(study: Study, phase: Phase | None = None) -> State:
    """Coordinates and speeds of the declared start, dependent ones too."""
    if study.instant is not None:
        return State(NOTHING, study.instant.places, study.instant.speeds)
    start, places, speeds = study.system.scope.start, {}, {}
    for coordinate in study.problem.coordinates:
        name = coordinate.name
        value, rate = of_coordinate(study, name)
        places[name], speeds[name] = (short(substitute(part, start)) for part in (value, rate))
        _require_start(study, name, places[name], speeds[name])
    return State(NOTHING, places, speeds)


def of_coordinate(study: Study, name: str) -> tuple[Scalar, Scalar]:
    """A coordinate and its speed in the independent ones."""
    value, rate = study.system.dependent.get(name, symbol(name)), study.system.scope.rates.get(name)
    return value, time_derivative(value, study.system.scope) if rate is None else rate


def _require_start(study: Study, name: str, *values: Scalar) -> None:
    names = {n for c in study.problem.coordinates for n in (c.name, f"{c.name}_dot")}
    if any(derivative(value, other) for value in values for other in names):
        raise StatementError(
            f"the phases need to know where “{name}” starts and how fast",
            instead=f'give [coordinates.{name}] a start = "..." and a speed = "...".',
            place=next(c.place for c in study.problem.coordinates if c.name == name),
        )
