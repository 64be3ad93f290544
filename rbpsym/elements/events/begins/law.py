"""When, or where, what the phase brings closes."""

from collections.abc import Iterator
from contextlib import suppress

from rbpsym.errors import StatementError, there
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, names_in, short, substitute, symbol
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, at_start, first_met, mover
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.numbers import floating, sample
from rbpsym.mechanics.roots import factors_in
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The moment or the place at which what the phase brings closes: a body lands, a string goes taut."""
    value = short(_gap(study, phase))
    name, start, numbers = mover(study), at_start(study), sample(study.problem)
    if name is not None:
        led = {name, *(speed.removesuffix("_dot") for speed in study.kept_speeds)}
        value = substitute(value, {n: place for n, place in start.places.items() if n not in led})
    if not endings.are_uniform(study):
        if name is None or names_in(value) & (led - {name}):
            raise endings.no_closed_form(f"the moment at which “{phase.subject}” begins")
        return endings.first_place(study, phase, name, "begins", value)
    if name is not None and (found := first_met(study, name, value)):
        way = short(found[0] - start.places[name])
        time, asked = endings.time_until(study, phase, way, start.speeds[name], endings.gain_of(study, phase, name))
        return endings.after(study, phase, start, time, [*asked, *found[1]])
    met = _met_in_time(study, phase, short(substitute(value, endings.uniform_motion(study, symbol("t")).places)))
    first = min(met, key=lambda item: floating(item[0], numbers), default=None)
    if first is None:
        raise endings.never(study, phase, endings.UNKNOWN)
    return endings.after(study, phase, start, *first)


def _met_in_time(study: Study, phase: Phase, course: Scalar) -> Iterator[tuple[Scalar, list[Demand]]]:
    """For each factor of a function of the time that has a zero ahead: the first, and where it is that. Raises NotApplicable
    for one of higher degree than two."""
    for factor in factors_in(course, "t"):
        rate = derivative(factor, "t")
        first, speed = (substitute(value, {"t": NOTHING}) for value in (factor, rate))
        if depends_on(gain := derivative(rate, "t"), "t"):
            raise endings.no_closed_form(f"the moment at which “{phase.subject}” begins")
        with suppress(StatementError):
            yield endings.time_until(study, phase, -first, speed, gain)


def _gap(study: Study, phase: Phase) -> Scalar:
    return substitute(endings.gap(there(phase.gap), geometry_of(study.system)), study.system.dependent)


LAW = endings.EventLaw(_ends, _gap)
