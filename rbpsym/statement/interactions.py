"""The interactions that a statement can name: forces and couples that are known laws."""

from __future__ import annotations

from rbpsym.statement.kinds import element, registry

_POINTS = {"between": "points: the two points that it joins"}
_BODIES = {"between": "two bodies: the two bodies that it joins; one may be “ground”"}

INTERACTIONS = registry(
    gravity=element(
        "uniform gravity: the weight of each body, at its centre of mass",
        g="acceleration = g: its acceleration",
        direction="pair of number = 0 | -1: unit vector along which things fall",
        bodies="bodies = all: the bodies that it acts on",
    ),
    spring=element(
        "a linear spring between two points: force stiffness × (distance − natural length)",
        **_POINTS,
        stiffness="stiffness, positive: force per elongation",
        natural_length="length, nonnegative = 0: length at which it is slack",
    ),
    torsion_spring=element(
        "a spiral spring: couple stiffness × (angle of the second body − angle of the first − rest angle)",
        **_BODIES,
        stiffness="torsion stiffness, positive: couple per angle",
        rest_angle="angle = 0: angle between the bodies at which it is slack",
    ),
    pull=element(
        "a force of given size along the line of two points, which pulls them together: a rope that is pulled over a fixed "
        "point, a jack (which pushes: negative)",
        **_POINTS,
        size="force, of speeds: the force, positive where it pulls",
    ),
    damper=element(
        "a dashpot between two points: force coefficient × rate at which their distance changes",
        **_POINTS,
        coefficient="damping, positive: force per speed",
    ),
    rotary_damper=element(
        "a rotary dashpot: couple coefficient × difference of the angular speeds",
        **_BODIES,
        coefficient="rotary damping, positive: couple per angular speed",
    ),
    force=element(
        "an applied force, its components in space or in the frame of the body",
        on="point: the point of a body at which it acts",
        force="pair of force, of speeds: its components",
        frame="one of space | body = space: where the components are fixed",
    ),
    couple=element(
        "an applied couple, counter-clockwise positive",
        on="body: the body that it acts on",
        couple="torque, of speeds: its torque",
        reaction_on="body, optional: the body that feels the opposite couple; absent: an outside agent",
    ),
    resistance=element(
        "a force against the motion of a point: drag of the air, dry friction; where the point starts from rest and the "
        "size is no multiple of its speed, “toward” says which way it goes",
        on="point: the point of a body at which it acts",
        size="force in v (speed), nonnegative, of forces: its magnitude, in which v is the speed of the point: “c*v”, "
        "“k*v**2”, “mu*N” with unknown forces",
        medium="pair of speed = 0 | 0: velocity of what it moves through",
        toward="pair of number, optional: a vector to the side to which it moves; absent: as at the start",
    ),
    resisting_couple=element(
        "a couple against the turning of two bodies relative to each other: dry friction in a hinge, rolling resistance, "
        "drag; “sense” is needed where they start from rest and the size is no multiple of the rate",
        **_BODIES,
        size="torque in omega (angular speed), nonnegative, of forces: its magnitude, in which omega is the rate at which they "
        "turn: “M_f”, “k*omega**2”, “b*N” with unknown forces",
        sense="one of auto | ccw | cw = auto: how the second turns, seen from the first; auto: as at the start",
    ),
)
