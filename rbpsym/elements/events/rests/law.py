"""When, or where, a coordinate comes to rest."""

from rbpsym.field import is_zero, symbol
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, mover, of_coordinate
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase
from rbpsym.statement.scope import CLOCK


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The first moment or place endings.after the start at which the speed of a coordinate vanishes."""
    if endings.are_uniform(study, CLOCK):
        return endings.first_moment(study, phase, "comes to rest", symbol(f"{phase.subject}_dot"))
    name = mover(study, phase.subject)
    if name is None or f"{phase.subject}_dot" in study.kept_speeds or is_zero(of_coordinate(study, phase.subject)[1]):
        raise endings.no_closed_form(f"the place at which “{phase.subject}” comes to rest")
    return endings.first_place(study, phase, name, "comes to rest", study.squares[name])


LAW = endings.EventLaw(_ends, lambda study, phase: of_coordinate(study, phase.subject)[1])
