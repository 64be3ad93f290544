"""The impulse of a contact, with that of friction where nothing slips, or of a string."""

from rbpsym.mechanics.contacts import holding_forces, normal_forces
from rbpsym.mechanics.endings import gap
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import Geometry
from rbpsym.mechanics.impulse import Element, Force, Strike, System, approach, is_holding
from rbpsym.mechanics.phase_checks import CLOSE, ArrivalState, Study, numbers_then, value_then, wrong
from rbpsym.mechanics.strings import pulls


def _forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    if "path" in element.values:
        return pulls(element, geometry)
    return (holding_forces if is_holding(element) else normal_forces)(element, geometry)


def _check(study: Study, element: Element, state: ArrivalState, after: System) -> None:
    """What bounces is where it meets, and comes nearer."""
    known, geometry = numbers_then(study, state), geometry_of(study.system)
    if abs(value_then(study, gap(element, geometry), known)) > CLOSE:
        raise wrong(element, "does not meet at that moment", "check the line or the length, the start, or the event.")
    if value_then(study, approach(study.system, element, element.name, after), known) > -CLOSE:
        raise wrong(element, "does not approach", "check the side and the speeds before.")


STRIKE = Strike(_forces, _check, is_one_sided=True)
