"""Where an unknown force has a value."""

from rbpsym.errors import there
from rbpsym.field import symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, mover
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The place at which an unknown force has a value."""
    along, name = study.reactions_along_motion, mover(study)
    if not along or name is None:
        raise endings.no_closed_form(f"the place where “{phase.subject}” has this value")
    return endings.first_place(study, phase, name, "", along[phase.subject] - scalar(there(phase.value)))


LAW = endings.EventLaw(_ends, lambda study, phase: symbol(phase.subject) - scalar(there(phase.value)))
