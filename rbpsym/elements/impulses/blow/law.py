"""The impulse as it is given."""

from rbpsym.mechanics.geometry import Geometry, pair
from rbpsym.mechanics.impulse import Element, Force, Strike, at_points


def _forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    return at_points(element, geometry, (element["on"], pair(element["impulse"])))


STRIKE = Strike(_forces)
