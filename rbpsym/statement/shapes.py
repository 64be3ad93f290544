"""The shapes that a body can have, each as data: how its mass is spread, never its moment.

The frame of a shape has its origin at the point that lies at (0, 0) in `points`. An element's
ranges stand from the outermost variable to the innermost. Text in `element`, `size` and
`points` is in the shape's own sizes.
"""

from __future__ import annotations

from rbpsym.quantities import DIMENSIONS, LENGTH, NUMBER
from rbpsym.statement.kinds import ElementText, Field, ShapeKind, registry


def _size(name: str, meaning: str, sign: str = "positive", default: object = None) -> Field:
    return Field(name, "expression", meaning, LENGTH, default=default, sign=sign)


_RADIUS = _size("radius", "radius")
_FULL_TURN, _HALF_TURN = ("phi", "0", "2*pi"), ("phi", "0", "pi")
_CENTER = (("center", "0", "0"),)
_HALF_POINTS = (*_CENTER, ("left", "-radius", "0"), ("right", "radius", "0"), ("top", "0", "radius"))
_CARTESIAN = (("x", "x"), ("y", "y"))
_POLAR = (("x", "r*cos(phi)"), ("y", "r*sin(phi)"), ("r", "r"), ("phi", "phi"))
_CIRCLE = (("x", "radius*cos(phi)"), ("y", "radius*sin(phi)"), ("phi", "phi"))


def _polar(inner: str, outer: str, turn: tuple[str, str, str]) -> ElementText:
    return ElementText((("r", inner, outer), turn), "r*cos(phi)", "r*sin(phi)", "r")


_OPENING = Field("opening", "expression", "angle between its two ends, seen from the centre", NUMBER, sign="positive")
_OPEN = ("phi", "-opening/2", "opening/2")
_ARC_POINTS = (
    *_CENTER,
    ("middle", "radius", "0"),
    ("upper", "radius*cos(opening/2)", "radius*sin(opening/2)"),
    ("lower", "radius*cos(opening/2)", "-radius*sin(opening/2)"),
)


def _arc(turn: tuple[str, str, str]) -> ElementText:
    return ElementText((turn,), "radius*cos(phi)", "radius*sin(phi)", "radius", "line")


SHAPES: dict[str, ShapeKind] = registry(
    ShapeKind(
        "particle",
        "a point mass",
        element=ElementText((), "0", "0", kind="point"),
        size="1",
        points=_CENTER,
        has_angle=False,
    ),
    ShapeKind(
        "rod",
        "a thin straight rod along the axis of the body",
        (_size("length", "length"),),
        element=ElementText((("s", "0", "length"),), "s - length/2", "0", kind="line"),
        size="length",
        points=(("center", "0", "0"), ("start", "-length/2", "0"), ("end", "length/2", "0")),
        density=(("s", "s"),),
    ),
    ShapeKind(
        "ring",
        "a thin circular ring",
        (_RADIUS,),
        aliases=("hoop",),
        element=_arc(_FULL_TURN),
        size="2*pi*radius",
        points=_CENTER,
        density=_CIRCLE,
    ),
    ShapeKind(
        "disk",
        "a circular disk",
        (_RADIUS,),
        aliases=("cylinder",),
        element=_polar("0", "radius", _FULL_TURN),
        size="pi*radius**2",
        points=_CENTER,
        density=_POLAR,
    ),
    ShapeKind(
        "annulus",
        "a disk with a concentric round hole",
        (_size("inner", "inner radius"), _size("outer", "outer radius")),
        element=_polar("inner", "outer", _FULL_TURN),
        size="pi*(outer**2 - inner**2)",
        points=_CENTER,
        density=_POLAR,
    ),
    ShapeKind(
        "ball",
        "a solid ball",
        (_RADIUS,),
        aliases=("sphere",),
        element=ElementText(
            (("z", "-radius", "radius"), ("r", "0", "sqrt(radius**2 - z**2)"), _FULL_TURN),
            "r*cos(phi)",
            "r*sin(phi)",
            "r",
            "volume",
        ),
        size="4*pi*radius**3/3",
        points=_CENTER,
    ),
    ShapeKind(
        "shell",
        "a thin spherical shell",
        (_RADIUS,),
        element=ElementText(
            (("z", "-radius", "radius"), _FULL_TURN),
            "sqrt(radius**2 - z**2)*cos(phi)",
            "sqrt(radius**2 - z**2)*sin(phi)",
            "radius",
        ),
        size="4*pi*radius**2",
        points=_CENTER,
    ),
    ShapeKind(
        "rectangle",
        "a rectangular plate, its width along the axis of the body",
        (_size("width", "side along the axis"), _size("height", "side across the axis")),
        element=ElementText((("x", "-width/2", "width/2"), ("y", "-height/2", "height/2")), "x", "y"),
        size="width*height",
        points=(
            ("center", "0", "0"),
            ("left", "-width/2", "0"),
            ("right", "width/2", "0"),
            ("bottom", "0", "-height/2"),
            ("top", "0", "height/2"),
            ("bottom_left", "-width/2", "-height/2"),
            ("bottom_right", "width/2", "-height/2"),
            ("top_left", "-width/2", "height/2"),
            ("top_right", "width/2", "height/2"),
        ),
        density=_CARTESIAN,
    ),
    ShapeKind(
        "triangle",
        "a triangular plate, its base along the axis of the body",
        (
            _size("base", "base"),
            _size("height", "height over the base"),
            _size("offset", "how far the top stands to the right of the middle of the base", sign="", default="0"),
        ),
        element=ElementText(
            (
                ("y", "0", "height"),
                ("x", "-base/2 + (offset + base/2)*y/height", "base/2 + (offset - base/2)*y/height"),
            ),
            "x",
            "y",
        ),
        size="base*height/2",
        points=(("middle", "0", "0"), ("left", "-base/2", "0"), ("right", "base/2", "0"), ("top", "offset", "height")),
        density=_CARTESIAN,
    ),
    ShapeKind(
        "half-disk",
        "half a disk, its straight edge along the axis of the body",
        (_RADIUS,),
        element=_polar("0", "radius", _HALF_TURN),
        size="pi*radius**2/2",
        points=_HALF_POINTS,
        density=_POLAR,
    ),
    ShapeKind(
        "half-ring",
        "a thin semicircular wire, its ends on the axis of the body",
        (_RADIUS,),
        element=_arc(_HALF_TURN),
        size="pi*radius",
        points=_HALF_POINTS,
        density=_CIRCLE,
    ),
    ShapeKind(
        "sector",
        "a sector of a circular disk, the axis of the body halving its angle",
        (_RADIUS, _OPENING),
        element=_polar("0", "radius", _OPEN),
        size="opening*radius**2/2",
        points=_ARC_POINTS,
        density=_POLAR,
    ),
    ShapeKind(
        "arc",
        "a thin wire along an arc of a circle, the axis of the body halving its angle",
        (_RADIUS, _OPENING),
        element=_arc(_OPEN),
        size="opening*radius",
        points=_ARC_POINTS,
        density=_CIRCLE,
    ),
    ShapeKind(
        "hemisphere",
        "half a solid ball, its flat side along the axis of the body",
        (_RADIUS,),
        aliases=("half-ball",),
        element=ElementText(
            (("y", "0", "radius"), ("r", "0", "sqrt(radius**2 - y**2)"), _FULL_TURN), "r*cos(phi)", "y", "r", "volume"
        ),
        size="2*pi*radius**3/3",
        points=_HALF_POINTS,
    ),
    ShapeKind(
        "hemispherical-shell",
        "half a thin spherical shell, its rim along the axis of the body",
        (_RADIUS,),
        aliases=("half-shell",),
        element=ElementText((("y", "0", "radius"), _FULL_TURN), "sqrt(radius**2 - y**2)*cos(phi)", "y", "radius"),
        size="2*pi*radius**2",
        points=_HALF_POINTS,
    ),
    ShapeKind(
        "ellipse",
        "an elliptic plate",
        (_size("half_width", "semi-axis along the axis"), _size("half_height", "semi-axis across the axis")),
        element=ElementText(
            (("r", "0", "1"), _FULL_TURN), "half_width*r*cos(phi)", "half_height*r*sin(phi)", "half_width*half_height*r"
        ),
        size="pi*half_width*half_height",
        points=(
            *_CENTER,
            ("left", "-half_width", "0"),
            ("right", "half_width", "0"),
            ("bottom", "0", "-half_height"),
            ("top", "0", "half_height"),
        ),
    ),
    ShapeKind(
        "polygon",
        "a plate with straight edges, made of the triangles that its edges form with the origin of its frame",
        (Field("vertices", "vertices", "its corners in its frame, three or more, counter-clockwise", LENGTH),),
        element=ElementText(
            (("u", "0", "1"), ("v", "0", "1")),
            "u*(x_p + v*(x_q - x_p))",
            "u*(y_p + v*(y_q - y_p))",
            "u*(x_p*y_q - x_q*y_p)",
        ),
        size="(x_p*y_q - x_q*y_p)/2",
        points=(("origin", "0", "0"),),
    ),
    ShapeKind(
        "composite",
        "parts joined to one rigid body, some of them cut out",
        (Field("parts", "parts", "its parts: shapes with sizes, at, angle, removed, and a mass each or none"),),
        points=(("origin", "0", "0"),),
    ),
    ShapeKind(
        "given",
        "a body whose moment of inertia about its centre of mass, its `center`, is given",
        (
            Field(
                "moment",
                "expression",
                "moment of inertia about the centre of mass",
                DIMENSIONS["moment of inertia"],
                sign="positive",
            ),
        ),
        points=_CENTER,
    ),
)

PARTLY_ROUND = ("half-disk", "half-ring", "hemisphere", "hemispherical-shell")  # they roll on their round side

DENSITY_DIMENSIONS = {
    "line": DIMENSIONS["linear density"],
    "surface": DIMENSIONS["surface density"],
    "volume": DIMENSIONS["density"],
}
