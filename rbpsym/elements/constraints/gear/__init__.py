"""A toothed wheel on a rack, or two that mesh."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import NORMAL, RIM, ROUND, ROUND_ON_CURVE, TOUCHED

KIND = element(
    __name__,
    "a toothed wheel meshes with a rack (a line) or with another wheel (a circle): they do not slip, and the force "
    "of the teeth is along the common tangent of the pitch circles; bearings keep them apart",
    "mesh",
    unknowns=NORMAL,
    rules=ROUND_ON_CURVE,
    holds="teeth",
    **(ROUND | TOUCHED | RIM),
)
