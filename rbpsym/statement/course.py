"""Course files: theory, problems and comparisons in the order in which they are taught."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class CoursePart:
    """One part of a course.

    kind: "theory" (name: which one), "problem" (name or file) or "comparison" (first and second
    problem, the coordinate, and the parameter that goes to zero in the limit, "" for none).
    """

    kind: str
    name: str = ""
    first: str = ""
    second: str = ""
    coordinate: str = ""
    limit: str = ""


@dataclass(frozen=True, slots=True)
class Course:
    """A course: titles by language, source, notation, and parts in order."""

    name: str
    title: Mapping[str, str]
    parts: tuple[CoursePart, ...]
    subtitle: Mapping[str, str] = field(default_factory=dict)
    source: str = ""
    notation: Mapping[str, str] = field(default_factory=dict)
    file: str = ""
