"""When a coordinate that an equation with the time ties, L cos θ = L cos θ₀ + u t, has a value."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra import NOTHING, Scalar, depends_on, derivative, names_in, substitute
from rbpsym.equality.signs import sign
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.state import State, of_coordinate
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.statement.scope import CLOCK


def tie_to_time(system: System, name: str) -> Scalar | None:
    """What vanishes of a coordinate and the time, in which it stands once and linearly; None if nothing ties it so."""
    rates = system.scope.rates.keys()
    ties = [tie.value for tie in system.implicit if names_in(tie.value) & rates - {CLOCK} == {name}]
    is_linear = len(ties) == 1 and not system.independent and depends_on(ties[0], CLOCK)
    return ties[0] if is_linear and not depends_on(derivative(ties[0], CLOCK), CLOCK) else None


def state_reached(study: Study, name: str, value: Scalar) -> State | None:
    """The state when the coordinate has a value for the first time, if it changes in one sense on the way there from its
    start; None where it is not tied so."""
    if time := time_driven(study, name, value):
        return _at(study, time, {CLOCK: time})
    tie, start = tie_to_time(study.system, name), study.system.scope.start.get(name)
    if tie is None or start is None:
        return None
    there = substitute(tie, {name: value})
    way = sense_to(study, name, (start, value))
    if not way:
        return None
    time = short(-(substitute(there, {CLOCK: NOTHING}) / derivative(there, CLOCK)))
    return _at(study, time, {name: value, CLOCK: time}, Demand((value - start) * way))


def time_driven(study: Study, name: str, value: Scalar) -> Scalar | None:
    """When a coordinate that is itself driven at a steady rate, as an angle Ω t, has a value; None for another one."""
    driven = study.system.dependent.get(name)
    if driven is None or names_in(driven) & {*study.system.scope.rates} - {CLOCK}:
        return None
    rate = derivative(driven, CLOCK)
    is_steady = bool(rate) and not depends_on(rate, CLOCK)
    return short((value - substitute(driven, {CLOCK: NOTHING})) / rate) if is_steady else None


def _at(study: Study, time: Scalar, image: Mapping[str, Scalar], ahead: Demand | None = None) -> State | None:
    """The state then; None where that lies before the start."""
    pairs = {c.name: of_coordinate(study, c.name) for c in study.problem.coordinates}
    places, speeds = ({n: short(substitute(pair[k], image)) for n, pair in pairs.items()} for k in (0, 1))
    valid = settle([ahead or Demand(time)], study.assumptions)
    return None if valid is None else State(time, places, speeds, valid)


def sense_to(study: Study, name: str, ends: tuple[Scalar, Scalar]) -> int:
    """1 or -1 where the time that the tie gives grows, or falls, with the coordinate all the way between two places; else 0."""
    tie = tie_to_time(study.system, name)
    slope = -(derivative(tie, name) / derivative(tie, CLOCK))
    signs = {sign(slope, study.assumptions.with_range(name, *pair)).sense for pair in (ends, ends[::-1])}
    return signs.pop() if len(signs) == 1 else 0
