"""The shapes that a body can have, each as data: how its mass is spread, never its moment.

The frame of a shape has its origin at the point that lies at (0, 0) in `points`. An element's
ranges stand from the outermost variable to the innermost. Text in `spread`, `size` and
`points` is in the shape's own sizes.
"""

from __future__ import annotations

from rbpsym.elements.kinds import ElementText, registry, shape
from rbpsym.quantities import DIMENSIONS

_RADIUS = {"radius": "length, positive: radius"}
_OPENING = {"opening": "angle, positive: angle between its two ends, seen from the centre"}
_FULL_TURN, _HALF_TURN, _OPEN = ("phi", "0", "2*pi"), ("phi", "0", "pi"), ("phi", "-opening/2", "opening/2")
_CENTER = "center 0 0"
_HALF_POINTS = f"{_CENTER}, left -radius 0, right radius 0, top 0 radius"
_ARC_POINTS = (
    f"{_CENTER}, middle radius 0, upper radius*cos(opening/2) radius*sin(opening/2), "
    "lower radius*cos(opening/2) -radius*sin(opening/2)"
)
_CARTESIAN = (("x", "x"), ("y", "y"))
_POLAR = (("x", "r*cos(phi)"), ("y", "r*sin(phi)"), ("r", "r"), ("phi", "phi"))
_CIRCLE = (("x", "radius*cos(phi)"), ("y", "radius*sin(phi)"), ("phi", "phi"))


def _polar(inner: str, outer: str, turn: tuple[str, str, str]) -> ElementText:
    return ElementText((("r", inner, outer), turn), "r*cos(phi)", "r*sin(phi)", "r")


def _arc(turn: tuple[str, str, str]) -> ElementText:
    return ElementText((turn,), "radius*cos(phi)", "radius*sin(phi)", "radius", "line")


def _round(outer: tuple[str, str, str], x: str, y: str, measure: str = "r", kind: str = "volume") -> ElementText:
    """A solid or a shell of revolution: slices across an axis, full circles in each."""
    disk = (("r", "0", f"sqrt(radius**2 - {outer[0]}**2)"),) if kind == "volume" else ()
    return ElementText((outer, *disk, _FULL_TURN), x, y, measure, kind)


_THROUGH, _UP = ("z", "-radius", "radius"), ("y", "0", "radius")
SHAPES = registry(
    particle=shape("a point mass", spread=ElementText((), "0", "0", kind="point"), size="1", points=_CENTER, has_angle=False),
    rod=shape(
        "a thin straight rod along the axis of the body", length="length, positive: length",
        spread=ElementText((("s", "0", "length"),), "s - length/2", "0", kind="line"), size="length",
        points=f"{_CENTER}, start -length/2 0, end length/2 0", density=(("s", "s"),),
    ),
    ring=shape(
        "a thin circular ring", "hoop", **_RADIUS,
        spread=_arc(_FULL_TURN), size="2*pi*radius", points=_CENTER, density=_CIRCLE,
    ),
    disk=shape(
        "a circular disk", "cylinder", **_RADIUS,
        spread=_polar("0", "radius", _FULL_TURN), size="pi*radius**2", points=_CENTER, density=_POLAR,
    ),
    annulus=shape(
        "a disk with a concentric round hole", inner="length, positive: inner radius", outer="length, positive: outer radius",
        spread=_polar("inner", "outer", _FULL_TURN), size="pi*(outer**2 - inner**2)", points=_CENTER, density=_POLAR,
    ),
    ball=shape(
        "a solid ball", "sphere", **_RADIUS,
        spread=_round(_THROUGH, "r*cos(phi)", "r*sin(phi)"), size="4*pi*radius**3/3", points=_CENTER,
    ),
    shell=shape(
        "a thin spherical shell", **_RADIUS, size="4*pi*radius**2", points=_CENTER,
        spread=_round(_THROUGH, "sqrt(radius**2 - z**2)*cos(phi)", "sqrt(radius**2 - z**2)*sin(phi)", "radius", "surface"),
    ),
    rectangle=shape(
        "a rectangular plate, its width along the axis of the body",
        width="length, positive: side along the axis", height="length, positive: side across the axis",
        spread=ElementText((("x", "-width/2", "width/2"), ("y", "-height/2", "height/2")), "x", "y"), size="width*height",
        points=f"{_CENTER}, left -width/2 0, right width/2 0, bottom 0 -height/2, top 0 height/2, "
        "bottom_left -width/2 -height/2, bottom_right width/2 -height/2, top_left -width/2 height/2, top_right width/2 height/2",
        density=_CARTESIAN,
    ),
    triangle=shape(
        "a triangular plate, its base along the axis of the body",
        base="length, positive: base", height="length, positive: height over the base",
        offset="length = 0: how far the top stands to the right of the middle of the base",
        spread=ElementText(
            (("y", "0", "height"), ("x", "-base/2 + (offset + base/2)*y/height", "base/2 + (offset - base/2)*y/height")), "x", "y"
        ),
        size="base*height/2", points="middle 0 0, left -base/2 0, right base/2 0, top offset height", density=_CARTESIAN,
    ),
    half_disk=shape(
        "half a disk, its straight edge along the axis of the body", **_RADIUS,
        spread=_polar("0", "radius", _HALF_TURN), size="pi*radius**2/2", points=_HALF_POINTS, density=_POLAR,
    ),
    half_ring=shape(
        "a thin semicircular wire, its ends on the axis of the body", **_RADIUS,
        spread=_arc(_HALF_TURN), size="pi*radius", points=_HALF_POINTS, density=_CIRCLE,
    ),
    sector=shape(
        "a sector of a circular disk, the axis of the body halving its angle", **_RADIUS, **_OPENING,
        spread=_polar("0", "radius", _OPEN), size="opening*radius**2/2", points=_ARC_POINTS, density=_POLAR,
    ),
    arc=shape(
        "a thin wire along an arc of a circle, the axis of the body halving its angle", **_RADIUS, **_OPENING,
        spread=_arc(_OPEN), size="opening*radius", points=_ARC_POINTS, density=_CIRCLE,
    ),
    hemisphere=shape(
        "half a solid ball, its flat side along the axis of the body", "half-ball", **_RADIUS,
        spread=_round(_UP, "r*cos(phi)", "y"), size="2*pi*radius**3/3", points=_HALF_POINTS,
    ),
    hemispherical_shell=shape(
        "half a thin spherical shell, its rim along the axis of the body", "half-shell", **_RADIUS, size="2*pi*radius**2",
        spread=_round(_UP, "sqrt(radius**2 - y**2)*cos(phi)", "y", "radius", "surface"), points=_HALF_POINTS,
    ),
    ellipse=shape(
        "an elliptic plate",
        half_width="length, positive: semi-axis along the axis", half_height="length, positive: semi-axis across the axis",
        spread=ElementText(
            (("r", "0", "1"), _FULL_TURN), "half_width*r*cos(phi)", "half_height*r*sin(phi)", "half_width*half_height*r"
        ),
        size="pi*half_width*half_height",
        points=f"{_CENTER}, left -half_width 0, right half_width 0, bottom 0 -half_height, top 0 half_height",
    ),
    polygon=shape(
        "a plate with straight edges, made of the triangles that its edges form with the origin of its frame",
        vertices="vertices of length: its corners in its frame, three or more, counter-clockwise",
        spread=ElementText(
            (("u", "0", "1"), ("v", "0", "1")), "u*(x_p + v*(x_q - x_p))", "u*(y_p + v*(y_q - y_p))", "u*(x_p*y_q - x_q*y_p)"
        ),
        size="(x_p*y_q - x_q*y_p)/2", points="origin 0 0",
    ),
    composite=shape(
        "parts joined to one rigid body, some of them cut out", points="origin 0 0",
        parts="parts: its parts: shapes with sizes, at, angle, removed, and a mass each or none",
    ),
    given=shape(
        "a body whose moment of inertia about its centre of mass, its `center`, is given", points=_CENTER,
        moment="moment of inertia, positive: moment of inertia about the centre of mass",
        radius="length, positive, optional: its radius, if it is round: where it touches, and strings run round it",
    ),
)  # fmt: skip

PARTLY_ROUND = ("half-disk", "half-ring", "hemisphere", "hemispherical-shell")  # they roll on their round side

DENSITY_DIMENSIONS = {
    "line": DIMENSIONS["linear density"],
    "surface": DIMENSIONS["surface density"],
    "volume": DIMENSIONS["density"],
}
