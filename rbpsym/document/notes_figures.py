"""The figures of the notes: the drawing of the system and the free-body diagrams, and what is seen in each, in words."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from rbpsym.decide.signs import sign
from rbpsym.document.model import FigureBlock, Inlines, Text
from rbpsym.document.phrases import has_phrase, plain
from rbpsym.document.words import Words, sentences
from rbpsym.expr.glyphs import DEFAULT, Notation, renamed, spaced
from rbpsym.field import cosine, sine
from rbpsym.pictures.figures import sketch as sk
from rbpsym.pictures.figures.outlines import turned
from rbpsym.pictures.figures.scene import Point
from rbpsym.pictures.figures.schematic import free_body, schematic
from rbpsym.pictures.figures.sketch import Sketch
from rbpsym.pictures.sketches import sketch_of
from rbpsym.proof.step import Derivation
from rbpsym.typeset.text import plain_letters

# --- what is seen in a figure, in words: the alt text of schematics and free-body diagrams


def describe(sketch: sk.Sketch, language: str = "en", notation: Notation = DEFAULT) -> str:
    """The alt text of the schematic."""
    return sentence("figure.picture", list(seen(sketch, language, notation)), language)


def describe_free_body(
    sketch: sk.Sketch, body_name: str, language: str = "en", notation: Notation = DEFAULT, body: str = ""
) -> str:
    """The alt text of a free-body diagram; `body` is what the body is called in a sentence."""
    parts = [force_words(f, language, notation) for f in sketch.forces if f.body == body_name]
    parts += [couple_words(c, language, notation) for c in sketch.couples if c.body == body_name]
    parts = parts or [plain("figure.no_force", language)]
    body = body or spaced(renamed(body_name, notation.names))
    return sentence("figure.free_body", parts, language, body=body)


def sentence(key: str, parts: list[str], language: str, **slots: str) -> str:
    """The sentence with its list; it ends by naming the positive sense of rotation."""
    positive = plain("figure.positive", language)
    return plain(key, language, parts=[part.strip() for part in parts], positive=positive, **slots)


def seen(sketch: sk.Sketch, language: str, notation: Notation) -> Iterator[str]:
    """The parts of a system, one after the other."""
    yield from (body_words(body, language, notation) for body in sketch.bodies)
    yield from (point_words(point, language, notation) for point in sketch.points)
    marks: list[tuple[str, Any]] = [(f"part.{line_kind(line)}", line) for line in sketch.lines]
    marks += [(f"circle.{circle.kind}", circle) for circle in sketch.circles]
    joining: list[Any] = [*sketch.links, *sketch.coils, *sketch.cords]
    marks += [(f"part.{mark.kind}", mark) for mark in joining]
    marks += [("part.angle", mark) for mark in sketch.angles]
    marks += [("part.length", mark) for mark in (*sketch.lengths, *sketch.radii)]
    marks += [(f"arrow.{arrow.kind}", arrow) for arrow in sketch.arrows]
    yield from (plain(f"figure.{key}", language, name=named(mark.label, notation)) for key, mark in marks)


def named(label: sk.Caption, notation: Notation) -> str:
    """The label as text, "" for none."""
    return "" if label is None else label if isinstance(label, str) else plain_letters(label, notation)


def place(point: Point, language: str = "en", notation: Notation = DEFAULT) -> str:
    """A place with one decimal."""
    x, y = (f"{value + 0.0:.1f}".replace("-0.0", "0.0").replace("-", "−") for value in point)
    mark = notation.decimal
    return plain("figure.place", language, x=x.replace(".", mark), y=y.replace(".", mark))


def body_words(body: sk.SketchBody, language: str, notation: Notation) -> str:
    """A body by its kind, name (if that says more) and place."""
    key = f"figure.shape.{body.kind}"
    half = body.sizes.get("length", 0.0) / 2
    name = spaced(renamed(body.name, notation.names))
    known = f"index.{body.kind}"
    is_plain = has_phrase(known, language) and plain(known, language) == name
    places = {
        "center": body.center,
        "start": turned((-half, 0.0), body.at, body.angle),
        "end": turned((half, 0.0), body.at, body.angle),
    }
    return plain(
        key if has_phrase(key, language) else "figure.shape.outline",
        language,
        variant="plain" if is_plain else "named",
        name=name,
        **{key: place(point, language, notation) for key, point in places.items()},
    )


def point_words(point: sk.SketchPoint, language: str, notation: Notation) -> str:
    """A point by what it does."""
    return plain(f"figure.point.{point.kind}", language, name=named(point.label, notation))


def line_kind(line: sk.SketchLine) -> str:
    """A horizontal line is a floor, a vertical one a wall, one that only leads a point a rail."""
    if line.kind == "rail":
        return "rail"
    return "floor" if abs(line.a) < 1e-9 else "wall" if abs(line.b) < 1e-9 else "line"


SIDES = ("right", "up", "left", "down")


def force_words(force: sk.SketchForce, language: str, notation: Notation) -> str:
    """A force by its name and where it points."""
    quarters = math.atan2(force.direction[1], force.direction[0]) / (math.pi / 2)
    straight = abs(quarters - round(quarters)) < 1e-6
    side = "open" if force.is_open else SIDES[round(quarters) % 4] if straight else "slanted"
    return plain("figure.part.force", language, variant=side, name=named(force.label, notation))


def couple_words(couple: sk.SketchCouple, language: str, notation: Notation) -> str:
    """A couple by its name and sense."""
    side = "open" if couple.is_open else "counter_clockwise" if couple.sign > 0 else "clockwise"
    return plain("figure.part.couple", language, variant=side, name=named(couple.label, notation))


# ---


def figure_label(said: Words) -> str:
    """The label of the drawing of the system."""
    return said.prefix + "figure.system"


def system_figure(derivation: Derivation, said: Words) -> FigureBlock:
    """The drawing of the whole system."""
    sketch = sketch_of(derivation)
    alt = describe(sketch, said.language, said.notation)
    return FigureBlock((schematic(sketch),), _caption("schematic", derivation, said), alt, figure_label(said))


def _caption(name: str, derivation: Derivation, said: Words) -> Inlines:
    """What is drawn; and how ends are called, where the motion may turn a rod upside down."""
    study = derivation.study
    angles = [s.pose.angle for n, s in study.system.bodies.items() if study.problem.body(n).shape.kind == "rod"]
    kept = all(any(sign(wave(a), study.assumptions).is_nonzero for wave in (sine, cosine)) for a in angles)
    return sentences([said.say(f"caption.{name}"), *(() if kept else (said.say("caption.ends"),))])


def figure_with_forces(derivation: Derivation, said: Words) -> FigureBlock:
    """The system and, beside it, its only body alone with the forces on it."""
    sketch, system = sketch_of(derivation), system_figure(derivation, said)
    (name,) = (body.name for body in sketch.bodies)
    alt = f"{system.alt} {described(sketch, name, said)}"
    scenes = (*system.scenes, free_body(sketch, name, "", axes_too=False))
    return FigureBlock(scenes, _caption("with_forces", derivation, said), alt, system.label)


def has_single_body(derivation: Derivation) -> bool:
    """Is there one body, so that the forces on it can be drawn beside the system?"""
    return len(derivation.study.system.bodies) == 1 and bool(derivation.chapter("forces"))


def is_drawn_beside(derivation: Derivation, said: Words) -> bool:
    """Do the forces on the only body stand beside the system? In full notes they have a figure of their own."""
    return said.is_posed and not said.is_full and has_single_body(derivation)


def described(sketch: Sketch, name: str, said: Words) -> str:
    """The alt text of the free-body diagram of a body."""
    called = "".join(part.text for part in said.the(name) if isinstance(part, Text))
    return describe_free_body(sketch, name, said.language, said.notation, called)


def free_bodies_label(said: Words) -> str:
    """The label of the free-body diagrams."""
    return said.prefix + "figure.free"


def free_bodies_figure(derivation: Derivation, said: Words) -> FigureBlock:
    """Each body alone with the forces on it; the axes are drawn once."""
    sketch = sketch_of(derivation)
    names = [body.name for body in sketch.bodies]
    alt = " ".join(described(sketch, name, said) for name in names)
    scenes = tuple(
        free_body(sketch, name, said.body(name) if len(names) > 1 else "", axes_too=name == names[-1]) for name in names
    )
    return FigureBlock(scenes, said.say("caption.free_bodies", count=len(names)), alt, free_bodies_label(said))
