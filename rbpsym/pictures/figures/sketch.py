"""A sketch: where everything of a system stands in one pose, in plain numbers.

It says what is there and not how it is drawn. Lengths are in any unit (the drawing is scaled to
fit), angles in radians, counter-clockwise from +x. `label`s are formulas or short words.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any

from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen, replace
from rbpsym.pictures.figures.scene import Point

Caption = Node | str | None


class SketchPart(Frozen):
    """A part of a composite: its shape, origin and angle in the composite's frame."""

    kind: str
    sizes: Mapping[str, float]
    at: Point = (0.0, 0.0)
    angle: float = 0.0
    removed: bool = False


class SketchBody(Frozen):
    """A body: `kind` and `sizes` as in the statement, frame origin `at`, turned by `angle`.

    `rims` are radii of circles about the origin that are not its outline: drums, axles.
    """

    name: str
    kind: str
    sizes: Mapping[str, float]
    at: Point
    angle: float = 0.0
    center_of_mass: Point | None = None
    label: Caption = None
    parts: tuple[SketchPart, ...] = ()
    rims: tuple[float, ...] = ()

    @property
    def center(self) -> Point:
        """The centre of mass (the frame's origin if none is given)."""
        return self.center_of_mass or self.at


class SketchPoint(Frozen):
    """A point with a meaning: kind "pivot", "weld", "guide" (to the ground), "pin", "fixed"
    (an origin), "anchor" (the fixed end of a spring or string), "edge" (a corner on which a body lies)
    or "point"; `bodies` are those that it holds, `away` the direction in which its ground lies."""

    kind: str
    at: Point
    label: Caption = None
    bodies: tuple[str, ...] = ()
    away: float | None = None


class SketchLine(Frozen):
    """The line a x + b y = c; `solid` is the side (sign of a x + b y - c) that is hatched.

    None: the side where no body is. A line of kind "rail" has no solid side: points are led along it.
    Seen from `at`, where it is touched, it stops at `end` (None: nowhere).
    """

    a: float
    b: float
    c: float
    label: Caption = None
    solid: int | None = None
    kind: str = "solid"
    at: Point | None = None
    end: Point | None = None


class SketchCircle(Frozen):
    """A fixed circle that is touched: "convex" (solid inside), "concave" (solid outside), "bowl" (its lower
    half, solid outside) or "rail"."""

    at: Point
    radius: float
    kind: str = "convex"
    label: Caption = None


class SketchCord(Frozen):
    """What runs through points (arcs round pulleys come as many points): kind "string", "link" or "rail"."""

    points: tuple[Point, ...]
    label: Caption = None
    kind: str = "string"


class SketchArrow(Frozen):
    """What acts or moves at the start: kind "force", "blow", "velocity", "spin", "couple" or "driven".

    `direction` is a unit vector; of a turning kind its x is the sense (+1 counter-clockwise).
    """

    kind: str
    at: Point
    direction: Point
    label: Caption = None


class SketchLink(Frozen):
    """What joins two points: kind "spring", "damper" or "string"."""

    kind: str
    start: Point
    end: Point
    label: Caption = None


class SketchCoil(Frozen):
    """A torsion spring or rotary damper at a point."""

    at: Point
    label: Caption = None
    kind: str = "torsion_spring"


class AngleMark(Frozen):
    """An angle at a point from the direction `start` to `end` (the way in which it grows).

    A line marks the end where no edge of a body is there: of length `reach`, the arc being beyond it, or
    of length `ray`, across the arc.
    """

    at: Point
    start: float
    end: float
    label: Caption
    reach: float = 0.0
    ray: float = 0.0


class LengthMark(Frozen):
    """A length between two points, drawn beside them on the emptier side."""

    start: Point
    end: Point
    label: Caption


class RadiusMark(Frozen):
    """A radius, drawn as an arrow from the centre to the rim `toward` a direction (None: a free one)."""

    at: Point
    radius: float
    label: Caption
    toward: float | None = None


class SketchForce(Frozen):
    """A force on a body: its point and direction (its length on paper says nothing); `is_open` if no sense is told."""

    body: str
    label: Caption
    at: Point
    direction: Point
    is_open: bool = False


class SketchCouple(Frozen):
    """A couple on a body, drawn round a point; `sign` +1 is counter-clockwise; `is_open` if no sense is told."""

    body: str
    label: Caption
    at: Point
    sign: int = 1
    is_open: bool = False


class Sketch(Frozen):
    """A whole system in one pose."""

    bodies: tuple[SketchBody, ...]
    points: tuple[SketchPoint, ...] = ()
    lines: tuple[SketchLine, ...] = ()
    circles: tuple[SketchCircle, ...] = ()
    cords: tuple[SketchCord, ...] = ()
    arrows: tuple[SketchArrow, ...] = ()
    links: tuple[SketchLink, ...] = ()
    coils: tuple[SketchCoil, ...] = ()
    angles: tuple[AngleMark, ...] = ()
    lengths: tuple[LengthMark, ...] = ()
    radii: tuple[RadiusMark, ...] = ()
    forces: tuple[SketchForce, ...] = ()
    couples: tuple[SketchCouple, ...] = ()
    gravity: Point | None = (0.0, -1.0)
    gravity_label: Caption = None

    def body(self, name: str) -> SketchBody:
        """The body called `name` (KeyError if there is none)."""
        return {body.name: body for body in self.bodies}[name]


# --- a sketch with all its lengths times a factor; angles and directions stay


LENGTHS = frozenset({"at", "start", "end", "radius", "c", "center_of_mass", "sizes", "parts", "points", "rims"})


def scaled(sketch: Sketch, factor: float) -> Sketch:
    """The sketch, larger or smaller."""
    lists = {item.name: getattr(sketch, item.name) for item in fields(sketch)}
    parts = {name: value for name, value in lists.items() if isinstance(value, tuple) and value and is_dataclass(value[0])}
    return replace(sketch, **{name: times(value, factor) for name, value in parts.items()})


def scaled_part(part: Any, factor: float) -> Any:
    """A part with its lengths scaled; the ends of an angle are no lengths."""
    names = {"at", "reach", "ray"} if isinstance(part, AngleMark) else LENGTHS
    values = {item.name: getattr(part, item.name) for item in fields(part) if item.name in names}
    return replace(part, **{name: times(value, factor) for name, value in values.items()})


def times(value: Any, factor: float) -> Any:
    """A length, a point, sizes by name, a part or several of these, scaled."""
    if value is None:
        return None
    if isinstance(value, tuple):
        return tuple(times(item, factor) for item in value)
    if isinstance(value, Mapping):
        return {name: size * factor for name, size in value.items()}
    return scaled_part(value, factor) if is_dataclass(value) else value * factor
