"""What an editor offers while a statement is written: sections, keys, kinds, dimensions and quantities, with their meanings."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from rbpsym.ask.question import CLAUSES
from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.events import STATED
from rbpsym.elements.impulses import IMPULSES
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import ElementKind, Field, ShapeKind
from rbpsym.elements.shapes import SHAPES
from rbpsym.quantities import DIMENSIONS
from rbpsym.quantity.phrases import PHRASES
from rbpsym.statement.loader import SECTIONS
from rbpsym.statement.phases import PHASE_KEYS

Words = Mapping[str, str]  # what can be written, and what it means
KINDS: Mapping[str, tuple[str, Mapping[str, ElementKind]]] = {
    "bodies": ("shape", SHAPES),
    "interactions": ("type", INTERACTIONS),
    "constraints": ("type", CONSTRAINTS),
    "impulses": ("type", IMPULSES),
}
COMMON: Mapping[str, Words] = {
    "bodies": {
        "shape": "its shape", "mass": "its mass", "angle": "of its axis, counter-clockwise from +x", "points": "further points",
        "meaning": "what it is", "center": "where the centre is",
    },
    "coordinates": {
        "meaning": "what it tells", "dimension": "length, angle …", "start": "where it is at t = 0",
        "speed": "its speed at t = 0", "range": "between what it stays", "glyph": "how it is printed",
    },
    "ask": {"question": "a quantity, and when or where it is asked for"},
    "phases": PHASE_KEYS,
}  # fmt: skip


def tables() -> dict[str, object]:
    """{sections: {name: meaning}; kinds: {section: {key, names: {kind: {meaning, keys, takes, points}}}}; keys: {section: {key:
    meaning}}; dimensions, events: {name: meaning}; quantities: [phrases]}."""
    return {
        "sections": SECTIONS,
        "kinds": {section: {"key": key, "names": dict(map(_kind, kinds.values()))} for section, (key, kinds) in KINDS.items()},
        "keys": COMMON,
        "dimensions": {name: str(dimension) for name, dimension in DIMENSIONS.items()},
        "events": {name: kind.meaning for name, kind in STATED.items()},
        "quantities": sorted({*_examples(PHRASES), *_examples(CLAUSES)}),
    }


def _kind(kind: ElementKind) -> tuple[str, dict[str, object]]:
    points = [*kind.point_names, "cm"] if isinstance(kind, ShapeKind) else []
    takes = {field.name: list(field.choices) or field.kind for field in kind.fields}
    return kind.name, {"meaning": kind.meaning, "keys": {f.name: _told(f) for f in kind.fields}, "takes": takes, "points": points}


def _told(field: Field) -> str:
    choices = f" ({', '.join(field.choices)})" if field.choices else ""
    return f"{field.meaning}{choices}{'' if field.default is None else '; may be left out'}"


def _examples(rows: Iterable[tuple[Any, ...]]) -> list[str]:
    """The examples of a table of phrases, which stand last in each row."""
    return [row[-1] for row in rows if isinstance(row[-1], str) and row[-1]]
