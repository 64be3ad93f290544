"""When, or where, a coordinate has a value."""

from rbpsym.errors import there
from rbpsym.field import short
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, at_start, mover, of_coordinate
from rbpsym.mechanics.led import state_reached
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The moment or the place at which a coordinate has a value."""
    value = scalar(there(phase.value))
    if found := state_reached(study, phase.subject, value):
        return found
    if endings.are_uniform(study):
        start, gain = at_start(study), endings.gain_of(study, phase, phase.subject)
        way = short(value - start.places[phase.subject])
        return endings.after(study, phase, start, *endings.time_until(study, phase, way, start.speeds[phase.subject], gain))
    name = mover(study, phase.subject)
    if name is None or f"{phase.subject}_dot" in study.kept_speeds:
        raise endings.no_closed_form(f"the moment at which “{phase.subject}” reaches its value")
    return endings.first_place(study, phase, name, "", of_coordinate(study, phase.subject)[0] - value)


LAW = endings.EventLaw(_ends, lambda study, phase: of_coordinate(study, phase.subject)[0] - scalar(there(phase.value)))
