"""A scene as a TikZ picture that a person can edit: coordinates in cm, named styles."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.pictures.figures import scene as s
from rbpsym.pictures.figures.scene import placed
from rbpsym.typeset.escaping import latex_text
from rbpsym.typeset.latex import to_latex


def to_tikz(scene: s.Scene, notation: Notation = DEFAULT) -> str:
    """The scene as a `tikzpicture`; its styles are defined once by `tikz_styles`."""
    scene = placed(scene, notation)
    lines = [PRINT[type(item)](item) for item in scene.items]
    lines += [label_tikz(label, notation) for label in scene.labels]
    inner = "\n".join(f"  {line}" for line in lines)
    return f"\\begin{{tikzpicture}}\n{inner}\n\\end{{tikzpicture}}"


def number(value: float) -> str:
    """A length in cm, without needless digits."""
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def pair(point: s.Point) -> str:
    """(x, y)."""
    return f"({number(point[0])},{number(point[1])})"


def style_name(name: str) -> str:
    """The TikZ name of a style."""
    return f"rb {name}"


HEADS = {"": "", "end": ", -Stealth", "both": ", Stealth-Stealth"}


def line_tikz(item: s.Polyline) -> str:
    """A path through points."""
    path = " -- ".join(map(pair, item.points)) + (" -- cycle" if item.closed else "")
    return rf"\draw[{style_name(item.style)}{HEADS[item.heads]}] {path};"


def strokes_tikz(item: s.Strokes) -> str:
    """All strokes in one path."""
    path = " ".join(f"{pair(start)} -- {pair(end)}" for start, end in item.pieces)
    return rf"\draw[{style_name(item.style)}] {path};"


def circle_tikz(item: s.Circle) -> str:
    """A circle; one without size is a dot."""
    radius = number(max(item.radius, s.DOT))
    return rf"\draw[{style_name(item.style)}] {pair(item.center)} circle[radius={radius}];"


def arc_tikz(item: s.Arc) -> str:
    """An arc from its first point."""
    start, end = (number(math.degrees(angle)) for angle in (item.start, item.end))
    arc = f"arc[start angle={start}, end angle={end}, radius={number(item.radius)}]"
    return rf"\draw[{style_name(item.style)}{HEADS[item.heads]}] {pair(item.at(0))} {arc};"


PRINT: Mapping[type, Callable[..., str]] = {
    s.Polyline: line_tikz,
    s.Strokes: strokes_tikz,
    s.Circle: circle_tikz,
    s.Arc: arc_tikz,
}


def label_tikz(label: s.Label, notation: Notation) -> str:
    """A node at the label's place."""
    told = label.content
    text = latex_text(told) if isinstance(told, str) else f"${to_latex(told, notation)}$"
    return rf"\node[rb label, text=rb{label.color}] at {pair(label.center)} {{{text}}};"


def tikz_styles() -> str:
    """The colours and styles of all scenes, for the preamble."""
    colors = [rf"\definecolor{{rb{n}}}{{HTML}}{{{c[0][1:].upper()}}}" for n, c in s.COLORS.items()]
    styles = [rf"\tikzset{{{style_name(n)}/.style={{{options(look)}}}}}" for n, look in s.STYLES.items()]
    label = r"\tikzset{rb label/.style={inner sep=0pt, outer sep=0pt}}"
    return "\n".join([*colors, *styles, label])


def options(style: s.DrawingStyle) -> str:
    """The options of a style."""
    found = [f"draw=rb{style.stroke}", f"line width={style.width}pt", "line join=round"]
    found += [f"fill=rb{style.fill}"] if style.fill else []
    found += [f"dash pattern=on {style.dash}cm off {style.dash}cm"] if style.dash else []
    return ", ".join(found)
