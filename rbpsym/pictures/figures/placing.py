"""Where labels go: beside their target, on no line and on no other label."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.frozen import Frozen, replace
from rbpsym.pictures.figures import scene as s
from rbpsym.typeset.cutting import node_height, node_width

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
        (weight * abs(turn) + 1.2 * step, around(label, start + turn * math.pi / 8, step))
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
