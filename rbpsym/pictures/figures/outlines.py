"""The outline of each kind of shape in its own frame, as the statement's kinds define it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace

from rbpsym.pictures.figures.scene import Circle, Item, Line, Point
from rbpsym.pictures.figures.sketch import SketchBody, SketchPart

Sizes = Mapping[str, float]
Outline = tuple[Item, ...]


def polygon(points: tuple[Point, ...]) -> Outline:
    """A closed line."""
    return (Line(points, "body", closed=True),)


def disk(sizes: Sizes) -> Outline:
    """A filled circle with the mark of its centre."""
    return (Circle((0, 0), sizes["radius"]),)


def ring(sizes: Sizes) -> Outline:
    """A circle drawn as a thin band."""
    return tuple(Circle((0, 0), sizes["radius"], style) for style in BAND)


def annulus(sizes: Sizes) -> Outline:
    """A disk with a hole."""
    return Circle((0, 0), sizes["outer"]), Circle((0, 0), sizes["inner"], "hole")


def rod(sizes: Sizes) -> Outline:
    """A straight thin band."""
    half = sizes["length"] / 2
    return band(((-half, 0), (half, 0)))


BAND = ("rod edge", "rod")


def band(points: tuple[Point, ...]) -> Outline:
    """A thin body along a line: the inner line is drawn over a wider one."""
    return tuple(Line(points, style) for style in BAND)


def rectangle(sizes: Sizes) -> Outline:
    """Four corners."""
    x, y = sizes["width"] / 2, sizes["height"] / 2
    return polygon(((-x, -y), (x, -y), (x, y), (-x, y)))


def triangle(sizes: Sizes) -> Outline:
    """The base along the axis and the top above it."""
    half, top = sizes["base"] / 2, (sizes.get("offset", 0.0), sizes["height"])
    return polygon(((-half, 0), (half, 0), top))


def half_circle(radius: float) -> tuple[Point, ...]:
    """Points of the upper half of a circle."""
    turns = [n * math.pi / 32 for n in range(33)]
    return tuple((radius * math.cos(turn), radius * math.sin(turn)) for turn in turns)


def arc(radius: float, opening: float) -> tuple[Point, ...]:
    """Points of an arc that the axis halves."""
    turns = [opening * (n / 32 - 0.5) for n in range(33)]
    return tuple((radius * math.cos(turn), radius * math.sin(turn)) for turn in turns)


def ellipse(x: float, y: float) -> tuple[Point, ...]:
    """Points of an ellipse with these semi-axes."""
    return tuple((x * math.cos(n * math.pi / 32), y * math.sin(n * math.pi / 32)) for n in range(64))


def corners(sizes: Sizes) -> tuple[Point, ...]:
    """The corners (x_1, y_1), (x_2, y_2) ..."""
    return tuple((x, sizes[f"y_{name[2:]}"]) for name, x in sizes.items() if name.startswith("x_"))


OUTLINES: Mapping[str, Callable[[Sizes], Outline]] = {
    "particle": lambda sizes: (Circle((0, 0), 0.0, "particle"),),
    "rod": rod,
    "ring": ring,
    "shell": ring,
    "disk": disk,
    "ball": disk,
    "annulus": annulus,
    "rectangle": rectangle,
    "triangle": triangle,
    "half-disk": lambda sizes: polygon(half_circle(sizes["radius"])),
    "half-ring": lambda sizes: band(half_circle(sizes["radius"])),
    "sector": lambda sizes: polygon(((0.0, 0.0), *arc(sizes["radius"], sizes["opening"]))),
    "arc": lambda sizes: band(arc(sizes["radius"], sizes["opening"])),
    "hemisphere": lambda sizes: polygon(half_circle(sizes["radius"])),
    "hemispherical-shell": lambda sizes: band(half_circle(sizes["radius"])),
    "ellipse": lambda sizes: polygon(ellipse(sizes["half_width"], sizes["half_height"])),
    "polygon": lambda sizes: polygon(corners(sizes)),
    "box": lambda sizes: polygon(box(sizes)),
    "given": lambda sizes: polygon(potato(sizes.get("size", 1.0))),
}


def box(sizes: Sizes) -> tuple[Point, ...]:
    """A box about the named points of a body of no particular shape, and a little above its centre of mass."""
    left, right, bottom = sizes["left"], sizes["right"], sizes["bottom"]
    top = max(sizes["top"], 0.35 * (sizes["top"] - bottom))
    return (left, bottom), (right, bottom), (right, top), (left, top)


def potato(size: float) -> tuple[Point, ...]:
    """A body of no particular shape, its centre of mass in the middle."""
    turns = [n * math.pi / 24 for n in range(48)]
    radii = [size * (0.5 + 0.07 * math.cos(2 * t + 0.6) + 0.04 * math.sin(3 * t)) for t in turns]
    return tuple((r * math.cos(t), r * math.sin(t)) for r, t in zip(radii, turns, strict=True))


def body_outline(body: SketchBody) -> Outline:
    """The items of a body where it stands."""
    parts = body.parts or (SketchPart(body.kind, body.sizes),)
    joined = sorted(parts, key=lambda part: part.removed)
    drawn = tuple(
        moved(moved(styled(item, part), part.at, part.angle), body.at, body.angle)
        for part in joined
        for item in OUTLINES.get(part.kind, OUTLINES["given"])(part.sizes)
    )
    return (*joined_dots(body), *drawn, *(Circle(body.at, rim, "rim") for rim in body.rims))


def joined_dots(body: SketchBody) -> Outline:
    """Light rods from the origin of a body to those of its parts that are mere points: what holds them together."""
    ends = [part.at for part in body.parts if part.kind == "particle" and math.hypot(*part.at) > 0]
    return tuple(Line(tuple(turned(end, body.at, body.angle) for end in ((0.0, 0.0), at)), "line") for at in ends)


def styled(item: Item, part: SketchPart) -> Item:
    """A part that is cut out shows the paper."""
    return replace(item, style="hole") if part.removed else item


def moved(item: Item, at: Point, angle: float) -> Item:
    """The item turned about the origin and shifted."""
    if isinstance(item, Line):
        return replace(item, points=tuple(turned(point, at, angle) for point in item.points))
    return replace(item, center=turned(item.center, at, angle))


def turned(point: Point, at: Point, angle: float) -> Point:
    """A point turned about the origin and shifted."""
    (x, y), cos, sin = point, math.cos(angle), math.sin(angle)
    return at[0] + x * cos - y * sin, at[1] + x * sin + y * cos
