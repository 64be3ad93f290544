"""When, or where, a coordinate comes to rest."""

from rbpsym.field import is_zero
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, at_start, mover, of_coordinate
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.numbers import floating, sample
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The first moment or place endings.after the start at which the speed of a coordinate vanishes."""
    if endings.are_uniform(study):
        start, gain = at_start(study), endings.gain_of(study, phase, phase.subject)
        speed = start.speeds[phase.subject]
        way = -1 if floating(speed, sample(study.problem)) < 0 else 1
        return endings.run_out(study, phase, speed, gain, Demand(speed * way), Demand(-(gain * way)))
    name = mover(study, phase.subject)
    if name is None or f"{phase.subject}_dot" in study.kept_speeds or is_zero(of_coordinate(study, phase.subject)[1]):
        raise endings.no_closed_form(f"the place at which “{phase.subject}” comes to rest")
    return endings.first_place(study, phase, name, "comes to rest", study.squares[name])


LAW = endings.EventLaw(_ends, lambda study, phase: of_coordinate(study, phase.subject)[1])
