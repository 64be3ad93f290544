"""A spiral spring."""

from rbpsym.elements.kinds import element
from rbpsym.statement.rules import BODIES, between_bodies

KIND = element(
    __name__,
    "a spiral spring: couple stiffness × (angle of the second body − angle of the first − rest angle)",
    rules=(between_bodies,),
    drawn="coil",
    **BODIES,
    stiffness="torsion stiffness, positive: couple per angle",
    rest_angle="angle = 0: angle between the bodies at which it is slack",
)
