"""What the places of a statement ask for, before it is read: their dimensions, by the fields of the kinds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.impulses import IMPULSES
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import ElementKind, ShapeKind, known_names
from rbpsym.elements.shapes import DENSITY_DIMENSIONS, SHAPES
from rbpsym.frozen import Frozen, field
from rbpsym.quantities import LENGTH, MASS, NUMBER, TIME, Dimension
from rbpsym.statement.bodies import VARIABLE_DIMENSIONS
from rbpsym.statement.model import Element, Problem

ALL: Mapping[str, ElementKind] = {**SHAPES, **INTERACTIONS, **CONSTRAINTS, **IMPULSES}
KINDS = {word: ALL[name] for word, name in known_names(ALL).items()}
USUAL = {"mass": MASS, "angle": NUMBER}  # of keys that are no fields of a kind; the others are places
AXES = {"x": LENGTH, "y": LENGTH}
QUANTITIES = ("coordinates", "parameters")


def drawn_as(problem: Problem, *marks: str) -> list[Element]:
    """The constraints, then the interactions, that are drawn with one of these marks."""
    return [element for element in (*problem.constraints, *problem.interactions) if ALL[element.kind].drawn in marks]


class Slot(Frozen):
    """What a place asks for: a dimension (times that of the quantity `of`), and the variables that only it has."""

    dimension: Dimension = LENGTH
    of: str = ""
    variables: Mapping[str, Dimension] = field(default_factory=dict)


def slot_of(table: Mapping[Any, Any], path: tuple[str, ...], key: str) -> Slot:
    """What the key of a table asks for; `path` is where the table stands."""
    kind = KINDS.get(str(table.get("shape", table.get("type"))))
    fields = {each.name: each for each in kind.fields} if kind else {}
    if len(path) == 2 and path[0] in QUANTITIES:
        return Slot(TIME**-1 if key == "speed" else NUMBER, path[1])
    if path == ("phases",) and key == "at":
        return Slot(NUMBER, str(table.get("of")))
    if key == "density" and isinstance(kind, ShapeKind) and kind.element:
        return Slot(DENSITY_DIMENSIONS[kind.element.kind], variables=VARIABLE_DIMENSIONS)
    if key in fields:
        return Slot(fields[key].dimension or LENGTH, variables=AXES if fields[key].kind == "line" else {})
    return Slot(USUAL.get(key, LENGTH))
