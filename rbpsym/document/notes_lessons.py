"""Theory and comparisons as sections."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from rbpsym.claims.comparison import common_coordinate
from rbpsym.document.model import Block, FigureBlock, Inlines, Paragraph, Section
from rbpsym.document.phrases import plain
from rbpsym.document.telling import Teller
from rbpsym.document.words import Words
from rbpsym.errors import NotApplicable
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.pictures.figures.scene import Circle, Item, Label, Point, Polyline, Scene, direction, placed, polar
from rbpsym.proof.step import Derivation, Lesson, Step

# --- the figure of the general theory: a point of a body seen from the origin and from the centre of mass, r' = R + r


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
    items: list[Item] = [Polyline(outline, "body", closed=True)]
    items += [Polyline((ORIGIN, end), "axis", heads="end") for end in AXES.values()]
    items += [Polyline((start, end), style, heads="end") for start, end, _, style, _ in vectors]
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


# ---


def lesson_sections(lesson: Lesson, about: Derivation | None, language: str, prefix: str) -> list[Section]:
    """A section with the introduction of a lesson, and one below it for each of its headings."""
    problem = about.study.problem if about else None
    said = Words(language, problem, prefix, frozenset(step.id for step in lesson.steps))
    intro = (Paragraph(said.say(f"{lesson.kind}.intro")),) if said.has(f"{lesson.kind}.intro") else ()
    first, *parts = _parts(lesson, said)
    teller = Teller(said)
    blocks = (*intro, *_drawn(lesson, said), *teller.steps(first))
    top = Section(_title(lesson, said), blocks, f"{prefix}section.{lesson.kind}", 1)
    return [top, *(_part(steps, lesson, teller, said) for steps in parts)]


def _drawn(lesson: Lesson, said: Words) -> Iterator[Block]:
    """The figure of a theory."""
    if lesson.name in FIGURES:
        scene = FIGURES[lesson.name](said.notation)
        alt = plain("theory.figure.alt", said.language)
        yield FigureBlock((scene,), said.say("theory.figure.caption"), alt, f"{said.prefix}figure.{lesson.name}")


def compared_figure(first: Derivation, second: Derivation, coordinate: str, said: Words) -> Iterator[Block]:
    """Both motions in one plot, where both can be followed."""
    from rbpsym.document.notes_plots import numbers, panels_figure  # with numpy, which is slow to load
    from rbpsym.pictures.plots.subjects import beside, motions

    name = common_coordinate((first.study, second.study), coordinate)
    try:
        pair = motions(first, second)
        panels = list(beside(pair, name))
    except NotApplicable:
        return
    titles: dict[str, Any] = {key: said.title(one.study.problem.title) for key, one in (("first", first), ("second", second))}
    yield panels_figure("compared", panels, said.say("comparison.figure", **titles), said)
    yield Paragraph(numbers(pair[0], said))


def _title(lesson: Lesson, said: Words) -> Inlines:
    if lesson.kind == "comparison":
        first, second = (said.title(lesson.slots[name]) for name in ("first", "second"))
        return said.say("comparison.title", first=first, second=second)
    return said.say(f"section.{lesson.kind}")


def _heading(lesson: Lesson, step: Step) -> str:
    return f"{lesson.kind}.heading.{step.id}"


def _parts(lesson: Lesson, said: Words) -> list[list[Step]]:
    """The steps, cut before each that has a heading; the first part is what has none."""
    found: list[list[Step]] = [[]]
    for step in lesson.steps:
        if said.has(_heading(lesson, step)):
            found.append([])
        found[-1].append(step)
    return found


def _part(steps: list[Step], lesson: Lesson, teller: Teller, said: Words) -> Section:
    blocks: Iterator[Block] = teller.steps(steps)
    return Section(said.say(_heading(lesson, steps[0])), tuple(blocks), f"{said.prefix}section.{steps[0].id}", 2)
