"""The impulse as it is given."""

from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.impulse import Strike, at_points

STRIKE = Strike(lambda element, geometry: at_points(element, geometry, (element["on"], pair(element["impulse"]))))
