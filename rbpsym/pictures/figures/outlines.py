"""The outline of each kind of shape in its own frame, as the statement's kinds define it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from rbpsym.pictures.figures.scene import Circle, Item, Point, Polyline, polar
from rbpsym.pictures.figures.sketch import SketchBody, SketchPart

Sizes = Mapping[str, float]
Outline = tuple[Item, ...]
Length = float | tuple[float, str]  # a number, or a share of a size
Piece = tuple[Any, ...]  # a look, and the parts of its path: a kind and lengths

# by shape: what is drawn, the same in figures and in the explorer
DISK, RING = (("body", ("circle", (1, "radius"))),), (("band", ("circle", (1, "radius"))),)
HALF = ("arc", (1, "radius"), 0, math.pi)
OPENED = ("arc", (1, "radius"), (-0.5, "opening"), (0.5, "opening"))
CORNERS = ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
OUTLINES: Mapping[str, tuple[Piece, ...]] = {
    "particle": (("dot", ("to", 0, 0)),),
    "rod": (("band", ("to", (-0.5, "length"), 0), ("to", (0.5, "length"), 0)),),
    "ring": RING,
    "shell": RING,
    "disk": DISK,
    "ball": DISK,
    "annulus": (("body", ("circle", (1, "outer"))), ("hole", ("circle", (1, "inner")))),
    "rectangle": (("body", *(("to", (x, "width"), (y, "height")) for x, y in CORNERS)),),
    "triangle": (("body", ("to", (-0.5, "base"), 0), ("to", (0.5, "base"), 0), ("to", (1, "offset"), (1, "height"))),),
    "half-disk": (("body", HALF),),
    "hemisphere": (("body", HALF),),
    "half-ring": (("band", HALF),),
    "hemispherical-shell": (("band", HALF),),
    "sector": (("body", ("to", 0, 0), OPENED),),
    "arc": (("band", OPENED),),
    "ellipse": (("body", ("ellipse", (1, "half_width"), (1, "half_height"))),),
    "polygon": (("body", ("corners",)),),
    "given": (("blob", ("to", 0, 0)),),
}
LOOKS = {"body": ("body",), "hole": ("hole",), "band": ("rod edge", "rod"), "dot": ("particle",)}  # drawn over each other


def outline(kind: str, sizes: Sizes) -> Outline:
    """The items of a shape in its own frame."""
    if kind in OWN or kind not in OUTLINES:
        return (Polyline(OWN.get(kind, potato)(sizes), "body", closed=True),)
    return tuple(
        Circle((0, 0), measured(parts[0][1], sizes), style)
        if look == "dot" or parts[0][0] == "circle"
        else Polyline(tuple(point for part in parts for point in along(part, sizes)), style, closed=look in ("body", "hole"))
        for look, *parts in OUTLINES[kind]
        for style in LOOKS[look]
    )


def measured(length: Length, sizes: Sizes) -> float:
    """The number of a length."""
    return length[0] * sizes.get(length[1], 0.0) if isinstance(length, tuple) else length


def along(part: Piece, sizes: Sizes) -> Iterator[Point]:
    """The points of a part of a path."""
    kind, lengths = part[0], [measured(length, sizes) for length in part[1:]]
    if kind == "to":
        yield lengths[0], lengths[1]
    elif kind == "arc":
        radius, start, end = lengths
        yield from (polar((0, 0), radius, start + (end - start) * n / 32) for n in range(33))
    elif kind == "ellipse":
        yield from ((lengths[0] * math.cos(n * math.pi / 32), lengths[1] * math.sin(n * math.pi / 32)) for n in range(64))
    else:
        yield from ((x, sizes[f"y_{name[2:]}"]) for name, x in sizes.items() if name.startswith("x_"))


def box(sizes: Sizes) -> tuple[Point, ...]:
    """A box about the named points of a body of no particular shape, and a little above its centre of mass."""
    left, right, bottom = sizes["left"], sizes["right"], sizes["bottom"]
    top = max(sizes["top"], 0.35 * (sizes["top"] - bottom))
    return (left, bottom), (right, bottom), (right, top), (left, top)


def potato(sizes: Sizes) -> tuple[Point, ...]:
    """A body of no particular shape, its centre of mass in the middle."""
    size = sizes.get("size", 1.0)
    turns = [n * math.pi / 24 for n in range(48)]
    radii = [size * (0.5 + 0.07 * math.cos(2 * t + 0.6) + 0.04 * math.sin(3 * t)) for t in turns]
    return tuple((r * math.cos(t), r * math.sin(t)) for r, t in zip(radii, turns, strict=True))


OWN: Mapping[str, Callable[[Sizes], tuple[Point, ...]]] = {"box": box, "given": potato}  # in figures alone


def body_outline(body: SketchBody) -> Outline:
    """The items of a body where it stands."""
    parts = body.parts or (SketchPart(body.kind, body.sizes),)
    joined = sorted(parts, key=lambda part: part.removed)
    drawn = tuple(
        moved(moved(styled(item, part), part.at, part.angle), body.at, body.angle)
        for part in joined
        for item in outline(part.kind, part.sizes)
    )
    return (*joined_dots(body), *drawn, *(Circle(body.at, rim, "rim") for rim in body.rims))


def joined_dots(body: SketchBody) -> Outline:
    """Light rods from the origin of a body to those of its parts that are mere points: what holds them together."""
    ends = [part.at for part in body.parts if part.kind == "particle" and math.hypot(*part.at) > 0]
    return tuple(Polyline(tuple(turned(end, body.at, body.angle) for end in ((0.0, 0.0), at)), "line") for at in ends)


def styled(item: Item, part: SketchPart) -> Item:
    """A part that is cut out shows the paper."""
    return replace(item, style="hole") if part.removed else item


def moved(item: Item, at: Point, angle: float) -> Item:
    """The item turned about the origin and shifted."""
    if isinstance(item, Polyline):
        return replace(item, points=tuple(turned(point, at, angle) for point in item.points))
    assert isinstance(item, Circle), item
    return replace(item, center=turned(item.center, at, angle))


def turned(point: Point, at: Point, angle: float) -> Point:
    """A point turned about the origin and shifted."""
    (x, y), cos, sin = point, math.cos(angle), math.sin(angle)
    return at[0] + x * cos - y * sin, at[1] + x * sin + y * cos
