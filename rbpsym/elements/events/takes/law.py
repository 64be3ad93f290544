"""Where an unknown force has a value."""

from rbpsym.errors import there
from rbpsym.field import symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The place at which an unknown force has a value."""
    return endings.first_of_forces(study, phase, "", lambda of: (of(phase.subject) - scalar(there(phase.value)),))


LAW = endings.EventLaw(_ends, lambda study, phase: symbol(phase.subject) - scalar(there(phase.value)))
