"""A point that touches a rough line or circle and does not slip."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import FRICTION, LIMIT, ON_CURVE, POINT, ROUGH, TOUCHED, as_touching

KIND = element(
    __name__,
    "a point touches a rough line or circle and does not slip: a normal force and static friction",
    unknowns=ROUGH,
    rules=ON_CURVE,
    holds="contact",
    told=as_touching,
    **(POINT | TOUCHED | FRICTION | LIMIT),
    beside="constraint, optional: a smooth contact of the same body with the same surface, for a body that stands on two "
    "points: the friction is that of both, and its limit rests on both normal forces",
)
