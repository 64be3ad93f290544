"""A dashpot."""

from rbpsym.elements.kinds import element
from rbpsym.statement.rules import POINTS, between_points

KIND = element(
    __name__,
    "a dashpot between two points: force coefficient × rate at which their distance changes",
    rules=(between_points,),
    drawn="link",
    **POINTS,
    coefficient="damping, positive: force per speed",
)
