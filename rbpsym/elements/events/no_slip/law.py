"""When, or where, a slip has gone."""

from rbpsym.field import NOTHING, Scalar, is_zero, short, substitute, time_derivative
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import ArrivalState, at_start, mover
from rbpsym.mechanics.contacts import meeting, slip_speed
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import by_letters
from rbpsym.statement.model import Phase


def _ends(study: Study, phase: Phase) -> ArrivalState:
    """The moment at which a slip that changes uniformly has gone."""
    element = study.system.element(phase.subject)
    if element.values.get("coefficient") is None:
        what = "stops slipping, but it has no kinetic friction"
        raise endings.cannot_end(phase, element, what, 'give it a coefficient = "mu".')
    slip = short(_gap(study, phase))
    if not endings.are_uniform(study):
        return _at_rest(study, phase, slip)
    gain = short(substitute(time_derivative(slip, study.system.scope), endings.uniform(study, phase)))
    start = at_start(study)
    first = short(substitute(slip, by_letters(start.speeds) | dict(start.places)))
    if is_zero(first):
        cure = "where two contacts stop slipping at the same moment, let both roll from one phase on."
        raise endings.cannot_end(phase, element, "stops slipping, and it does not slip any more before", cure)
    return endings.run_out(study, phase, first, gain, Demand(-(first * gain)))


def _at_rest(study: Study, phase: Phase, slip: Scalar) -> ArrivalState:
    """Where the one coordinate that moves comes to rest, and with it the slip."""
    name = mover(study)
    if name is None or not is_zero(substitute(slip, {f"{name}_dot": NOTHING})):
        raise endings.not_uniform(phase)
    return endings.first_place(study, phase, name, "stops slipping", study.squares[name])


def _gap(study: Study, phase: Phase) -> Scalar:
    geometry = geometry_of(study.system)
    return substitute(slip_speed(geometry, meeting(study.system.element(phase.subject), geometry)), study.system.dependent)


LAW = endings.EventLaw(_ends, _gap)
