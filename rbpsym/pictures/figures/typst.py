"""A scene as a Typst drawing: polygons, circles and curves placed in a box."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.pictures.figures import scene as s
from rbpsym.pictures.figures.scene import placed
from rbpsym.pictures.figures.tikz import number
from rbpsym.typeset.escaping import typst_string
from rbpsym.typeset.typst import to_typst

Origin = tuple[float, float]


def to_typst_drawing(scene: s.Scene, notation: Notation = DEFAULT) -> str:
    """The scene as a call of `drawing` (see templates/notes.typ) in code mode."""
    scene = placed(scene, notation)
    left, bottom, right, top = scene.bounds
    origin = (left, top)
    items = [PRINT[type(item)](item, origin) for item in scene.items]
    items += [label_typst(label, origin, notation) for label in scene.labels]
    size = f"{number(right - left)}cm, {number(top - bottom)}cm"
    return "drawing({}, {{\n{}\n}})".format(size, "\n".join(f"  {item}" for item in items))


def pair(point: s.Point, origin: Origin) -> str:
    """(x, y) from the upper left corner."""
    return f"({number(point[0] - origin[0])}cm, {number(origin[1] - point[1])}cm)"


def look(name: str) -> str:
    """Fill and stroke of a style."""
    style = s.STYLES[name]
    dash = f", dash: ({style.dash}cm, {style.dash}cm)" if style.dash else ""
    stroke = f'stroke: (paint: {color(style.stroke)}, thickness: {style.width}pt, join: "round"{dash})'
    return f"fill: {color(style.fill) if style.fill else 'none'}, {stroke}"


def color(name: str) -> str:
    """The light colour of that name."""
    return f'rgb("{s.COLORS[name][0]}")'


def line_typst(item: s.Polyline, origin: Origin) -> str:
    """A curve of straight pieces."""
    first, *others = (pair(point, origin) for point in item.points)
    steps = [f"curve.move({first})", *(f"curve.line({point})" for point in others)]
    steps += ["curve.close()"] if item.closed else []
    return f"place(curve({look(item.style)}, {', '.join(steps)}))" + heads_typst(item, origin)


def strokes_typst(item: s.Strokes, origin: Origin) -> str:
    """All strokes in one curve."""
    steps = ", ".join(
        f"curve.move({pair(start, origin)}), curve.line({pair(end, origin)})" for start, end in item.pieces
    )
    return f"place(curve({look(item.style)}, {steps}))"


def circle_typst(item: s.Circle, origin: Origin) -> str:
    """A circle, placed by its corner."""
    radius = max(item.radius, s.DOT)
    x, y = item.center[0] - radius, item.center[1] + radius
    dx, dy = number(x - origin[0]), number(origin[1] - y)
    shape = f"circle(radius: {number(radius)}cm, {look(item.style)})"
    return f"place(dx: {dx}cm, dy: {dy}cm, {shape})"


def arc_typst(item: s.Arc, origin: Origin) -> str:
    """An arc as straight pieces, so short that none is seen."""
    count = math.ceil(abs(item.end - item.start) / 0.05) + 1
    path = s.Polyline(tuple(item.at(n / count) for n in range(count + 1)), item.style)
    return line_typst(path, origin) + heads_typst(item, origin)


def heads_typst(item: s.Polyline | s.Arc, origin: Origin) -> str:
    """Arrow heads as filled polygons."""
    style = s.STYLES[item.style]
    heads = (s.head_shape(tip, angle, style.width) for tip, angle in s.heads_of(item))
    return "".join(
        f"; place(polygon(fill: {color(style.stroke)}, {', '.join(pair(p, origin) for p in head)}))" for head in heads
    )


PRINT: Mapping[type, Callable[..., str]] = {
    s.Polyline: line_typst,
    s.Strokes: strokes_typst,
    s.Circle: circle_typst,
    s.Arc: arc_typst,
}


def label_typst(label: s.Label, origin: Origin, notation: Notation) -> str:
    """A label, centred at its place."""
    (x, y), told = label.center, label.content
    text = typst_string(told) if isinstance(told, str) else f"${to_typst(told, notation)}$"
    at = f"{number(x - origin[0])}cm, {number(origin[1] - y)}cm"
    return f"label-at({at}, {color(label.color)}, {text})"
