"""Where static friction is at its limit."""

from rbpsym.field import symbol
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, mover
from rbpsym.mechanics.friction import spare
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The place at which static friction reaches its limit: |f| = μ N."""
    element = study.system.element(phase.subject)
    if element.values.get("limit") is None:
        raise endings.cannot_end(phase, element, "slips, but its static friction has no limit", 'give it a limit = "mu".')
    along, name = study.reactions_along_motion, mover(study)
    if not along or name is None:
        return endings.first_moment(study, phase, "slips", *spare(element, symbol), gives_way=True)
    return endings.first_place(study, phase, name, "slips", *spare(element, along.__getitem__), gives_way=True)


LAW = endings.EventLaw(_ends)
