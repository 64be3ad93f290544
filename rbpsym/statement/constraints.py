"""The constraints that a statement can name: a condition, and the unknown forces that keep it."""

from __future__ import annotations

from rbpsym.quantities import DIMENSIONS, FORCE, LENGTH, NUMBER
from rbpsym.statement.kinds import ElementKind, Field, registry

_COMPONENTS = (("{name}_x", FORCE), ("{name}_y", FORCE))

_TORQUE = DIMENSIONS["torque"]
_LINE = Field("line", "line", "the line that is touched, as an equation in x and y: “y = 0”", default="")
_SIDE = Field(
    "side",
    "choice",
    "side to which the force pushes: of a line, positive is where the left side of the equation is the greater "
    "one; of a circle, outside or inside; auto: where the body is",
    default="auto",
    choices=("auto", "positive", "negative", "outside", "inside"),
)
_CURVE = (
    Field("of", "body", "the body to which the line belongs, x and y being its own; absent: it is fixed", default=""),
    Field("circle", "point", "instead of a line: the centre of the circle that is touched", default=""),
    Field(
        "radius",
        "expression",
        "radius of that circle; absent: that of the round body whose centre it is; 0 for a corner that a round body "
        "touches",
        LENGTH,
        default="",
        sign="nonnegative",
    ),
)
_BENT = Field(
    "curve",
    "curve",
    "instead of a line: a smooth fixed curve, “y = x**2/(2*p)”, or two functions of a coordinate, [\"R*cos(q)\", \"b*sin(q)\"]; "
    "its positive side is above it (to the left, as the coordinate grows)",
    default="",
)
_FRICTION = Field("friction", "name", "name of the force of friction", default="f_{name}")
SLIPS = Field(
    "slip",
    "choice",
    "the sense in which it slips, seen with the normal upwards: forward is to the right; auto: as at the start",
    default="auto",
    choices=("auto", "forward", "backward"),
)
_SLIDING = (
    Field(
        "coefficient",
        "expression",
        "coefficient of kinetic friction; absent: smooth",
        NUMBER,
        default="",
        sign="nonnegative",
    ),
    SLIPS,
    _FRICTION,
)
_LIMIT = Field(
    "limit",
    "expression",
    "coefficient of static friction; absent: as much as is needed",
    NUMBER,
    default="",
    sign="nonnegative",
)
_BESIDE = Field(
    "beside",
    "constraint",
    "a smooth contact of the same body with the same surface, for a body that stands on two points: the friction is that of "
    "both, and its limit rests on both normal forces",
    default="",
)
_POINT = Field("point", "point", "the point that touches")
_ROUND = Field("body", "body", "the round body that touches")
_RIM = Field("rim", "expression", "radius at which it touches; absent: its own", LENGTH, default="", sign="positive")
MEETING = (
    Field("point", "point", "the point that touches", default=""),
    Field("body", "body", "or the round body that does", default=""),
    _LINE,
    _SIDE,
    *_CURVE,
    _RIM,
    Field("path", "path", "or the two points that a string joins", default=""),
    Field("length", "expression", "length of the string", LENGTH, default="", sign="positive"),
)
_NORMAL, _ROUGH = ("{name}", FORCE), ("{friction}", FORCE)
_TIME_PLACE = "a function of the time t"

CONSTRAINTS: dict[str, ElementKind] = registry(
    ElementKind(
        "pivot",
        "a point of a body is held at a fixed place, free to turn there",
        (
            Field("point", "point", "the point that is held"),
            Field(
                "at",
                "pair",
                "where it is held; absent: where the body's pose puts it",
                LENGTH,
                default="",
                may_use="time",
            ),
        ),
        unknowns=_COMPONENTS,
    ),
    ElementKind(
        "pin",
        "a point of one body is joined to a point of another, free to turn; the force is on the second",
        (Field("points", "points", "the two points that coincide, of two bodies"),),
        aliases=("bearing",),
        unknowns=_COMPONENTS,
    ),
    ElementKind(
        "weld",
        "a body is fixed to another, or to a place; force and couple are on the second (or on the body)",
        (
            Field("points", "points", "the two points that coincide; one may be a fixed place"),
            Field(
                "angle",
                "expression",
                "angle of the second body minus that of the first; absent: as in the poses if they have both, else 0",
                NUMBER,
                default="",
            ),
            Field("couple", "name", "name of the unknown couple", default="tau_{name}"),
        ),
        unknowns=(*_COMPONENTS, ("{couple}", DIMENSIONS["torque"])),
    ),
    ElementKind(
        "contact",
        "a point touches a line, a circle or a curve and may slide along it; the force is normal to the curve",
        (_POINT, _LINE, _SIDE, *_CURVE, _BENT, *_SLIDING),
        unknowns=(_NORMAL,),
    ),
    ElementKind(
        "guide",
        "a point is led by a smooth slot along a line, a circle or a curve; the force may push to both sides",
        (Field("point", "point", "the point that is led"), _LINE, *_CURVE, _BENT),
        aliases=("slot",),
        unknowns=(_NORMAL,),
    ),
    ElementKind(
        "slider",
        "a body slides along a line without turning; the force is normal to the line, a couple keeps the angle",
        (
            Field("point", "point", "the point that is on the line"),
            _LINE,
            _SIDE,
            _CURVE[0],
            *_SLIDING,
            Field("couple", "name", "name of the unknown couple", default="tau_{name}"),
        ),
        unknowns=(_NORMAL, ("{couple}", _TORQUE)),
    ),
    ElementKind(
        "touch",
        "a round body touches a line or a circle and may slide along it",
        (_ROUND, _LINE, _SIDE, *_CURVE, _RIM, *_SLIDING),
        unknowns=(_NORMAL,),
    ),
    ElementKind(
        "rolling",
        "a round body rolls on a line or a circle without slipping: a normal force and static friction",
        (_ROUND, _LINE, _SIDE, *_CURVE, _RIM, _FRICTION, _LIMIT),
        unknowns=(_NORMAL, _ROUGH),
    ),
    ElementKind(
        "gear",
        "a toothed wheel meshes with a rack (a line) or with another wheel (a circle): they do not slip, and the force "
        "of the teeth is along the common tangent of the pitch circles; bearings keep them apart",
        (_ROUND, _LINE, _SIDE, *_CURVE, _RIM),
        aliases=("mesh",),
        unknowns=(_NORMAL,),
    ),
    ElementKind(
        "sticking",
        "a point touches a rough line or circle and does not slip: a normal force and static friction",
        (_POINT, _LINE, _SIDE, *_CURVE, _FRICTION, _LIMIT, _BESIDE),
        unknowns=(_NORMAL, _ROUGH),
    ),
    ElementKind(
        "string",
        "a massless inextensible string, taut between its ends and round pulleys and drums; it pulls",
        (
            Field(
                "path",
                "path",
                "what it joins, from end to end: points, and round bodies with the sense in which it runs round "
                "them, going along the path: “cw pulley”, “ccw drum”; on an axle of another radius than the body's "
                '`{ around = "yoyo", radius = "r", sense = "ccw" }`, round a smooth fixed pulley '
                '`{ around = "Q", radius = "R", sense = "cw" }`, over a smooth peg `{ around = "Q" }`',
            ),
            Field(
                "length",
                "expression",
                "length between two points, which may change with the time t (a winch): “L - u*t”; absent: as at the start",
                LENGTH,
                default="",
                may_use="time",
                sign="positive",
            ),
        ),
        aliases=("rope",),
    ),
    ElementKind(
        "link",
        "a light rigid rod between two points: it keeps their distance, and pulls or pushes",
        (
            Field("points", "path", "the two points that it joins"),
            Field(
                "length",
                "expression",
                "its length, which may change with the time t (a telescope); absent: as at the start",
                LENGTH,
                default="",
                may_use="time",
                sign="positive",
            ),
        ),
        aliases=("light-rod",),
        read_as="string",
    ),
    ElementKind(
        "prescribed",
        "a point is driven along a direction: its place is a given function of time; an unknown force drives it",
        (
            Field("point", "point", "the point that is driven"),
            Field("distance", "expression", f"place along the direction, {_TIME_PLACE}", LENGTH, may_use="time"),
            Field("along", "pair", "unit vector of the direction", NUMBER, default=["1", "0"]),
            Field(
                "of",
                "body",
                "the body along which it is driven, which feels the opposite force: direction and place are those in its frame; "
                "absent: in space, by an outside agent",
                default="",
            ),
        ),
        unknowns=(_NORMAL,),
    ),
    ElementKind(
        "prescribed-angle",
        "a body is turned: its angle is a given function of time; an unknown couple drives it",
        (
            Field("body", "body", "the body that is turned"),
            Field("angle", "expression", f"its angle, {_TIME_PLACE}", NUMBER, may_use="time"),
            Field(
                "of",
                "body",
                "the body against which it is turned, which feels the opposite couple (a motor on it); absent: the "
                "angle is from +x, and an outside agent turns it",
                default="",
            ),
        ),
        unknowns=(("{name}", _TORQUE),),
    ),
)
