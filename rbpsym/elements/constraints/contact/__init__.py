"""A point that touches a line, a circle or a curve, and may slide along it."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import BENT, NORMAL, ON_CURVE, POINT, SLIDING, TOUCHED, as_touching, slides

KIND = element(
    __name__,
    "a point touches a line, a circle or a curve and may slide along it; the force is normal to the curve",
    unknowns=NORMAL,
    rules=(*ON_CURVE, slides),
    holds="contact",
    told=as_touching,
    **(POINT | TOUCHED | BENT | SLIDING),
)
