"""Where a normal force has gone."""

from dataclasses import replace

from rbpsym.field import symbol
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, mover, state_at
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.study import Study
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The place at which a contact is lost, and the speed there from the first integral."""
    element = study.system.element(phase.subject)
    if not pushes(element):
        cure = "name a contact or a string, or let another event begin the phase."
        raise endings.cannot_end(phase, element, f"is lost, but a {element.kind} holds to both sides", cure)
    loss = next((item for item in study.losses if item.force == phase.subject and item.at), None)
    if loss is not None and (name := mover(study)) is not None and name in loss.at:
        return replace(state_at(study, name, loss.at[name]), valid=loss.valid)
    return endings.first_of_forces(study, phase, "is lost", lambda of: (of(phase.subject),), gives_way=True)


LAW = endings.EventLaw(_ends, lambda study, phase: symbol(phase.subject))
