"""A round body that touches a line or a circle, and may slide along it."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import NORMAL, RIM, ROUND, ROUND_ON_CURVE, SLIDING, TOUCHED, as_touching, slides

KIND = element(
    __name__,
    "a round body touches a line or a circle and may slide along it",
    unknowns=NORMAL,
    rules=(*ROUND_ON_CURVE, slides),
    holds="contact",
    told=as_touching,
    **(ROUND | TOUCHED | RIM | SLIDING),
)
