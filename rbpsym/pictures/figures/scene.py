"""A drawing as data: lines, circles, arcs and labels, in centimetres, y upwards.

Printers (SVG, TikZ, Typst) know only these few items; springs and hatching are lines already.
The look of a line is the name of one of STYLES.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from itertools import pairwise

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen, replace
from rbpsym.pictures.figures import scene as s
from rbpsym.typeset.cutting import node_height, node_width

Point = tuple[float, float]
EM = 0.40  # the size of a label's letters, in cm


class DrawingStyle(Frozen):
    """Colour names are those of COLORS; `width` is in points; `dash` in cm or None."""

    stroke: str = "ink"
    width: float = 0.8
    fill: str = ""
    dash: float | None = None


FORCE_COLORS = ("accent", "force", "green", "purple", "orange", "teal")  # of both works of a force
STYLES: Mapping[str, DrawingStyle] = {
    "body": DrawingStyle("ink", 0.9, fill="body"),
    "rod edge": DrawingStyle("ink", 4.4),
    "rod": DrawingStyle("body", 2.8),
    "rim": DrawingStyle("ink", 0.7),
    "cord": DrawingStyle("ink", 0.7),
    "ground": DrawingStyle("ink", 0.9, fill="ground"),
    "rail": DrawingStyle("soft", 0.8),
    "hole": DrawingStyle("ink", 0.9, fill="paper"),
    "line": DrawingStyle("ink", 0.9),
    "hatch": DrawingStyle("soft", 0.5),
    "spring": DrawingStyle("ink", 0.8),
    "support": DrawingStyle("ink", 0.8, fill="ground"),
    "guide": DrawingStyle("soft", 0.6, dash=0.09),
    "dimension": DrawingStyle("soft", 0.5),
    "angle": DrawingStyle("accent", 0.8),
    "axis": DrawingStyle("soft", 0.7),
    "force": DrawingStyle("force", 1.3),
    "couple": DrawingStyle("force", 1.1),
    "velocity": DrawingStyle("motion", 1.2),
    "dot": DrawingStyle("ink", 0.6, fill="ink"),
    "particle": DrawingStyle("ink", 1.2, fill="ink"),
    "joint": DrawingStyle("ink", 0.9, fill="paper"),
    "curve 1": DrawingStyle("accent", 1.4),
    "curve 2": DrawingStyle("force", 1.4, dash=0.16),
    "curve 3": DrawingStyle("green", 1.4),
    "curve 4": DrawingStyle("purple", 1.4, dash=0.09),
    "curve 5": DrawingStyle("orange", 1.4),
    "curve 6": DrawingStyle("teal", 1.4, dash=0.22),
    "curve sum": DrawingStyle("ink", 2.0),
    **{f"along {k}": DrawingStyle(color, 1.4) for k, color in enumerate(FORCE_COLORS, 1)},
    **{f"about {k}": DrawingStyle(color, 1.4, dash=0.16) for k, color in enumerate(FORCE_COLORS, 1)},
    "code": DrawingStyle("ink", 0.01, fill="ink"),
    "quiet": DrawingStyle("paper", 0.01, fill="paper"),
    "curve thin": DrawingStyle("soft", 1.1, dash=0.09),
}

# name -> (light, dark)
COLORS: Mapping[str, tuple[str, str]] = {
    "ink": ("#1f2430", "#e6e6e6"),
    "soft": ("#6b7280", "#a0a7b4"),
    "body": ("#d9e4f1", "#2c3e55"),
    "ground": ("#e8e6e1", "#3a3a40"),
    "paper": ("#ffffff", "#16181d"),
    "accent": ("#1d5fa8", "#7fb5f0"),
    "force": ("#b3261e", "#ff8a80"),
    "motion": ("#2a7548", "#7fcf9f"),
    "green": ("#2a7548", "#7fcf9f"),
    "purple": ("#7a3e9d", "#cfa3ea"),
    "orange": ("#a85600", "#f0b070"),
    "teal": ("#007a7a", "#6fd0d0"),
}


class Polyline(Frozen):
    """A broken line through points; `heads` is "", "end" or "both"."""

    points: tuple[Point, ...]
    style: str = "line"
    closed: bool = False
    heads: str = ""


class Strokes(Frozen):
    """Many short lines of one style: hatching."""

    pieces: tuple[tuple[Point, Point], ...]
    style: str = "hatch"


class Circle(Frozen):
    """A circle."""

    center: Point
    radius: float
    style: str = "body"


class Arc(Frozen):
    """An arc of a circle from the angle `start` to `end` (radians, either way round)."""

    center: Point
    radius: float
    start: float
    end: float
    style: str = "angle"
    heads: str = ""

    def at(self, share: float) -> Point:
        """The point at a share (0 to 1) of the arc."""
        angle = self.start + share * (self.end - self.start)
        return polar(self.center, self.radius, angle)


class Label(Frozen):
    """A formula or word beside `target`; `toward` is the wanted direction (radians) or None.

    `place` (its centre) is found by `placing.placed` if it is not given; `gap` is the least distance in cm; `both`: the other
    side of a line is nearly as good.
    """

    content: Node | str
    target: Point
    toward: float | None = None
    gap: float = 0.1
    color: str = "ink"
    place: Point | None = None
    size: tuple[float, float] = (0.0, 0.0)
    both: bool = False

    @property
    def center(self) -> Point:
        """Its place once that is found."""
        return self.place or self.target

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Left, bottom, right, top."""
        (x, y), (w, h) = self.center, self.size
        return x - w / 2, y - h / 2, x + w / 2, y + h / 2


Item = Polyline | Strokes | Circle | Arc


class Scene(Frozen):
    """Items in drawing order, with labels on top."""

    items: tuple[Item, ...] = ()
    labels: tuple[Label, ...] = ()

    def __add__(self, other: Scene) -> Scene:
        return Scene(self.items + other.items, self.labels + other.labels)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, bottom, right, top of all items and placed labels, with a small margin."""
        boxes = [box_of(points_of(item)) for item in self.items]
        boxes += [label.box for label in self.labels if label.place]
        left, bottom, right, top = zip(*boxes, strict=True)
        return min(left) - 0.08, min(bottom) - 0.08, max(right) + 0.08, max(top) + 0.08


def polar(center: Point, radius: float, angle: float) -> Point:
    """The point at a distance and direction from another."""
    return center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)


def direction(start: Point, end: Point) -> float:
    """The angle of the way from one point to another."""
    return math.atan2(end[1] - start[1], end[0] - start[0])


def points_of(item: Item) -> tuple[Point, ...]:
    """Points along an item, close enough to stand for it."""
    return TRACE[type(item)](item)


DOT = 0.07  # the radius of a point that has no size
TRACE: Mapping[type, Callable[..., tuple[Point, ...]]] = {
    Polyline: lambda item: item.points + item.points[:1] if item.closed else item.points,
    Strokes: lambda item: tuple(point for piece in item.pieces for point in piece),
    Circle: lambda item: tuple(polar(item.center, item.radius, n * math.pi / 8) for n in range(17)),
    Arc: lambda item: tuple(item.at(n / 8) for n in range(9)),
}


def box_of(points: tuple[Point, ...]) -> tuple[float, float, float, float]:
    """Left, bottom, right, top of points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def heads_of(item: Polyline | Arc) -> Iterator[tuple[Point, float]]:
    """Tip and direction of each arrow head of an item."""
    if not item.heads:
        return
    points = points_of(item)
    yield points[-1], head_direction(item, points[-1], points[-2])
    if item.heads == "both":
        yield points[0], head_direction(item, points[0], points[1])


def head_direction(item: Polyline | Arc, tip: Point, before: Point) -> float:
    """Where a head points; on an arc it follows the curve over the length of the head."""
    if isinstance(item, Polyline):
        return direction(before, tip)
    turn = math.copysign(1, item.end - item.start)
    back = turn * HEAD / item.radius
    last = item.end if tip == item.at(1) else item.start
    return direction(polar(item.center, item.radius, last - back), tip)


HEAD = 0.2


def head_shape(tip: Point, angle: float, width: float) -> tuple[Point, ...]:
    """The triangle of an arrow head, a little notched, for a line of that width in points."""
    size = HEAD * (0.55 + 0.35 * width)
    left = polar(tip, size, angle + math.pi - 0.33)
    right = polar(tip, size, angle + math.pi + 0.33)
    return tip, left, polar(tip, 0.75 * size, angle + math.pi), right


# --- where labels go: beside their target, on no line and on no other label


Box = tuple[float, float, float, float]
TURNS = (0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8)
STEPS = (0.0, 0.12, 0.28, 0.5, 0.8, 1.15, 1.6)
CLEAR = 0.03


class Stroke(Frozen):
    """A piece of a line that labels keep clear of."""

    start: s.Point
    end: s.Point
    box: Box


@lru_cache(maxsize=256)
def placed(scene: s.Scene, notation: Notation = DEFAULT) -> s.Scene:
    """The scene with a place for each label; the most constrained first. One that has a place keeps it."""
    strokes = tuple(strokes_of(scene))
    done: list[s.Label] = []
    for label in scene.labels:
        sized = replace(label, size=label_size(label, notation))
        done.append(sized if label.place else replace(sized, place=best_place(sized, strokes, done)))
    return replace(scene, labels=tuple(done))


def label_size(label: s.Label, notation: Notation) -> tuple[float, float]:
    """Width and height of a label, in cm."""
    if isinstance(label.content, str):
        return s.EM * (0.5 * len(label.content) + 0.25), s.EM
    wide, high = node_width(label.content, notation), node_height(label.content, notation)
    return s.EM * (wide + 0.26), s.EM * high


def strokes_of(scene: s.Scene) -> Iterator[Stroke]:
    """All lines of a scene as straight pieces."""
    for item in scene.items:
        for start, end in pieces_of(item):
            yield Stroke(start, end, s.box_of((start, end)))


def pieces_of(item: s.Item) -> tuple[tuple[s.Point, s.Point], ...]:
    """The straight pieces of an item; a point counts with the size of its dot."""
    if isinstance(item, s.Strokes):
        return item.pieces
    if isinstance(item, s.Circle):
        item = replace(item, radius=max(item.radius, s.DOT))
    return tuple(pairwise(s.points_of(item)))


def best_place(label: s.Label, strokes: tuple[Stroke, ...], done: list[s.Label]) -> s.Point:
    """The first free place in the order of liking, else the least bad one."""
    best, least = label.target, math.inf
    for liking, place in candidates(label):
        if liking >= least:
            break
        cost = liking + collision(replace(label, place=place).box, strokes, done)
        if cost < least:
            best, least = place, cost
    return best


def candidates(label: s.Label) -> Iterator[tuple[float, s.Point]]:
    """Places round the target, the most liked first, each with its dislike."""
    start = math.pi / 4 if label.toward is None else label.toward
    weight = 0.02 if label.toward is None else 0.12
    found = [
        (weight * abs(turn) + 1.2 * step + 0.15 * side, around(label, start + turn * math.pi / 8 + side * math.pi, step))
        for side in range(1 + label.both)
        for step in STEPS
        for turn in TURNS
    ]
    return iter(sorted(found))


def around(label: s.Label, angle: float, step: float) -> s.Point:
    """The centre of a label whose box begins `gap + step` from the target in a direction."""
    dx, dy = math.cos(angle), math.sin(angle)
    (x, y), (w, h) = label.target, label.size
    reach = min(w / 2 / abs(dx) if abs(dx) > 1e-9 else 9e9, h / 2 / abs(dy) if abs(dy) > 1e-9 else 9e9)
    distance = label.gap + step + 0.5 * (reach + abs(dx) * w / 2 + abs(dy) * h / 2)
    return x + distance * dx, y + distance * dy


def collision(box: Box, strokes: tuple[Stroke, ...], done: list[s.Label]) -> float:
    """How bad a place is: labels on labels are worst, lines through labels bad."""
    wide = grown(box, CLEAR)
    labels = sum(100.0 for label in done if overlap(wide, label.box))
    return labels + sum(5.0 for stroke in strokes if crosses(stroke, wide))


def grown(box: Box, by: float) -> Box:
    """The box with a margin."""
    return box[0] - by, box[1] - by, box[2] + by, box[3] + by


def overlap(a: Box, b: Box) -> bool:
    """Do two boxes share a point inside?"""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def crosses(stroke: Stroke, box: Box) -> bool:
    """Does a straight piece run through a box? (Each side cuts away a part of it.)"""
    if not overlap(grown(stroke.box, 1e-9), box):
        return False
    (x, y), (u, v) = stroke.start, stroke.end
    low, high = 0.0, 1.0
    for step, near, far in ((u - x, box[0] - x, box[2] - x), (v - y, box[1] - y, box[3] - y)):
        if abs(step) < 1e-12:
            continue
        one, two = sorted((near / step, far / step))
        low, high = max(low, one), min(high, two)
    return low < high
