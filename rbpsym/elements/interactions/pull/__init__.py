"""A force of given size along the line of two points."""

from rbpsym.elements.kinds import element
from rbpsym.statement.rules import POINTS, between_points

KIND = element(
    __name__,
    "a force of given size along the line of two points, which pulls them together: a rope that is pulled over a fixed "
    "point, a jack (which pushes: negative)",
    rules=(between_points,),
    drawn="cord",
    **POINTS,
    size="force, of speeds: the force, positive where it pulls",
)
