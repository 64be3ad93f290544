"""The state after a stated time."""

from rbpsym.errors import there
from rbpsym.field import symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, at_start
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase
from rbpsym.statement.scope import CLOCK


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The state endings.after a stated time."""
    time = scalar(there(phase.value))
    return endings.after(study, phase, at_start(study), time, [Demand(time)])


LAW = endings.EventLaw(_ends, lambda study, phase: symbol(CLOCK) - scalar(there(phase.value)))
