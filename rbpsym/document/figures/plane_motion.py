"""The figure of the general theory: a point of a body seen from the origin and from the centre of mass, r' = R + r."""

from __future__ import annotations

import math

from rbpsym.document.figures.placing import placed
from rbpsym.document.figures.scene import Circle, Label, Line, Point, Scene, direction, polar
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation

ORIGIN, CENTRE, SIZE = (0.0, 0.0), (3.4, 1.5), 1.25  # cm
PLACE = polar(CENTRE, 0.95, 1.15)  # of the point of the body
AXES = {"x": (1.5, 0.0), "y": (0.0, 1.2)}
POINTS = 72


def split_of_place(notation: Notation) -> Scene:
    """Axes at O, a body with its centre of mass, a point of it, and the three vectors between these."""
    angles = [2 * math.pi * k / POINTS for k in range(POINTS)]
    outline = tuple(polar(CENTRE, SIZE * (1 + 0.16 * math.cos(2 * a - 0.7) + 0.07 * math.sin(3 * a)), a) for a in angles)
    vectors = (
        (ORIGIN, CENTRE, "R_cm", "curve 1", -1),
        (CENTRE, PLACE, "r", "velocity", -1),
        (ORIGIN, PLACE, "r_prime", "force", 1),
    )
    items = [Line(outline, "body", closed=True), *(Line((ORIGIN, end), "axis", heads="end") for end in AXES.values())]
    items += [Line((start, end), style, heads="end") for start, end, _, style, _ in vectors]
    items += [Circle(point, 0.0, "dot") for point in (ORIGIN, CENTRE, PLACE)]
    labels = [Label(t.Sym(name), end, direction(ORIGIN, end)) for name, end in AXES.items()]
    labels += [_beside(start, end, name, side) for start, end, name, _, side in vectors]
    labels += [Label(t.Sym("O"), ORIGIN, -2.4), Label("cm", CENTRE, -1.0), Label(t.Sym("p"), PLACE, 0.8)]
    return placed(Scene(tuple(items), tuple(labels)), notation)


def _beside(start: Point, end: Point, name: str, side: int) -> Label:
    """The name of a vector beside its middle: at its left (1) or right (-1)."""
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    return Label(t.Vec(name), middle, direction(start, end) + side * math.pi / 2)


FIGURES = {"plane-motion": split_of_place}
