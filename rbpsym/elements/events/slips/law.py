"""Where static friction is at its limit."""

from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState
from rbpsym.mechanics.friction import spare
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The place at which static friction reaches its limit: |f| = μ N."""
    element = study.system.element(phase.subject)
    if element.values.get("limit") is None:
        raise endings.cannot_end(phase, element, "slips, but its static friction has no limit", 'give it a limit = "mu".')
    return endings.first_of_forces(study, phase, "slips", lambda of: spare(element, of), gives_way=True)


LAW = endings.EventLaw(_ends)
