"""The constraints that a statement can name: a condition, and the unknown forces that keep it."""

from __future__ import annotations

from rbpsym.statement.kinds import element, registry

_COMPONENTS = {"{name}_x": "force", "{name}_y": "force"}
_NORMAL = {"{name}": "force"}
_ROUGH = {**_NORMAL, "{friction}": "force"}
_COUPLE = {"{couple}": "torque"}
_COUPLE_NAME = {"couple": "name = tau_{name}: name of the unknown couple"}
_OF = {"of": "body, optional: the body to which the line belongs, x and y being its own; absent: it is fixed"}
_LINE = {"line": "line, optional: the line that is touched, as an equation in x and y: “y = 0”"}
_SIDE = {
    "side": "one of auto | positive | negative | outside | inside = auto: side to which the force pushes: of a line, positive is "
    "where the left side of the equation is the greater one; of a circle, outside or inside; auto: where the body is"
}
_CURVE = {
    **_OF,
    "circle": "point, optional: instead of a line: the centre of the circle that is touched",
    "radius": "length, nonnegative, optional: radius of that circle; absent: that of the round body whose centre it is; 0 for a "
    "corner that a round body touches",
}
_BENT = {
    "curve": "curve, optional: instead of a line: a smooth fixed curve, “y = x**2/(2*p)”, or two functions of a coordinate, "
    '["R*cos(q)", "b*sin(q)"]; its positive side is above it (to the left, as the coordinate grows)'
}
_FRICTION = {"friction": "name = f_{name}: name of the force of friction"}
_SLIDING = {
    "coefficient": "number, nonnegative, optional: coefficient of kinetic friction; absent: smooth",
    "slip": "one of auto | forward | backward = auto: the sense in which it slips, seen with the normal upwards: forward is to "
    "the right; auto: as at the start",
    **_FRICTION,
}
_LIMIT = {"limit": "number, nonnegative, optional: coefficient of static friction; absent: as much as is needed"}
_POINT = {"point": "point: the point that touches"}
_ROUND = {"body": "body: the round body that touches"}
_RIM = {"rim": "length, positive, optional: radius at which it touches; absent: its own"}
MEETING = {
    "point": "point, optional: the point that touches",
    "body": "body, optional: or the round body that does",
    **_LINE,
    **_SIDE,
    **_CURVE,
    **_RIM,
    "path": "path, optional: or the two points that a string joins",
    "length": "length, positive, optional: length of the string",
}

CONSTRAINTS = registry(
    pivot=element(
        "a point of a body is held at a fixed place, free to turn there",
        unknowns=_COMPONENTS,
        point="point: the point that is held",
        at="pair of length, of time, optional: where it is held; absent: where the body's pose puts it",
    ),
    pin=element(
        "a point of one body is joined to a point of another, free to turn; the force is on the second",
        "bearing",
        unknowns=_COMPONENTS,
        points="points: the two points that coincide, of two bodies",
    ),
    weld=element(
        "a body is fixed to another, or to a place; force and couple are on the second (or on the body)",
        unknowns={**_COMPONENTS, **_COUPLE},
        points="points: the two points that coincide; one may be a fixed place",
        angle="angle, optional: angle of the second body minus that of the first; absent: as in the poses if they have both, "
        "else 0",
        **_COUPLE_NAME,
    ),
    contact=element(
        "a point touches a line, a circle or a curve and may slide along it; the force is normal to the curve",
        unknowns=_NORMAL,
        **(_POINT | _LINE | _SIDE | _CURVE | _BENT | _SLIDING),
    ),
    guide=element(
        "a point is led by a smooth slot along a line, a circle or a curve; the force may push to both sides",
        "slot",
        unknowns=_NORMAL,
        point="point: the point that is led",
        **(_LINE | _CURVE | _BENT),
    ),
    slider=element(
        "a body slides along a line without turning; the force is normal to the line, a couple keeps the angle",
        unknowns={**_NORMAL, **_COUPLE},
        point="point: the point that is on the line",
        **(_LINE | _SIDE | _OF | _SLIDING | _COUPLE_NAME),
    ),
    touch=element(
        "a round body touches a line or a circle and may slide along it",
        unknowns=_NORMAL,
        **(_ROUND | _LINE | _SIDE | _CURVE | _RIM | _SLIDING),
    ),
    rolling=element(
        "a round body rolls on a line or a circle without slipping: a normal force and static friction",
        unknowns=_ROUGH,
        **(_ROUND | _LINE | _SIDE | _CURVE | _RIM | _FRICTION | _LIMIT),
    ),
    gear=element(
        "a toothed wheel meshes with a rack (a line) or with another wheel (a circle): they do not slip, and the force "
        "of the teeth is along the common tangent of the pitch circles; bearings keep them apart",
        "mesh",
        unknowns=_NORMAL,
        **(_ROUND | _LINE | _SIDE | _CURVE | _RIM),
    ),
    sticking=element(
        "a point touches a rough line or circle and does not slip: a normal force and static friction",
        unknowns=_ROUGH,
        **(_POINT | _LINE | _SIDE | _CURVE | _FRICTION | _LIMIT),
        beside="constraint, optional: a smooth contact of the same body with the same surface, for a body that stands on two "
        "points: the friction is that of both, and its limit rests on both normal forces",
    ),
    string=element(
        "a massless inextensible string, taut between its ends and round pulleys and drums; it pulls",
        "rope",
        path="path: what it joins, from end to end: points, and round bodies with the sense in which it runs round "
        "them, going along the path: “cw pulley”, “ccw drum”; on an axle of another radius than the body's "
        '`{ around = "yoyo", radius = "r", sense = "ccw" }`, round a smooth fixed pulley '
        '`{ around = "Q", radius = "R", sense = "cw" }`, over a smooth peg `{ around = "Q" }`',
        length="length, positive, of time, optional: length between two points, which may change with the time t (a winch): "
        "“L - u*t”; absent: as at the start",
    ),
    link=element(
        "a light rigid rod between two points: it keeps their distance, and pulls or pushes",
        "light-rod",
        points="path: the two points that it joins",
        length="length, positive, of time, optional: its length, which may change with the time t (a telescope); absent: as at "
        "the start",
    ),
    prescribed=element(
        "a point is driven along a direction: its place is a given function of time; an unknown force drives it",
        unknowns=_NORMAL,
        point="point: the point that is driven",
        distance="length, of time: place along the direction, a function of the time t",
        along="pair of number = 1 | 0: unit vector of the direction",
        of="body, optional: the body along which it is driven, which feels the opposite force: direction and place are those in "
        "its frame; absent: in space, by an outside agent",
    ),
    prescribed_angle=element(
        "a body is turned: its angle is a given function of time; an unknown couple drives it",
        unknowns={"{name}": "torque"},
        body="body: the body that is turned",
        angle="angle, of time: its angle, a function of the time t",
        of="body, optional: the body against which it is turned, which feels the opposite couple (a motor on it); absent: the "
        "angle is from +x, and an outside agent turns it",
    ),
)
