"""A point in a smooth slot, which may push to both sides."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import BENT, CURVE, LINE, NORMAL, ON_CURVE

KIND = element(
    __name__,
    "a point is led by a smooth slot along a line, a circle or a curve; the force may push to both sides",
    "slot",
    unknowns=NORMAL,
    rules=ON_CURVE,
    drawn="guide",
    point="point: the point that is led",
    **(LINE | CURVE | BENT),
)
