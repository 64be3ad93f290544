"""A round body that rolls without slipping."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import FRICTION, LIMIT, RIM, ROUGH, ROUND, ROUND_ON_CURVE, TOUCHED

KIND = element(
    __name__,
    "a round body rolls on a line or a circle without slipping: a normal force and static friction",
    unknowns=ROUGH,
    rules=ROUND_ON_CURVE,
    holds="contact",
    **(ROUND | TOUCHED | RIM | FRICTION | LIMIT),
)
