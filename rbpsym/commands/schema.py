"""`rbpsym schema`: the JSON schema of problem files, from the registries of their kinds, for editors that know TOML."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import click

Schema = dict[str, Any]
TEXT: Schema = {"type": "string"}
VALUE: Schema = {"type": ["string", "number"]}
TWO: Schema = {"type": "array", "minItems": 2, "maxItems": 2}
PLACE: Schema = {"anyOf": [TWO, {"type": "string", "pattern": r"^[O-Z]$|\."}]}  # of one's own point
BODY: Mapping[str, Schema] = {"mass": VALUE, "angle": VALUE, "meaning": TEXT, "points": {"type": "object"}}
SHAPES: Mapping[str, Schema] = {  # what the kinds of fields look like in a file; others are text
    "expression": VALUE, "points": TWO, "two bodies": TWO, "vertices": {"type": "array", "minItems": 3, "items": TWO},
    **{kind: {} for kind in ("pair", "point", "line", "curve", "path", "parts", "bodies")},
}  # fmt: skip


def table(keys: Mapping[str, Schema], required: Iterable[str] = (), others: Schema | bool = False) -> Schema:
    """A table with these keys, and what others may be."""
    return {"type": "object", "properties": dict(keys), "required": list(required), "additionalProperties": others}


def named(rows: Schema) -> Schema:
    """A section of tables by name."""
    return {"type": "object", "additionalProperties": rows}


def schema() -> Schema:
    """The schema of a problem file."""
    from rbpsym.elements.events import STATED
    from rbpsym.statement.loader import SECTIONS
    from rbpsym.studio.completing import COMMON, KINDS

    sections = {name: {"description": meaning} for name, meaning in SECTIONS.items()}
    kinds = {section: named({"oneOf": list(_kinds(section))}) for section in KINDS}
    phase: Schema = {key: {"description": meaning} for key, meaning in COMMON["phases"].items()}
    phase |= {key: phase[key] | {"type": "object"} for key in ("constraints", "interactions")}  # may change a key alone
    phase["impulses"] |= kinds["impulses"]
    phase["event"] |= {"enum": list(STATED)}
    rows = {"type": "array", "items": table(phase, ("name",))}
    coordinate = {key: {"description": meaning} for key, meaning in COMMON["coordinates"].items()}
    coordinates = named({"anyOf": [TEXT, table(coordinate)]})
    special = {**kinds, "phases": rows, "coordinates": coordinates, "parameters": {"type": "object"}}
    sections = {name: shape | special.get(name, {}) for name, shape in sections.items()}
    sections |= {name: sections[name] | TEXT for name in ("name", "source")}
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "A problem of rbpsym", **table(sections)}


def _kinds(section: str) -> Iterable[Schema]:
    """The tables that an element of a section may be, one for each kind."""
    from rbpsym.elements.kinds import ShapeKind
    from rbpsym.statement.bodies import keys_of
    from rbpsym.studio.completing import COMMON, KINDS

    key, kinds = KINDS[section]
    for kind in kinds.values():
        fields = {field.name: {"description": field.meaning} | _shape(field) for field in kind.fields}
        head = {key: {"enum": [kind.name, *kind.aliases], "description": kind.meaning}}
        needed = [key, *(field.name for field in kind.fields if field.default is None)]
        if isinstance(kind, ShapeKind):
            places = (*COMMON["bodies"], *keys_of(kind), *kind.point_names, "cm")
            told = {name: {"description": COMMON["bodies"].get(name, "where this point is")} for name in places}
            fields = {name: shape | BODY.get(name, {}) for name, shape in told.items()} | fields
            yield table(fields | head, needed, PLACE)
        else:
            yield table(fields | head, needed)


def _shape(field: Any) -> Schema:
    return {"enum": list(field.choices)} if field.choices else dict(SHAPES.get(field.kind, TEXT))


@click.command("schema")
def command() -> None:
    """Print the JSON schema of problem files, for editors.

    \b
    Examples:
      rbpsym schema > rbpsym.schema.json
    and in the first line of a problem's file: #:schema ./rbpsym.schema.json
    """
    import json

    click.echo(json.dumps(schema(), indent=2, ensure_ascii=False))
