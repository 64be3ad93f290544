"""A plot as a scene: axes with ticks, curves with their names beside them, and what happens on the way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from rbpsym.document.breaking import node_height, node_width
from rbpsym.document.figures.placing import grown, label_size, overlap
from rbpsym.document.figures.scene import EM, STYLES, Circle, Item, Label, Line, Point, Scene, Strokes, points_of
from rbpsym.document.plots.axes import Axis, axis
from rbpsym.document.plots.naming import Named, around, lengths, places
from rbpsym.document.plots.scales import Scale
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation

WIDE, HIGH = 4.3, 3.4  # cm between the axes' ends
TICK = 0.09
LOOKS = ("curve 1", "curve 2", "curve 3", "curve 4", "curve 5", "curve 6")
SAME = 1e-6  # of the height: curves that are no farther apart are one
JUMP = 0.015  # of the height: what is more is a jump
RING = 0.06
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

    `what` heads the vertical axis (None where the names of the curves say it all). Where places and values
    are not numbers there is a gap: what is on both its sides is a jump. `omitted` curves had no room.
    """

    across: t.Node
    places: np.ndarray
    curves: tuple[Curve, ...]
    across_scale: Scale
    up_scale: Scale
    what: t.Node | None = None
    marks: tuple[Mark, ...] = ()
    omitted: int = 0


def scene(panel: Panel, notation: Notation) -> Scene:
    """The panel as a drawing."""
    x, y = axes_of(panel, notation.decimal)
    styled = [replace(curve, style=curve.style or LOOKS[k % len(LOOKS)]) for k, curve in enumerate(panel.curves)]
    styled = sorted(styled, key=lambda curve: curve.style != "curve sum")
    axes = [*frame(x, y), *(item for one in panel.marks for item in mark(one, x, y))]
    rings = [item for curve in styled for item in jumps(curve, panel.places, x, y)]
    outside = [*tick_labels(x, y), *axis_labels(panel, notation)]
    outside += mark_labels(panel, x, outside, notation)
    drawn = [Line(tuple(map(tuple, p.tolist())), c.style) for c in styled for p in pieces(c, panel.places, x, y)]
    names = named(together(styled, y), panel.places, x, y, Scene((*axes, *rings), tuple(outside)), notation)
    return Scene((*axes, *drawn, *rings, *names.items), (*outside, *names.labels))


def axes_of(panel: Panel, decimal: str = ".") -> tuple[Axis, Axis]:
    """Both axes; the vertical one holds the height 0."""
    heights = np.concatenate([[0.0], *(curve.values for curve in panel.curves)])
    across = axis(panel.places, sign=panel.across_scale.sign, decimal=decimal, tight=True)
    return across, axis(heights, sign=panel.up_scale.sign, decimal=decimal)


def together(curves: Sequence[Curve], y: Axis) -> list[Curve]:
    """The curves, those that lie on each other as one with an equation for a name; one on the axis says so."""
    found: list[Curve] = []
    for curve in curves:
        like = next((k for k, one in enumerate(found) if are_same(one, curve, y)), None)
        if like is None:
            found.append(curve)
        else:
            one = found[like]
            style = one.style if one.style == "curve sum" else curve.style
            found[like] = Curve(t.equation(*names_of(one), curve.name), one.values, style)
    return [replace(one, name=t.equation(*names_of(one), t.ZERO)) if is_nothing(one, y) else one for one in found]


def names_of(curve: Curve) -> Sequence[t.Node]:
    """The names of a curve that has several."""
    return curve.name.items if isinstance(curve.name, t.Chain) else (curve.name,)


def is_nothing(curve: Curve, y: Axis) -> bool:
    """Does a curve with a formula for a name lie on the axis?"""
    return not isinstance(curve.name, str) and np.nanmax(np.abs(curve.values)) <= SAME * (y.high - y.low)


def are_same(one: Curve, other: Curve, y: Axis) -> bool:
    """Do two curves with formulas for names lie on each other?"""
    has_words = isinstance(one.name, str) or isinstance(other.name, str)
    near = SAME * (y.high - y.low)
    return not has_words and np.allclose(one.values, other.values, rtol=0.0, atol=near, equal_nan=True)


def frame(x: Axis, y: Axis) -> Iterator[Item]:
    """The axes with their ticks; the horizontal one also at the height 0."""
    yield Line(((0.0, HIGH), (0.0, 0.0), (WIDE, 0.0)), "axis")
    ticks = [((WIDE * x.share(tick), 0.0), (WIDE * x.share(tick), -TICK)) for tick in x.ticks]
    ticks += [((0.0, HIGH * y.share(tick)), (-TICK, HIGH * y.share(tick))) for tick in y.ticks]
    yield Strokes(tuple(ticks), "axis")
    if y.low < 0 < y.high:
        yield Line(((0.0, HIGH * y.share(0)), (WIDE, HIGH * y.share(0))), "dimension")


def mark(one: Mark, x: Axis, y: Axis) -> Iterator[Item]:
    """A dashed line at a place, with a dot where it meets the height 0."""
    across = WIDE * x.share(one.place)
    yield Line(((across, 0.0), (across, HIGH)), "guide")
    if one.has_dot:
        yield Circle((across, HIGH * y.share(0)), 0.0, "dot")


def mark_labels(panel: Panel, x: Axis, taken: Sequence[Label], notation: Notation) -> list[Label]:
    """What happens at the marks, above their lines; one above the other where they are close together."""
    boxes, found = [replace(one, size=label_size(one, notation)).box for one in taken], []
    for one in (one for one in panel.marks if one.name):
        name = notation.names.get(one.name, one.name) if isinstance(one.name, str) else one.name
        wide, high = label_size(fixed(name, (0.0, 0.0), "soft"), notation)
        across = min(max(WIDE * x.share(one.place), wide / 2 - 0.2), WIDE + 0.9 - wide / 2)
        up = HIGH + 0.08 + high / 2
        while any(overlap(grown(around((across, up), (wide, high)), 0.02), box) for box in boxes):
            up += 0.1
        boxes.append(around((across, up), (wide, high)))
        found.append(fixed(name, (across, up), "soft"))
    return found


def jumps(curve: Curve, across: np.ndarray, x: Axis, y: Axis) -> Iterator[Item]:
    """An open circle where a curve ends and a full one where it goes on elsewhere at the same place."""
    points = in_panel(curve, across, x, y)
    for k in np.flatnonzero(np.isnan(across)):
        (_, before), (_, after) = ends = points[k - 1], points[k + 1]
        if abs(after - before) > JUMP * HIGH:
            yield Circle(tuple(ends[0].tolist()), RING, "joint")
            yield Circle(tuple(ends[1].tolist()), 0.0, "dot")


def has_jump(panel: Panel) -> bool:
    """Does a value jump somewhere?"""
    x, y = axes_of(panel)
    return any(next(jumps(curve, panel.places, x, y), None) for curve in panel.curves)


def in_panel(curve: Curve, across: np.ndarray, x: Axis, y: Axis) -> np.ndarray:
    """The points of a curve as rows, in cm."""
    return np.stack([WIDE * x.share(across), HIGH * y.share(curve.values)], axis=1)


def pieces(curve: Curve, across: np.ndarray, x: Axis, y: Axis) -> Iterator[np.ndarray]:
    """The points of each piece of a curve, about a third of a millimetre apart, in cm."""
    points = in_panel(curve, across, x, y)
    is_known = np.isfinite(points).all(axis=1)
    for piece in np.split(points, np.flatnonzero(np.diff(is_known)) + 1):
        if len(piece) > 1 and np.isfinite(piece).all():
            steps = np.diff(np.floor(lengths(piece) / NEAR), prepend=-1.0) > 0
            steps[-1] = True
            yield piece[steps]


def named(curves: Sequence[Curve], across: np.ndarray, x: Axis, y: Axis, rest: Scene, notation: Notation) -> Scene:
    """A name beside each curve, in its colour; for those that have no room a line in a legend."""
    labels = [fixed(curve.name, (0.0, 0.0), STYLES[curve.style].stroke) for curve in curves]
    sizes = [label_size(label, notation) for label in labels]
    shapes = [Named(tuple(pieces(c, across, x, y)), size) for c, size in zip(curves, sizes, strict=True)]
    taken = [replace(one, size=label_size(one, notation)).box for one in rest.labels]
    lines = [
        piece for item in rest.items for piece in (item.pieces if isinstance(item, Strokes) else [points_of(item)])
    ]
    spots = places(shapes, taken, lines, (0.04, 0.04, WIDE + 1.4, HIGH - 0.02))
    beside = [replace(one, target=spot, place=spot) for one, spot in zip(labels, spots, strict=True) if spot]
    left = [(curve, size) for curve, size, spot in zip(curves, sizes, spots, strict=True) if spot is None]
    ends = [spot[0] + size[0] / 2 for spot, size in zip(spots, sizes, strict=True) if spot]
    listed = list(legend(left, max([WIDE, *ends])))
    return Scene(tuple(line for line, _ in listed), (*beside, *(label for _, label in listed)))


def legend(left: Sequence[tuple[Curve, tuple[float, float]]], start: float) -> Iterator[tuple[Item, Label]]:
    """A line and a name for each of some curves, from the highest end to the lowest."""
    order = sorted(left, key=lambda pair: -pair[0].values[np.isfinite(pair[0].values)][-1])
    step = max((size[1] for _, size in left), default=0.0) + 0.04
    top = max(HIGH / 2 + step * (len(order) - 1) / 2 + 0.2, 0.9 + step * (len(order) - 1))
    for row, (curve, size) in enumerate(order):
        height = top - step * row
        line = Line(((start + 0.2, height), (start + 0.75, height)), curve.style)
        yield line, fixed(curve.name, (start + 0.9 + size[0] / 2, height), STYLES[curve.style].stroke)


def tick_labels(x: Axis, y: Axis) -> Iterator[Label]:
    """Numbers below and at the left; below as many as have room."""
    width = max((text_width(text) for text in x.texts), default=0.0) + 0.06
    space = WIDE * (x.share(x.ticks[1]) - x.share(x.ticks[0])) if len(x.ticks) > 1 else WIDE
    skip = max(1, math.ceil(width / space))
    first = next((k for k, tick in enumerate(x.ticks) if tick == 0), 0) % skip
    for tick, text in zip(x.ticks[first::skip], x.texts[first::skip], strict=True):
        yield fixed(text, (WIDE * x.share(tick), -TICK - 0.32), "soft")
    for tick, text in zip(y.ticks, y.texts, strict=True):
        yield fixed(text, (-TICK - 0.04 - text_width(text) / 2, HIGH * y.share(tick)), "soft")


def text_width(text: str) -> float:
    """How wide a number is, with the air round it."""
    return EM * (0.5 * len(text) + 0.25)


def axis_labels(panel: Panel, notation: Notation) -> Iterator[Label]:
    """What the axes count: at the right end below, and above the vertical axis."""
    across = in_units(panel.across, panel.across_scale)
    wide, high = (EM * measure(across, notation) for measure in (node_width, node_height))
    yield fixed(across, (WIDE + 0.2 + wide / 2, high / 2 - 0.1), "ink")
    above = in_units(panel.what, panel.up_scale) if panel.what is not None else panel.up_scale.node
    if above is not None:
        size = EM * node_height(above, notation)
        yield fixed(above, (max(0.0, EM * node_width(above, notation) / 2 - 0.5), HIGH + 0.25 + size / 2), "ink")


def in_units(node: t.Node, scale: Scale) -> t.Node:
    """A quantity over the unit in which it is counted; one in degrees says so at its ticks."""
    if scale.node is None:
        return node
    return t.Mul((node, t.Word(f"/ {scale.node.text}"))) if isinstance(scale.node, t.Word) else t.Div(node, scale.node)


def fixed(content: t.Node | str, place: Point, color: str) -> Label:
    """A label that stands where it is put."""
    return Label(content, place, color=color, place=place)
