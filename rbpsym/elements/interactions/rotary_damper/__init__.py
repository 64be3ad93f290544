"""A rotary dashpot."""

from rbpsym.elements.kinds import element
from rbpsym.statement.rules import BODIES, between_bodies

KIND = element(
    __name__,
    "a rotary dashpot: couple coefficient × difference of the angular speeds",
    rules=(between_bodies,),
    drawn="coil",
    **BODIES,
    coefficient="rotary damping, positive: couple per angular speed",
)
