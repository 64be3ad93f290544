"""A sketch with all its lengths times a factor; angles and directions stay."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace

from rbpsym.document.figures.sketch import AngleMark, Sketch

LENGTHS = frozenset({"at", "start", "end", "radius", "c", "center_of_mass", "sizes", "parts", "points", "rims"})


def scaled(sketch: Sketch, factor: float) -> Sketch:
    """The sketch, larger or smaller."""
    lists = {item.name: getattr(sketch, item.name) for item in fields(sketch)}
    parts = {name: value for name, value in lists.items() if is_list_of_parts(value)}
    return replace(sketch, **{name: times(value, factor) for name, value in parts.items()})


def is_list_of_parts(value: object) -> bool:
    """Is it a tuple of bodies, points, marks, ...?"""
    return isinstance(value, tuple) and bool(value) and is_dataclass(value[0])


def scaled_part(part: object, factor: float) -> object:
    """A part with its lengths scaled; the ends of an angle are no lengths."""
    names = {"at", "reach", "ray"} if isinstance(part, AngleMark) else LENGTHS
    values = {item.name: getattr(part, item.name) for item in fields(part) if item.name in names}
    return replace(part, **{name: times(value, factor) for name, value in values.items()})


def times(value: object, factor: float) -> object:
    """A length, a point, sizes by name, a part or several of these, scaled."""
    if value is None:
        return None
    if isinstance(value, tuple):
        return tuple(times(item, factor) for item in value)
    if isinstance(value, Mapping):
        return {name: size * factor for name, size in value.items()}
    return scaled_part(value, factor) if is_dataclass(value) else value * factor
