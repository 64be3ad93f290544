"""What lies on what in a drawing whose labels have their places."""

from __future__ import annotations

from rbpsym.pictures.figures.scene import Label, Scene, crosses, overlap, strokes_of


def collisions(scene: Scene) -> list[tuple[Label, object]]:
    """Pairs of a label and another label or a stroke that lies on it."""
    strokes = tuple(strokes_of(scene))
    found: list[tuple[Label, object]] = []
    for place, label in enumerate(scene.labels):
        found += [(label, other) for other in scene.labels[:place] if overlap(label.box, other.box)]
        found += [(label, stroke) for stroke in strokes if crosses(stroke, label.box)]
    return found
