"""The interactions that a statement can name: forces and couples that are known laws."""

from __future__ import annotations

from rbpsym.quantities import ACCELERATION, DIMENSIONS, FORCE, LENGTH, NUMBER
from rbpsym.statement.kinds import ElementKind, Field, registry

_SPEED, _SPIN = DIMENSIONS["speed"], DIMENSIONS["angular speed"]
_TORQUE, _STIFFNESS = DIMENSIONS["torque"], DIMENSIONS["stiffness"]
_BETWEEN_POINTS = Field("between", "points", "the two points that it joins")
_BETWEEN_BODIES = Field("between", "two bodies", "the two bodies that it joins; one may be “ground”")

INTERACTIONS: dict[str, ElementKind] = registry(
    ElementKind(
        "gravity",
        "uniform gravity: the weight of each body, at its centre of mass",
        (
            Field("g", "expression", "its acceleration", ACCELERATION, default="g"),
            Field("direction", "pair", "unit vector along which things fall", NUMBER, default=["0", "-1"]),
            Field("bodies", "bodies", "the bodies that it acts on", default="all"),
        ),
    ),
    ElementKind(
        "spring",
        "a linear spring between two points: force stiffness × (distance − natural length)",
        (
            _BETWEEN_POINTS,
            Field("stiffness", "expression", "force per elongation", _STIFFNESS, sign="positive"),
            Field(
                "natural_length", "expression", "length at which it is slack", LENGTH, default="0", sign="nonnegative"
            ),
        ),
    ),
    ElementKind(
        "torsion-spring",
        "a spiral spring: couple stiffness × (angle of the second body − angle of the first − rest angle)",
        (
            _BETWEEN_BODIES,
            Field("stiffness", "expression", "couple per angle", DIMENSIONS["torsion stiffness"], sign="positive"),
            Field("rest_angle", "expression", "angle between the bodies at which it is slack", NUMBER, default="0"),
        ),
    ),
    ElementKind(
        "pull",
        "a force of given size along the line of two points, which pulls them together: a rope that is pulled over a fixed "
        "point, a jack (which pushes: negative)",
        (
            _BETWEEN_POINTS,
            Field("size", "expression", "the force, positive where it pulls", FORCE, may_use="speeds"),
        ),
    ),
    ElementKind(
        "damper",
        "a dashpot between two points: force coefficient × rate at which their distance changes",
        (
            _BETWEEN_POINTS,
            Field("coefficient", "expression", "force per speed", DIMENSIONS["damping"], sign="positive"),
        ),
    ),
    ElementKind(
        "rotary-damper",
        "a rotary dashpot: couple coefficient × difference of the angular speeds",
        (
            _BETWEEN_BODIES,
            Field(
                "coefficient", "expression", "couple per angular speed", DIMENSIONS["rotary damping"], sign="positive"
            ),
        ),
    ),
    ElementKind(
        "force",
        "an applied force, its components in space or in the frame of the body",
        (
            Field("on", "point", "the point of a body at which it acts"),
            Field("force", "pair", "its components", FORCE, may_use="speeds"),
            Field("frame", "choice", "where the components are fixed", default="space", choices=("space", "body")),
        ),
    ),
    ElementKind(
        "couple",
        "an applied couple, counter-clockwise positive",
        (
            Field("on", "body", "the body that it acts on"),
            Field("couple", "expression", "its torque", _TORQUE, may_use="speeds"),
            Field(
                "reaction_on", "body", "the body that feels the opposite couple; absent: an outside agent", default=""
            ),
        ),
    ),
    ElementKind(
        "resistance",
        "a force against the motion of a point: drag of the air, dry friction; where the point starts from rest and the "
        "size is no multiple of its speed, “toward” says which way it goes",
        (
            Field("on", "point", "the point of a body at which it acts"),
            Field(
                "size",
                "expression",
                "its magnitude, in which v is the speed of the point: “c*v”, “k*v**2”, “mu*N” with unknown forces",
                FORCE,
                may_use="forces",
                sign="nonnegative",
                variables=(("v", _SPEED),),
            ),
            Field("medium", "pair", "velocity of what it moves through", _SPEED, default=["0", "0"]),
            Field("toward", "pair", "a vector to the side to which it moves; absent: as at the start", NUMBER, default=""),
        ),
    ),
    ElementKind(
        "resisting-couple",
        "a couple against the turning of two bodies relative to each other: dry friction in a hinge, rolling resistance, "
        "drag; “sense” is needed where they start from rest and the size is no multiple of the rate",
        (
            _BETWEEN_BODIES,
            Field(
                "size",
                "expression",
                "its magnitude, in which omega is the rate at which they turn: “M_f”, “k*omega**2”, “b*N” with unknown forces",
                _TORQUE,
                may_use="forces",
                sign="nonnegative",
                variables=(("omega", _SPIN),),
            ),
            Field(
                "sense",
                "choice",
                "how the second turns, seen from the first; auto: as at the start",
                default="auto",
                choices=("auto", "ccw", "cw"),
            ),
        ),
    ),
)
