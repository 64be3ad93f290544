"""Writes docs/statement.md from the registries; `make docs` runs it, a test says whether it is up to date."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from rbpsym.quantities import DIMENSIONS
from rbpsym.statement.constraints import CONSTRAINTS
from rbpsym.statement.interactions import INTERACTIONS
from rbpsym.statement.kinds import Field, Kind
from rbpsym.statement.shapes import SHAPES

HERE = Path(__file__).parent


def page() -> str:
    """The whole reference."""
    intro = (HERE / "statement.intro.md").read_text(encoding="utf-8")
    parts = [intro.rstrip(), *_kinds("Shapes", SHAPES, "shape"), *_kinds("Interactions", INTERACTIONS, "type"),
             *_kinds("Constraints", CONSTRAINTS, "type"), *_dimensions()]
    return "\n".join(parts) + "\n"


def _kinds(title: str, kinds: Mapping[str, Kind], key: str) -> Iterator[str]:
    yield f"\n## {title}\n"
    yield f"Chosen by the key `{key}`.\n"
    for kind in kinds.values():
        yield from _kind(kind)


def _kind(kind: Kind) -> Iterator[str]:
    names = ", ".join(f"`{name}`" for name in (kind.name, *kind.aliases))
    yield f"### {names}\n"
    yield kind.meaning[0].upper() + kind.meaning[1:] + ".\n"
    if kind.fields:
        yield "| key | what it is | dimension | if absent |\n|---|---|---|---|"
        yield from (_row(field) for field in kind.fields)
        yield ""
    points = [name for name, *_ in getattr(kind, "points", ())]
    if points:
        yield "Points: " + ", ".join(f"`{name}`" for name in (*points, "cm")) + ".\n"
    if getattr(kind, "unknowns", ()):
        yield "Unknown: " + ", ".join(f"`{text.replace(chr(123) + 'name' + chr(125), 'NAME')}` ({dim})" for text, dim in kind.unknowns) + ".\n"


def _row(field: Field) -> str:
    choices = f" ({', '.join(field.choices)})" if field.choices else ""
    absent = "must be given" if field.default is None else "may be left out" if field.default == "" else f"`{field.default}`"
    dimension = "" if field.dimension is None else str(field.dimension)
    return f"| `{field.name}` | {field.meaning}{choices} | {dimension} | {absent} |".replace("{name}", "NAME")


def _dimensions() -> Iterator[str]:
    yield "\n## Dimensions\n"
    yield ", ".join(f"`{name}`" for name in DIMENSIONS) + "."


if __name__ == "__main__":
    (HERE / "statement.md").write_text(page(), encoding="utf-8")
