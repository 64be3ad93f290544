"""A plot as a scene: axes with ticks, curves, and a line of the legend for each curve."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from rbpsym.document.breaking import node_height, node_width
from rbpsym.document.figures.placing import label_size
from rbpsym.document.figures.scene import EM, Circle, Item, Label, Line, Point, Scene, Strokes
from rbpsym.document.plots.axes import Axis, axis
from rbpsym.document.plots.scales import Scale
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation

WIDE, HIGH = 4.3, 3.4  # cm between the axes' ends
TICK = 0.09
STYLES = ("curve 1", "curve 2", "curve 3", "curve 4", "curve 5", "curve 6")
SMALL = 0.5 * EM


@dataclass(frozen=True)
class Curve:
    """Values at the places of a panel: what it is called, and its style."""

    name: t.Node | str
    values: Sequence[float]
    style: str = ""


@dataclass(frozen=True)
class Panel:
    """Curves over common places. Values are in units of the scales already.

    `what` heads the vertical axis (None where the legend says it all); at `marks` something ends.
    """

    across: t.Node
    places: Sequence[float]
    curves: tuple[Curve, ...]
    across_scale: Scale
    up_scale: Scale
    what: t.Node | None = None
    marks: tuple[float, ...] = ()


def scene(panel: Panel, notation: Notation) -> Scene:
    """The panel as a drawing."""
    x = axis(panel.places, sign=panel.across_scale.sign, decimal=notation.decimal, tight=True)
    heights = [value for curve in panel.curves for value in curve.values] + [0.0]
    y = axis(heights, sign=panel.up_scale.sign, decimal=notation.decimal)
    items = [*frame(x, y), *(item for m in panel.marks for item in mark(m, x, y))]
    for place, curve in enumerate(panel.curves):
        items += drawn(curve, style_of(curve, place), panel.places, x, y)
    legend = list(legend_of(panel, notation))
    labels = [*tick_labels(x, y), *axis_labels(panel, y, notation), *(label for _, label in legend)]
    return Scene(tuple(items + [line for line, _ in legend]), tuple(labels))


def style_of(curve: Curve, place: int) -> str:
    """The curve's own style, or the next one."""
    return curve.style or STYLES[place % len(STYLES)]


def frame(x: Axis, y: Axis) -> Iterator[Item]:
    """The axes with their ticks; the horizontal one also at the height 0."""
    yield Line(((0.0, HIGH), (0.0, 0.0), (WIDE, 0.0)), "axis")
    ticks = [((WIDE * x.share(tick), 0.0), (WIDE * x.share(tick), -TICK)) for tick in x.ticks]
    ticks += [((0.0, HIGH * y.share(tick)), (-TICK, HIGH * y.share(tick))) for tick in y.ticks]
    yield Strokes(tuple(ticks), "axis")
    if y.low < 0 < y.high:
        yield Line(((0.0, HIGH * y.share(0)), (WIDE, HIGH * y.share(0))), "dimension")


def mark(place: float, x: Axis, y: Axis) -> Iterator[Item]:
    """A dashed line at a place, with a dot where it meets the height 0."""
    across = WIDE * x.share(place)
    yield Line(((across, 0.0), (across, HIGH)), "guide")
    yield Circle((across, HIGH * y.share(0)), 0.0, "dot")


def drawn(curve: Curve, style: str, places: Sequence[float], x: Axis, y: Axis) -> Iterator[Item]:
    """A curve in as many pieces as it has."""
    piece: list[Point] = []
    for place, value in zip(places, curve.values, strict=False):
        if math.isfinite(value):
            piece.append((WIDE * x.share(place), HIGH * y.share(value)))
            continue
        yield from lines(piece, style)
        piece = []
    yield from lines(piece, style)


def lines(points: list[Point], style: str) -> Iterator[Item]:
    """A broken line without the points that would not be seen."""
    if len(points) > 1:
        yield Line(tuple(thinned(points)), style)


def thinned(points: list[Point]) -> Iterator[Point]:
    """Points at least half a millimetre apart, and the ends."""
    last = points[0]
    yield last
    for point in points[1:-1]:
        if math.dist(point, last) > 0.055:
            last = point
            yield point
    yield points[-1]


def tick_labels(x: Axis, y: Axis) -> Iterator[Label]:
    """Numbers below and at the left."""
    shown = x.ticks[:: 1 + (len(x.ticks) > 6)]
    for tick, text in zip(x.ticks, x.texts, strict=True):
        if tick in shown:
            yield fixed(text, (WIDE * x.share(tick), -TICK - 0.26), "soft")
    for tick, text in zip(y.ticks, y.texts, strict=True):
        yield fixed(text, (-TICK - 0.08 - SMALL * len(text) / 2, HIGH * y.share(tick)), "soft")


def axis_labels(panel: Panel, y: Axis, notation: Notation) -> Iterator[Label]:
    """What the axes count: at the right end below, and above the vertical axis."""
    across = in_units(panel.across, panel.across_scale)
    wide, high = (EM * measure(across, notation) for measure in (node_width, node_height))
    yield fixed(across, (WIDE + 0.2 + wide / 2, high / 2 - 0.1), "ink")
    above = in_units(panel.what, panel.up_scale) if panel.what is not None else panel.up_scale.node
    if above is not None:
        size = EM * node_height(above, notation)
        yield fixed(above, (max(0.0, EM * node_width(above, notation) / 2 - 0.5), HIGH + 0.18 + size / 2), "ink")


def in_units(node: t.Node, scale: Scale) -> t.Node:
    """A quantity over the unit in which it is counted; one in degrees says so at its ticks."""
    if scale.node is None:
        return node
    return t.Mul((node, t.Word(f"/ {scale.node.text}"))) if isinstance(scale.node, t.Word) else t.Div(node, scale.node)


def legend_of(panel: Panel, notation: Notation) -> Iterator[tuple[Item, Label]]:
    """A line and a name for each curve, from the highest end to the lowest."""
    order = sorted(range(len(panel.curves)), key=lambda k: -final(panel.curves[k].values))
    sizes = [label_size(fixed(curve.name, (0.0, 0.0), "ink"), notation)[1] for curve in panel.curves]
    step = max(sizes, default=0.0) + 0.04
    top = max(HIGH / 2 + step * (len(order) - 1) / 2 + 0.2, 0.9 + step * (len(order) - 1))
    for row, place in enumerate(order):
        curve, height = panel.curves[place], top - step * row
        width = label_size(fixed(curve.name, (0.0, 0.0), "ink"), notation)[0]
        line = Line(((WIDE + 0.2, height), (WIDE + 0.75, height)), style_of(curve, place))
        yield line, fixed(curve.name, (WIDE + 0.9 + width / 2, height), "ink")


def final(values: Sequence[float]) -> float:
    """The last value that is a number."""
    return next((value for value in reversed(values) if math.isfinite(value)), 0.0)


def fixed(content: t.Node | str, place: Point, color: str) -> Label:
    """A label that stands where it is put."""
    return Label(content, place, color=color, place=place)
