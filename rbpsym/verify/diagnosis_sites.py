"""Places in a formula, and formulas with one place changed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, replace

from rbpsym.notation import tree as t

Path = tuple[tuple[str, int | None], ...]


def sites(node: t.Node, path: Path = ()) -> Iterator[tuple[Path, t.Node]]:
    """All parts of a formula with the way to them, the whole first."""
    yield path, node
    for item in fields(node):
        value = getattr(node, item.name)
        if isinstance(value, t.Node):
            yield from sites(value, (*path, (item.name, None)))
        elif isinstance(value, tuple) and item.name != "span":
            for place, part in enumerate(value):
                if isinstance(part, t.Node):
                    yield from sites(part, (*path, (item.name, place)))


def put(node: t.Node, path: Path, new: t.Node) -> t.Node:
    """The formula with another part at the end of the path."""
    if not path:
        return new
    (name, place), rest = path[0], path[1:]
    old = getattr(node, name)
    if place is None:
        return replace(node, **{name: put(old, rest, new)})
    parts = list(old)
    parts[place] = put(parts[place], rest, new)
    return replace(node, **{name: tuple(parts)})


def terms(relation: t.Chain) -> Iterator[tuple[Path, t.Node]]:
    """The terms of all sums and the sides themselves, the right side first: what can have a sign or be left out."""
    for path, node in sorted(sites(relation), key=lambda item: item[0][:1] != (("items", 1),)):
        if path and (path[-1][0] in ("terms", "items")) and node != t.ZERO:
            yield path, node


def is_in_exponent(path: Path) -> bool:
    """Does the place stand in an exponent, or in the limits of an integral?"""
    return any(name in ("exponent", "lower", "upper", "to", "condition") for name, _ in path)
