"""The figures of the notes: the drawing of the system and the free-body diagrams."""

from __future__ import annotations

from rbpsym.derivation.step import Derivation
from rbpsym.document.figures.describe import describe, describe_free_body
from rbpsym.document.figures.free_body import free_body
from rbpsym.document.figures.schematic import schematic
from rbpsym.document.figures.sketch import Sketch
from rbpsym.document.model import FigureBlock, Text
from rbpsym.document.sketches import sketch_of
from rbpsym.document.words import Words


def figure_label(said: Words) -> str:
    """The label of the drawing of the system."""
    return said.prefix + "figure.system"


def system_figure(derivation: Derivation, said: Words) -> FigureBlock:
    """The drawing of the whole system."""
    sketch = sketch_of(derivation)
    alt = describe(sketch, said.language, said.notation)
    return FigureBlock((schematic(sketch),), said.say("caption.schematic"), alt, figure_label(said))


def figure_with_forces(derivation: Derivation, said: Words) -> FigureBlock:
    """The system and, beside it, its only body alone with the forces on it."""
    sketch, system = sketch_of(derivation), system_figure(derivation, said)
    (name,) = (body.name for body in sketch.bodies)
    alt = f"{system.alt} {described(sketch, name, said)}"
    scenes = (*system.scenes, free_body(sketch, name, "", axes_too=False))
    return FigureBlock(scenes, said.say("caption.with_forces"), alt, system.label)


def has_single_body(derivation: Derivation) -> bool:
    """Is there one body, so that the forces on it can be drawn beside the system?"""
    return len(derivation.study.system.bodies) == 1 and bool(derivation.chapter("forces"))


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
