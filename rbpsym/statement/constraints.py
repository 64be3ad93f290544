"""The constraints that a statement can name: a condition, and the unknown forces that keep it."""

from __future__ import annotations

from rbpsym.quantities import DIMENSIONS, FORCE, LENGTH, NUMBER
from rbpsym.statement.kinds import Field, Kind, registry

_COMPONENTS = (("{name}_x", FORCE), ("{name}_y", FORCE))

CONSTRAINTS: dict[str, Kind] = registry(
    Kind(
        "pivot",
        "a point of a body is held at a fixed place, free to turn there",
        (
            Field("point", "point", "the point that is held"),
            Field("at", "pair", "where it is held; absent: where the body's pose puts it", LENGTH, default=""),
        ),
        unknowns=_COMPONENTS,
    ),
    Kind(
        "pin",
        "a point of one body is joined to a point of another, free to turn; the force is on the second",
        (Field("points", "points", "the two points that coincide, of two bodies"),),
        aliases=("bearing",),
        unknowns=_COMPONENTS,
    ),
    Kind(
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
    Kind(
        "contact",
        "a point of a body touches a smooth fixed line; the force is normal to the line",
        (
            Field("point", "point", "the point that touches"),
            Field("line", "line", "the line, as an equation in x and y: “y = 0”"),
            Field(
                "side",
                "choice",
                "side of the line to which the force pushes: positive is where the left "
                "side of the equation is the greater one; auto: where the body is",
                default="auto",
                choices=("auto", "positive", "negative"),
            ),
        ),
        unknowns=(("{name}", FORCE),),
    ),
)
