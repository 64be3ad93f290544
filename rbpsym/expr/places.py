"""Parts of a formula and the ways to them; another part put in the place of one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, replace
from typing import Any

from rbpsym.expr.tree import Node

Path = tuple[tuple[str, int | None], ...]  # the fields of the nodes, with the place where a field is a row


def sites(node: Node, path: Path = ()) -> Iterator[tuple[Path, Node]]:
    """All parts of a formula with the way to them, the whole first."""
    yield path, node
    for item in fields(node):
        value = getattr(node, item.name)
        if isinstance(value, Node):
            yield from sites(value, (*path, (item.name, None)))
        elif isinstance(value, tuple) and item.name != "span":
            for place, part in enumerate(value):
                if isinstance(part, Node):
                    yield from sites(part, (*path, (item.name, place)))


def put(node: Node, path: Path, new: Node) -> Any:
    """The formula with another part at the end of the path; of the kind of the whole, if the path leads into it."""
    if not path:
        return new
    (name, place), rest = path[0], path[1:]
    old = getattr(node, name)
    if place is None:
        return replace(node, **{name: put(old, rest, new)})
    return replace(node, **{name: (*old[:place], put(old[place], rest, new), *old[place + 1 :])})
