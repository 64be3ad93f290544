"""Course files: theory, problems and comparisons in the order in which they are taught."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path

from rbpsym.errors import Place, ReadError, StatementError
from rbpsym.notation.glyphs import MARKS


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


PART_KEYS = {
    "theory": ("theory",),
    "problem": ("problem",),
    "comparison": ("comparison", "coordinate", "limit"),
}
KEYS = ("title", "subtitle", "source", "notation", "part")


def load_course(file: Path) -> Course:
    """A course from a TOML file. Raises ReadError or StatementError with the place of what is wrong."""
    text = file.read_text(encoding="utf-8")
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ReadError(f"{file.name} is not valid TOML: {error}", place=Place(str(file))) from None
    _known_keys(data, KEYS, file)
    if not data.get("part"):
        raise StatementError(
            "the course has no parts", instead='add [[part]] with problem = "..."', place=Place(str(file))
        )
    _known_marks(data.get("notation", {}), file)
    parts = tuple(_part(item, file) for item in data["part"])
    return Course(
        file.stem,
        _titles(data.get("title", "")),
        parts,
        _titles(data.get("subtitle", "")),
        str(data.get("source", "")),
        dict(data.get("notation", {})),
        str(file),
    )


def _titles(value: object) -> Mapping[str, str]:
    return dict(value) if isinstance(value, dict) else {"en": str(value)}


def _known_marks(notation: Mapping[str, object], file: Path) -> None:
    for key, allowed in MARKS.items():
        if notation.get(key, allowed[0]) not in allowed:
            ways = " or ".join(f'"{way}"' for way in allowed)
            said = f"{key} cannot be “{notation[key]}”"
            raise StatementError(said, instead=f"write {key} = {ways}.", place=Place(str(file)))


def _known_keys(data: Mapping[str, object], known: tuple[str, ...], file: Path) -> None:
    for key in data:
        if key not in known:
            near = get_close_matches(key, known, n=1)
            hint = f"did you mean “{near[0]}”?" if near else "known: " + ", ".join(known) + "."
            raise StatementError(f"unknown key “{key}” in a course", instead=hint, place=Place(str(file)))


def _part(item: Mapping[str, object], file: Path) -> CoursePart:
    kind = next((kind for kind in PART_KEYS if kind in item), None)
    if kind is None:
        raise StatementError(
            "a part of a course is a theory, a problem or a comparison",
            instead='write problem = "...", theory = "..." or comparison = ["...", "..."].',
            place=Place(str(file)),
        )
    _known_keys(item, PART_KEYS[kind], file)
    if kind != "comparison":
        return CoursePart(kind, str(item[kind]))
    pair = item["comparison"]
    if not isinstance(pair, list) or len(pair) != 2:
        raise StatementError(
            "a comparison takes two problems", instead='write comparison = ["first", "second"].', place=Place(str(file))
        )
    return CoursePart(kind, "", str(pair[0]), str(pair[1]), str(item.get("coordinate", "")), str(item.get("limit", "")))
