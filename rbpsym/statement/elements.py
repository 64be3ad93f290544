"""Interactions and constraints, read by the fields of their kinds."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping

from rbpsym.elements.kinds import ElementKind, Field, K, known_names
from rbpsym.frozen import Frozen, replace
from rbpsym.statement.model import Body, Element
from rbpsym.statement.paths import read_path
from rbpsym.statement.references import GROUND, check_name, check_name_item, read_body, read_curve, read_line, read_point
from rbpsym.statement.scope import Scope, read_expression, read_pair
from rbpsym.statement.source import SourceItem, SourceTable, did_you_mean, kind_of


class Surroundings(Frozen):
    """What a field may refer to; where masses `are_unstated`, contacts and strings hold to both sides."""

    scope: Scope
    bodies: Mapping[str, Body]
    are_unstated: bool = False


def read_elements(
    section: str, table: SourceTable, kinds: Mapping[str, ElementKind], around: Surroundings
) -> tuple[Element, ...]:
    """All elements of the section [interactions] or [constraints]."""
    return tuple(read_element(part, name, kinds, around) for name, part in table.tables(section, section))


def read_element(table: SourceTable, name: str, kinds: Mapping[str, ElementKind], around: Surroundings) -> Element:
    """One element: its kind, then the fields of the kind, then what the kind makes of them together."""
    check_name(name, table)
    kind = kind_of_element(table, kinds, "type")
    where = f"{kind.name} “{name}”"
    table = _in_own_words(table, [field.name for field in kind.fields])
    table.check_keys(["type", *(field.name for field in kind.fields)], where)
    values = {field.name: _field(field, table, name, where, around) for field in kind.fields}
    values |= {"held": True} if around.are_unstated else {}
    element = Element(name, kind.name, values, table.source.key(table.path))
    for rule in kind.rules:
        element = rule(element, around.scope, around.bodies) or element  # most rules only refuse
    return element


# other words for keys, where the kind has none of that name
OTHER_WORDS: Mapping[str, tuple[str, ...]] = {
    "on": ("bodies", "body", "point"), "bodies": ("on",), "body": ("on", "point"), "point": ("on",),
    "points": ("between", "path"), "between": ("points", "path"), "joins": ("points", "between"),
    "mu": ("coefficient", "limit"), "friction_coefficient": ("coefficient", "limit"), "e": ("restitution",),
    "k": ("stiffness",), "constant": ("stiffness", "coefficient"), "c": ("coefficient",), "damping": ("coefficient",),
    "rest_length": ("natural_length",), "unstretched": ("natural_length",), "torque": ("couple",), "moment": ("couple",),
    "distance": ("length",), "position": ("distance",), "surface": ("line",), "direction": ("along",),
}  # fmt: skip


def _in_own_words(table: SourceTable, fields: Collection[str]) -> SourceTable:
    """The table with the kind's own keys for others that mean the same; a list of bodies where one is named."""
    data = dict(table.data)
    for key in table.data.keys() & OTHER_WORDS.keys() - {*fields}:
        own = next((word for word in OTHER_WORDS[key] if word in fields and word not in data), None)
        if own is not None:
            value = data.pop(key)
            data[own] = [value] if own == "bodies" and isinstance(value, str) and value != "all" else value
    return replace(table, data=data)


def kind_of_element(table: SourceTable, kinds: Mapping[str, K], key: str) -> K:
    """The kind that the table names under `key`."""
    known = known_names(kinds)
    where = ".".join(str(part) for part in table.path)
    table.require(key, where, f"{key}s: {', '.join(kinds)}.")
    word = table.string(key)
    if word not in known:
        raise table.value_error(key, f"unknown {key} “{word}”", did_you_mean(word, known, f"{key}s"))
    return kinds[known[word]]


def _field(field: Field, table: SourceTable, name: str, where: str, around: Surroundings) -> object:
    if field.name not in table and field.default is None:
        table.require(field.name, where, f"{field.name}: {field.meaning}.")
    default = field.default.format(name=name) if isinstance(field.default, str) else field.default
    item = table.item(field.name, default)
    if field.name not in table and item.value == "":
        return None
    return _READERS[field.kind](item, field, f"“{field.name}” of {where}", around)


def _two(item: SourceItem, what: str, things: str, example: str) -> list[SourceItem]:
    value = item.value
    if not isinstance(value, (list, tuple)) or len(value) != 2:
        found = f"{len(value)}" if isinstance(value, (list, tuple)) else kind_of(value)
        raise item.error(f"{what} must name two {things}, not {found}", example)
    return item.items()


def _points(item: SourceItem, field: Field, what: str, around: Surroundings) -> object:
    parts = _two(item, what, "points", f'write {field.name} = ["rod.end", "disk.center"]')
    return tuple(read_point(part, around.scope, around.bodies, what) for part in parts)


def _two_bodies(item: SourceItem, field: Field, what: str, around: Surroundings) -> object:
    parts = _two(item, what, "bodies", f'write {field.name} = ["ground", "rod"]')
    return tuple(read_body(part, around.bodies, what, (GROUND,)) for part in parts)


def _bodies(item: SourceItem, field: Field, what: str, around: Surroundings) -> object:
    if item.value == "all":
        return tuple(around.bodies)
    if not isinstance(item.value, (list, tuple)) or not item.value:
        raise item.error(f"{what} must be a list of bodies or “all”", f'write {field.name} = ["rod", "disk"]')
    return tuple(read_body(part, around.bodies, what) for part in item.items())


def _choice(item: SourceItem, field: Field, what: str, around: Surroundings) -> object:
    if item.value not in field.choices:
        found = f"“{item.value}”" if isinstance(item.value, str) else kind_of(item.value)
        raise item.error(
            f"{what} must be one of {', '.join(field.choices)}, not {found}",
            did_you_mean(str(item.value), field.choices),
        )
    return item.value


_Reader = Callable[[SourceItem, Field, str, Surroundings], object]

_READERS: dict[str, _Reader] = {
    "expression": lambda item, field, what, around: read_expression(
        item, around.scope.with_variables(dict(field.variables)), what, field.dimension, field.may_use, field.sign
    ),
    "pair": lambda item, field, what, around: read_pair(item, around.scope, what, field.dimension, field.may_use),
    "point": lambda item, field, what, around: read_point(item, around.scope, around.bodies, what),
    "points": _points,
    "line": lambda item, field, what, around: read_line(item, around.scope, what),
    "curve": lambda item, field, what, around: read_curve(item, around.scope, what),
    "body": lambda item, field, what, around: read_body(item, around.bodies, what),
    "two bodies": _two_bodies,
    "bodies": _bodies,
    "choice": _choice,
    "name": lambda item, field, what, around: check_name_item(item, what),
    "constraint": lambda item, field, what, around: check_name_item(item, what),
    "path": lambda item, field, what, around: read_path(item, around.scope, around.bodies, what),
}
