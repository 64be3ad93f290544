"""A scene as inline SVG; its labels are MathML, its colours follow light and dark."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from markupsafe import escape

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.pictures.figures import scene as s
from rbpsym.pictures.figures.scene import placed
from rbpsym.typeset.accents import accented
from rbpsym.typeset.mathml import to_mathml

SCALE = 40.0  # user units a centimetre
POINT = SCALE / 28.35


def to_svg(scene: s.Scene, notation: Notation = DEFAULT) -> str:
    """The scene as an `<svg>` element."""
    scene = placed(scene, notation)
    left, bottom, right, top = scene.bounds
    shapes = "".join(PRINT[type(item)](item) for item in scene.items)
    labels = "".join(label_svg(label, notation) for label in scene.labels)
    box = f"{number(left)} {number(-top)} {number(right - left)} {number(top - bottom)}"
    return (
        f'<svg class="scene" viewBox="{box}" width="{number(right - left)}"'
        f' height="{number(top - bottom)}" xmlns="http://www.w3.org/2000/svg">{shapes}{labels}</svg>'
    )


def number(length: float) -> str:
    """A length in user units, without needless digits."""
    text = f"{length * SCALE:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def pair(point: s.Point) -> str:
    """x,y downwards."""
    return f"{number(point[0])},{number(-point[1])}"


def look(name: str) -> str:
    """The class and the line of a style."""
    style = s.STYLES[name]
    dash = f' stroke-dasharray="{number(style.dash)}"' if style.dash else ""
    filled = f"fill-{style.fill}" if style.fill else "fill-none"
    return f'class="ink-{style.stroke} {filled}" stroke-width="{style.width * POINT:.2f}"{dash}'


def line_svg(item: s.Polyline) -> str:
    """A polyline or polygon with its heads."""
    tag = "polygon" if item.closed else "polyline"
    points = " ".join(map(pair, item.points))
    return f'<{tag} points="{points}" {look(item.style)}/>{heads_svg(item)}'


def strokes_svg(item: s.Strokes) -> str:
    """All strokes in one path."""
    path = "".join(f"M{pair(start)} L{pair(end)}" for start, end in item.pieces)
    return f'<path d="{path}" {look(item.style)}/>'


def circle_svg(item: s.Circle) -> str:
    """A circle; one without size is a dot."""
    x, y = pair(item.center).split(",")
    radius = number(max(item.radius, s.DOT))
    return f'<circle cx="{x}" cy="{y}" r="{radius}" {look(item.style)}/>'


def arc_svg(item: s.Arc) -> str:
    """An arc with its heads."""
    large = int(abs(item.end - item.start) > 3.141592653589793)
    sweep = int(item.end < item.start)
    radius = number(item.radius)
    path = f"M{pair(item.at(0))} A{radius},{radius} 0 {large} {sweep} {pair(item.at(1))}"
    return f'<path d="{path}" {look(item.style)}/>{heads_svg(item)}'


def heads_svg(item: s.Polyline | s.Arc) -> str:
    """Arrow heads as filled triangles."""
    style = s.STYLES[item.style]
    return "".join(
        f'<polygon points="{" ".join(map(pair, s.head_shape(tip, angle, style.width)))}" class="fill-{style.stroke}"/>'
        for tip, angle in s.heads_of(item)
    )


PRINT: Mapping[type, Callable[..., str]] = {
    s.Polyline: line_svg,
    s.Strokes: strokes_svg,
    s.Circle: circle_svg,
    s.Arc: arc_svg,
}


def label_svg(label: s.Label, notation: Notation) -> str:
    """A label as MathML in a box that is a little larger than the label."""
    left, _, right, top = label.box
    told = label.content
    inner = escape(told) if isinstance(told, str) else accented(to_mathml(told, notation))
    wide, high = right - left + 0.4, top - label.box[1] + 0.4
    return (
        f'<foreignObject x="{number(left - 0.2)}" y="{number(-top - 0.2)}" width="{number(wide)}"'
        f' height="{number(high)}"><div xmlns="http://www.w3.org/1999/xhtml"'
        f' class="label ink-{label.color}">{inner}</div></foreignObject>'
    )


def color_rules() -> str:
    """The style sheet of the scene's colours, for light and dark."""
    light = "".join(color_rule(name, pair[0]) for name, pair in s.COLORS.items())
    dark = "".join(color_rule(name, pair[1]) for name, pair in s.COLORS.items())
    return f"{light}@media screen and (prefers-color-scheme:dark){{{dark}}}"


def color_rule(name: str, color: str) -> str:
    """The rules of one colour."""
    return (
        f".scene .ink-{name}{{stroke:{color}}}.scene .fill-{name}{{fill:{color}}}"
        f".scene .label.ink-{name}{{color:{color}}}"
    )
