"""At once: the start."""

from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import at_start

LAW = endings.EventLaw(at_start)
