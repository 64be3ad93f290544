"""A plot as a scene: axes with ticks, curves with their names beside them, and what happens on the way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import count, cycle
from typing import Any

import numpy as np

from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.frozen import Frozen, replace
from rbpsym.pictures.figures.scene import (
    STYLES,
    Circle,
    Item,
    Label,
    Point,
    Polyline,
    Scene,
    Strokes,
    grown,
    label_size,
    overlap,
    points_of,
)
from rbpsym.pictures.plots.axes import Axis, axis, lengths, places
from rbpsym.pictures.plots.scales import Scale

WIDE, HIGH = 3.4, 2.7  # cm between the axes' ends: three in a row
TICK = 0.09
LOOKS = ("curve 1", "curve 2", "curve 3", "curve 4", "curve 5", "curve 6")
SAME = 4e-6  # cm: curves that are no farther apart are one
JUMP = 0.015  # of the height: what is more is a jump
RING = 0.06
RINGS = ("joint", "dot")  # an open circle where a curve ends, a full one where it goes on
NEAR = 0.035  # cm


class PlotCurve(Frozen, eq=False):
    """Values at the places of a panel: what it is called, and its style."""

    name: t.Node | str
    values: np.ndarray
    style: str = ""


class PlotMark(Frozen):
    """A place at which something happens, and what; a dot is where it meets the height 0."""

    place: float
    name: t.Node | str = ""
    has_dot: bool = False


class Panel(Frozen, eq=False):
    """Curves over common places. Values are in units of the scales already.

    Where places and values are not numbers there is a gap: what is on both its sides is a jump.
    `omitted` curves had no room; heights in `reach` are shown too, so that panels have one scale. `kind` is the word for what
    all curves are.
    """

    across: t.Node
    places: np.ndarray
    curves: tuple[PlotCurve, ...]
    across_scale: Scale
    up_scale: Scale
    marks: tuple[PlotMark, ...] = ()
    omitted: int = 0
    reach: tuple[float, ...] = ()
    kind: str = ""


class DrawnCurve(Frozen, eq=False):
    """A curve in the picture: its points as rows, in cm; a gap between its pieces is not a number."""

    name: t.Node | str
    points: np.ndarray
    style: str

    @property
    def names(self) -> Sequence[Any]:
        """The names of a curve that has several; a word is the only one."""
        return self.name.items if isinstance(self.name, t.Chain) else (self.name,)

    @property
    def pieces(self) -> Iterator[np.ndarray]:
        """The points of each piece, about a third of a millimetre apart."""
        is_known = np.isfinite(self.points).all(axis=1)
        for piece in np.split(self.points, np.flatnonzero(np.diff(is_known)) + 1):
            if len(piece) > 1 and np.isfinite(piece).all():
                steps = np.diff(np.floor(lengths(piece) / NEAR), prepend=-1.0) > 0
                steps[-1] = True
                yield piece[steps]

    @property
    def jumps(self) -> list[tuple[Point, Point]]:
        """Where it ends and where it goes on elsewhere at the same place."""
        gaps = np.flatnonzero(np.isnan(self.points[:, 0]))
        ends = ((tuple(self.points[k - 1].tolist()), tuple(self.points[k + 1].tolist())) for k in gaps)
        return [(one, other) for one, other in ends if abs(one[1] - other[1]) > JUMP * HIGH]


def scene(panel: Panel, notation: Notation) -> Scene:
    """The panel as a drawing."""
    x, y = axes_of(panel, notation.decimal)
    curves = sorted(drawn(panel, x, y), key=lambda curve: curve.style != "curve sum")
    axes = (*frame(x, y), *(item for one in panel.marks for item in mark(one, x, y)))
    lines = [Polyline(tuple(map(tuple, piece.tolist())), curve.style) for curve in curves for piece in curve.pieces]
    rings = [circle for curve in curves for ends in curve.jumps for circle in map(Circle, ends, (RING, 0.0), RINGS)]
    outside = [*tick_labels(x, y, notation), *axis_labels(panel, notation)]
    outside += mark_labels(panel, x, outside, notation)
    names = named(together(curves, y), Scene((*axes, *rings), tuple(outside)), notation)
    return Scene((*axes, *lines, *rings, *names.items), (*outside, *names.labels))


def axes_of(panel: Panel, decimal: str = ".") -> tuple[Axis, Axis]:
    """Both axes; the vertical one holds the height 0."""
    heights = np.concatenate([[0.0, *panel.reach], *(curve.values for curve in panel.curves)])
    across = axis(panel.places, WIDE, sign=panel.across_scale.sign, decimal=decimal, tight=True)
    return across, axis(heights, HIGH, sign=panel.up_scale.sign, decimal=decimal)


def drawn(panel: Panel, x: Axis, y: Axis) -> list[DrawnCurve]:
    """The curves in the picture."""
    return [
        DrawnCurve(curve.name, np.stack([x.at(panel.places), y.at(curve.values)], axis=1), curve.style or look)
        for curve, look in zip(panel.curves, cycle(LOOKS), strict=False)
    ]


def has_jump(panel: Panel) -> bool:
    """Does a value jump somewhere?"""
    return any(curve.jumps for curve in drawn(panel, *axes_of(panel)))


def together(curves: Sequence[DrawnCurve], y: Axis) -> list[DrawnCurve]:
    """The curves, those that lie on each other as one with an equation for a name; one on the axis says so."""
    found: list[DrawnCurve] = []
    for curve in curves:
        like = next((k for k, one in enumerate(found) if are_same(one, curve)), None)
        if like is None:
            found.append(curve)
        else:
            one = found[like]
            style = one.style if one.style == "curve sum" else curve.style
            found[like] = DrawnCurve(t.equation(*one.names, *curve.names), one.points, style)
    return [replace(one, name=t.equation(*one.names, t.ZERO)) if is_nothing(one, y) else one for one in found]


def are_same(one: DrawnCurve, other: DrawnCurve) -> bool:
    """Do two curves with formulas for names lie on each other?"""
    has_words = isinstance(one.name, str) or isinstance(other.name, str)
    return not has_words and np.allclose(one.points, other.points, rtol=0.0, atol=SAME, equal_nan=True)


def is_nothing(curve: DrawnCurve, y: Axis) -> bool:
    """Does a curve with a formula for a name lie on the axis?"""
    return not isinstance(curve.name, str) and np.nanmax(np.abs(curve.points[:, 1] - y.at(0.0))) <= SAME


def frame(x: Axis, y: Axis) -> Iterator[Item]:
    """The axes with their ticks; the horizontal one also at the height 0."""
    yield Polyline(((0.0, HIGH), (0.0, 0.0), (WIDE, 0.0)), "axis")
    ticks = [((x.at(tick), 0.0), (x.at(tick), -TICK)) for tick in x.ticks]
    ticks += [((0.0, y.at(tick)), (-TICK, y.at(tick))) for tick in y.ticks]
    yield Strokes(tuple(ticks), "axis")
    if y.low < 0 < y.high:
        yield Polyline(((0.0, y.at(0.0)), (WIDE, y.at(0.0))), "dimension")


def mark(one: PlotMark, x: Axis, y: Axis) -> Iterator[Item]:
    """A dashed line at a place, with a dot where it meets the height 0."""
    yield Polyline(((x.at(one.place), 0.0), (x.at(one.place), HIGH)), "guide")
    if one.has_dot:
        yield Circle((x.at(one.place), y.at(0.0)), 0.0, "dot")


def tick_labels(x: Axis, y: Axis, notation: Notation) -> Iterator[Label]:
    """Numbers below and at the left; below as many as have room."""
    below = [fixed(text, (x.at(tick), -TICK - 0.32), "soft", notation) for tick, text in zip(x.ticks, x.texts, strict=True)]
    width = max((label.size[0] for label in below), default=0.0) + 0.06
    skip = max(1, math.ceil(width / (x.at(x.ticks[1]) - x.at(x.ticks[0])))) if len(x.ticks) > 1 else 1
    yield from below[next((k for k, tick in enumerate(x.ticks) if tick == 0), 0) % skip :: skip]
    beside = [fixed(text, (0.0, y.at(tick)), "soft", notation) for tick, text in zip(y.ticks, y.texts, strict=True)]
    high = max((label.size[1] for label in beside), default=0.0)
    skip = max(1, math.ceil(high / (y.at(y.ticks[1]) - y.at(y.ticks[0])))) if len(y.ticks) > 1 else 1
    for label in beside[next((k for k, tick in enumerate(y.ticks) if tick == 0), 0) % skip :: skip]:
        yield replace(label, place=(-TICK - 0.04 - label.size[0] / 2, label.center[1]))


def axis_labels(panel: Panel, notation: Notation) -> Iterator[Label]:
    """What the axes count: at the right end below, and above the vertical axis."""
    across = fixed(in_units(panel.across, panel.across_scale), (WIDE, 0.0), "ink", notation)
    yield replace(across, place=(WIDE + 0.15 + across.size[0] / 2, across.size[1] / 2 - 0.1))
    if panel.up_scale.node is not None:
        unit = panel.up_scale.node
        what = in_units(t.Word(panel.kind), panel.up_scale) if panel.kind and isinstance(unit, t.Word) else unit
        above = fixed(what, (0.0, HIGH), "ink", notation)
        yield replace(above, place=(max(0.0, above.size[0] / 2 - 0.5), HIGH + 0.25 + above.size[1] / 2))


def mark_labels(panel: Panel, x: Axis, taken: Sequence[Label], notation: Notation) -> list[Label]:
    """What happens at the marks, above their lines; one above the other where they are close together."""
    found: list[Label] = []
    for one in (one for one in panel.marks if one.name):
        name = notation.names.get(one.name, one.name) if isinstance(one.name, str) else one.name
        label = fixed(name, (0.0, 0.0), "soft", notation)
        across = min(max(x.at(one.place), label.size[0] / 2 - 0.2), WIDE + 0.9 - label.size[0] / 2)
        heights = (HIGH + 0.08 + label.size[1] / 2 + 0.1 * step for step in count())
        tries = (replace(label, place=(across, height)) for height in heights)
        boxes = [other.box for other in (*taken, *found)]
        found.append(next(one for one in tries if not any(overlap(grown(one.box, 0.02), box) for box in boxes)))
    return found


def in_units(node: t.Node, scale: Scale) -> t.Node:
    """A quantity over the unit in which it is counted; one in degrees says so at its ticks."""
    if scale.node is None:
        return node
    return t.Mul((node, t.Word(f"/ {scale.node.text}"))) if isinstance(scale.node, t.Word) else t.Div(node, scale.node)


def named(curves: Sequence[DrawnCurve], rest: Scene, notation: Notation) -> Scene:
    """A name beside each curve, in its colour; for those that have no room a line in a legend."""
    labels = [fixed(curve.name, (0.0, 0.0), STYLES[curve.style].stroke, notation) for curve in curves]
    pieces = [tuple(curve.pieces) for curve in curves]
    lines = [ends for item in rest.items for ends in (item.pieces if isinstance(item, Strokes) else [points_of(item)])]
    taken, within = [one.box for one in rest.labels], (0.04, 0.04, WIDE + 1.4, HIGH - 0.02)
    spots = places(pieces, [label.size for label in labels], taken, lines, within)
    beside = [replace(label, place=spot) for label, spot in zip(labels, spots, strict=True) if spot]
    left = [(curve, label) for curve, label, spot in zip(curves, labels, spots, strict=True) if spot is None]
    listed = list(legend(left, max([WIDE, *(label.box[2] for label in beside)])))
    return Scene(tuple(line for line, _ in listed), (*beside, *(label for _, label in listed)))


def legend(left: Sequence[tuple[DrawnCurve, Label]], start: float) -> Iterator[tuple[Item, Label]]:
    """A line and a name for each of some curves, from the highest end to the lowest."""
    order = sorted(left, key=lambda pair: -pair[0].points[np.isfinite(pair[0].points[:, 1])][-1, 1])
    step = max((label.size[1] for _, label in left), default=0.0) + 0.04
    top = max(HIGH / 2 + step * (len(order) - 1) / 2 + 0.2, 0.9 + step * (len(order) - 1))
    for row, (curve, label) in enumerate(order):
        height = top - step * row
        line = Polyline(((start + 0.2, height), (start + 0.75, height)), curve.style)
        yield line, replace(label, place=(start + 0.9 + label.size[0] / 2, height))


def fixed(content: t.Node | str, place: Point, color: str, notation: Notation) -> Label:
    """A label that stands where it is put, with its size."""
    label = Label(content, place, color=color, place=place)
    return replace(label, size=label_size(label, notation))
