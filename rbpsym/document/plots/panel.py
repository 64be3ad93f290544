"""A plot as a scene: axes with ticks, curves with their names beside them, and what happens on the way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import cycle

import numpy as np

from rbpsym.document.figures.placing import label_size, placed
from rbpsym.document.figures.scene import EM, STYLES, Circle, Item, Label, Line, Point, Scene, Strokes, points_of
from rbpsym.document.plots.axes import Axis, axis
from rbpsym.document.plots.naming import lengths, places
from rbpsym.document.plots.scales import Scale
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation

WIDE, HIGH = 4.3, 3.4  # cm between the axes' ends
TICK = 0.09
LOOKS = ("curve 1", "curve 2", "curve 3", "curve 4", "curve 5", "curve 6")
SAME = 4e-6  # cm: curves that are no farther apart are one
JUMP = 0.015  # of the height: what is more is a jump
RING = 0.06
RINGS = ("joint", "dot")  # an open circle where a curve ends, a full one where it goes on
UP = math.pi / 2
NEAR = 0.035  # cm


@dataclass(frozen=True, eq=False)
class Curve:
    """Values at the places of a panel: what it is called, and its style."""

    name: t.Node | str
    values: np.ndarray
    style: str = ""


@dataclass(frozen=True)
class Mark:
    """A place at which something happens, and what; a dot is where it meets the height 0."""

    place: float
    name: t.Node | str = ""
    has_dot: bool = False


@dataclass(frozen=True, eq=False)
class Panel:
    """Curves over common places. Values are in units of the scales already.

    Where places and values are not numbers there is a gap: what is on both its sides is a jump.
    `omitted` curves had no room.
    """

    across: t.Node
    places: np.ndarray
    curves: tuple[Curve, ...]
    across_scale: Scale
    up_scale: Scale
    marks: tuple[Mark, ...] = ()
    omitted: int = 0


@dataclass(frozen=True, eq=False)
class Drawn:
    """A curve in the picture: its points as rows, in cm; a gap between its pieces is not a number."""

    name: t.Node | str
    points: np.ndarray
    style: str

    @property
    def names(self) -> Sequence[t.Node]:
        """The names of a curve that has several."""
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
    lines = [Line(tuple(map(tuple, piece.tolist())), curve.style) for curve in curves for piece in curve.pieces]
    rings = [circle for curve in curves for ends in curve.jumps for circle in map(Circle, ends, (RING, 0.0), RINGS)]
    axes = (*frame(x, y), *(item for one in panel.marks for item in mark(one, x, y)), *rings)
    labels = (*tick_labels(x, y), *axis_labels(panel, notation), *mark_labels(panel, x, notation))
    outside = placed(Scene(axes, labels), notation)
    names = named(together(curves, y), outside, notation)
    return Scene((*axes[: len(axes) - len(rings)], *lines, *rings, *names.items), (*outside.labels, *names.labels))


def axes_of(panel: Panel, decimal: str = ".") -> tuple[Axis, Axis]:
    """Both axes; the vertical one holds the height 0."""
    heights = np.concatenate([[0.0], *(curve.values for curve in panel.curves)])
    across = axis(panel.places, WIDE, sign=panel.across_scale.sign, decimal=decimal, tight=True)
    return across, axis(heights, HIGH, sign=panel.up_scale.sign, decimal=decimal)


def drawn(panel: Panel, x: Axis, y: Axis) -> list[Drawn]:
    """The curves in the picture."""
    return [
        Drawn(curve.name, np.stack([x.at(panel.places), y.at(curve.values)], axis=1), curve.style or look)
        for curve, look in zip(panel.curves, cycle(LOOKS), strict=False)
    ]


def has_jump(panel: Panel) -> bool:
    """Does a value jump somewhere?"""
    return any(curve.jumps for curve in drawn(panel, *axes_of(panel)))


def together(curves: Sequence[Drawn], y: Axis) -> list[Drawn]:
    """The curves, those that lie on each other as one with an equation for a name; one on the axis says so."""
    found: list[Drawn] = []
    for curve in curves:
        like = next((k for k, one in enumerate(found) if are_same(one, curve)), None)
        if like is None:
            found.append(curve)
        else:
            one = found[like]
            style = one.style if one.style == "curve sum" else curve.style
            found[like] = Drawn(t.equation(*one.names, curve.name), one.points, style)
    return [replace(one, name=t.equation(*one.names, t.ZERO)) if is_nothing(one, y) else one for one in found]


def are_same(one: Drawn, other: Drawn) -> bool:
    """Do two curves with formulas for names lie on each other?"""
    has_words = isinstance(one.name, str) or isinstance(other.name, str)
    return not has_words and np.allclose(one.points, other.points, rtol=0.0, atol=SAME, equal_nan=True)


def is_nothing(curve: Drawn, y: Axis) -> bool:
    """Does a curve with a formula for a name lie on the axis?"""
    return not isinstance(curve.name, str) and np.nanmax(np.abs(curve.points[:, 1] - y.at(0.0))) <= SAME


def frame(x: Axis, y: Axis) -> Iterator[Item]:
    """The axes with their ticks; the horizontal one also at the height 0."""
    yield Line(((0.0, HIGH), (0.0, 0.0), (WIDE, 0.0)), "axis")
    ticks = [((x.at(tick), 0.0), (x.at(tick), -TICK)) for tick in x.ticks]
    ticks += [((0.0, y.at(tick)), (-TICK, y.at(tick))) for tick in y.ticks]
    yield Strokes(tuple(ticks), "axis")
    if y.low < 0 < y.high:
        yield Line(((0.0, y.at(0.0)), (WIDE, y.at(0.0))), "dimension")


def mark(one: Mark, x: Axis, y: Axis) -> Iterator[Item]:
    """A dashed line at a place, with a dot where it meets the height 0."""
    yield Line(((x.at(one.place), 0.0), (x.at(one.place), HIGH)), "guide")
    if one.has_dot:
        yield Circle((x.at(one.place), y.at(0.0)), 0.0, "dot")


def mark_labels(panel: Panel, x: Axis, notation: Notation) -> Iterator[Label]:
    """What happens at the marks, above their lines."""
    for one in (one for one in panel.marks if one.name):
        name = notation.names.get(one.name, one.name) if isinstance(one.name, str) else one.name
        yield Label(name, (x.at(one.place), HIGH), toward=UP, color="soft")


def tick_labels(x: Axis, y: Axis) -> Iterator[Label]:
    """Numbers below and at the left; below as many as have room."""
    width = EM * (0.5 * max(map(len, x.texts), default=0) + 0.4)
    skip = max(1, math.ceil(width / (x.at(x.ticks[1]) - x.at(x.ticks[0])))) if len(x.ticks) > 1 else 1
    first = next((k for k, tick in enumerate(x.ticks) if tick == 0), 0) % skip
    for tick, text in zip(x.ticks[first::skip], x.texts[first::skip], strict=True):
        yield fixed(text, (x.at(tick), -TICK - 0.32), "soft")
    for tick, text in zip(y.ticks, y.texts, strict=True):
        yield fixed(text, (-TICK - 0.04 - EM * (0.25 * len(text) + 0.125), y.at(tick)), "soft")


def axis_labels(panel: Panel, notation: Notation) -> Iterator[Label]:
    """What the axes count: at the right end below, and above the vertical axis."""
    across = in_units(panel.across, panel.across_scale)
    wide, high = label_size(Label(across, (WIDE, 0.0)), notation)
    yield fixed(across, (WIDE + 0.15 + wide / 2, high / 2 - 0.1), "ink")
    if panel.up_scale.node is not None:
        yield Label(panel.up_scale.node, (0.0, HIGH), toward=UP, gap=0.2)


def in_units(node: t.Node, scale: Scale) -> t.Node:
    """A quantity over the unit in which it is counted; one in degrees says so at its ticks."""
    if scale.node is None:
        return node
    return t.Mul((node, t.Word(f"/ {scale.node.text}"))) if isinstance(scale.node, t.Word) else t.Div(node, scale.node)


def named(curves: Sequence[Drawn], rest: Scene, notation: Notation) -> Scene:
    """A name beside each curve, in its colour; for those that have no room a line in a legend."""
    sizes = [label_size(Label(curve.name, (0.0, 0.0)), notation) for curve in curves]
    pieces = [tuple(curve.pieces) for curve in curves]
    lines = [ends for item in rest.items for ends in (item.pieces if isinstance(item, Strokes) else [points_of(item)])]
    spots = places(pieces, sizes, [one.box for one in rest.labels], lines, (0.04, 0.04, WIDE + 1.4, HIGH - 0.02))
    beside = [fixed(c.name, spot, STYLES[c.style].stroke) for c, spot in zip(curves, spots, strict=True) if spot]
    left = [(curve, size) for curve, size, spot in zip(curves, sizes, spots, strict=True) if spot is None]
    ends = [spot[0] + size[0] / 2 for spot, size in zip(spots, sizes, strict=True) if spot]
    listed = list(legend(left, max([WIDE, *ends])))
    return Scene(tuple(line for line, _ in listed), (*beside, *(label for _, label in listed)))


def legend(left: Sequence[tuple[Drawn, tuple[float, float]]], start: float) -> Iterator[tuple[Item, Label]]:
    """A line and a name for each of some curves, from the highest end to the lowest."""
    order = sorted(left, key=lambda pair: -pair[0].points[np.isfinite(pair[0].points[:, 1])][-1, 1])
    step = max((size[1] for _, size in left), default=0.0) + 0.04
    top = max(HIGH / 2 + step * (len(order) - 1) / 2 + 0.2, 0.9 + step * (len(order) - 1))
    for row, (curve, size) in enumerate(order):
        height = top - step * row
        line = Line(((start + 0.2, height), (start + 0.75, height)), curve.style)
        yield line, fixed(curve.name, (start + 0.9 + size[0] / 2, height), STYLES[curve.style].stroke)


def fixed(content: t.Node | str, place: Point, color: str) -> Label:
    """A label that stands where it is put."""
    return Label(content, place, color=color, place=place)
