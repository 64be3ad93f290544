"""From a sketch to the free-body diagram of one body: every force at its point."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from rbpsym.pictures.figures import marks
from rbpsym.pictures.figures.dimensions import DOWN, labelled
from rbpsym.pictures.figures.outlines import body_outline
from rbpsym.pictures.figures.placing import placed
from rbpsym.pictures.figures.scene import Label, Point, Scene, box_of, points_of, polar
from rbpsym.pictures.figures.schematic import axes
from rbpsym.pictures.figures.sketch import Sketch, SketchBody, SketchCouple, SketchForce, scaled

SIZE = 3.2  # the greatest extent of the body, in cm
SHARES = {"rod": 1.0, "composite": 0.75, "rectangle": 0.6, "triangle": 0.6}  # of SIZE; others are round
LENGTH = 1.0  # of each force arrow


def free_body(sketch: Sketch, body_name: str, name: str | None = None, axes_too: bool = True) -> Scene:
    """One body alone, with the forces and couples on it.

    `name` is what stands under it (its own name if None, nothing if ""); the axes with the
    positive sense are drawn if `axes_too`.
    """
    sketch = scaled(sketch, factor(sketch.body(body_name)))
    body = sketch.body(body_name)
    scene = Scene((*body_outline(body), *marks.dot(body.center)))
    scene += sum(map(force_scene, spread([force for force in sketch.forces if force.body == body_name])), Scene())
    scene += sum((couple_scene(couple) for couple in sketch.couples if couple.body == body_name), Scene())
    shown = body.name if name is None else name
    under = heading(scene, shown) if shown else Scene()
    return scene + (sense(scene) if axes_too else Scene()) + under


def factor(body: SketchBody) -> float:
    """What brings a body to the size of a diagram."""
    found = tuple(point for item in body_outline(body) for point in points_of(item))
    left, bottom, right, top = box_of(found)
    extent = max(right - left, top - bottom)
    return SIZE * SHARES.get(body.kind, 0.42) / extent if extent > 1e-9 else 1.0


def spread(forces: list[SketchForce]) -> Iterator[SketchForce]:
    """Forces with the same point and direction stand a little beside each other."""
    seen: list[tuple[Point, float]] = []
    for force in forces:
        angle = math.atan2(force.direction[1], force.direction[0])
        same = sum(math.dist(force.at, at) < 0.05 and abs(angle - a) < 0.05 for at, a in seen)
        seen.append((force.at, angle))
        yield replace(force, at=polar(force.at, 0.22 * same, angle - math.pi / 2))


def force_scene(force: SketchForce) -> Scene:
    """An arrow that starts at the point where the force acts."""
    angle = math.atan2(force.direction[1], force.direction[0])
    tip = polar(force.at, LENGTH, angle)
    items = (*marks.dot(force.at), marks.arrow(force.at, tip))
    return Scene(items, labelled(force.label, tip, angle, gap=0.06, color="force"))


def couple_scene(couple: SketchCouple) -> Scene:
    """An open circle with a head."""
    arc = marks.turning(couple.at, couple.sign, 0.45, "couple")
    target = polar(couple.at, 0.45, math.pi / 2)
    return Scene((arc,), labelled(couple.label, target, math.pi / 2, gap=0.12, color="force"))


def heading(scene: Scene, name: str) -> Scene:
    """The name of the body, under it."""
    left, bottom, right, _ = placed(scene).bounds
    return Scene((), (Label(name, ((left + right) / 2, bottom - 0.05), DOWN, 0.05),))


def sense(scene: Scene) -> Scene:
    """The positive senses, at the lower right."""
    _, bottom, right, _ = scene.bounds
    return axes((right + 0.7, bottom + 0.1))
