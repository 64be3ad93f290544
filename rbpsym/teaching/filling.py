"""Formulas into which each student's numbers are put: looked through once, then filled quickly."""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from dataclasses import fields

from rbpsym.notation import tree as t

Fill = Callable[[Mapping[str, t.Node]], t.Node]


def filler(node: t.Node, names: Container[str]) -> Fill | None:
    """Puts a tree for each of these names into a formula; None if none of them is in it.

    >>> from rbpsym.notation.tree import Num, Sym, Mul
    >>> filler(Mul((Sym("m"), Sym("g"))), {"g"})({"g": Num(10)}) == Mul((Sym("m"), Num(10)))
    True
    """
    if isinstance(node, t.Sym):
        return (lambda given, name=node.name: given[name]) if node.name in names else None
    parts = {name: _of_part(getattr(node, name), names) for name in _inner(node)}
    changing = {name: fill for name, fill in parts.items() if fill is not None}
    if not changing:
        return None
    kept = {name: getattr(node, name) for name in _inner(node) if name not in changing}
    kind = type(node)
    return lambda given: kind(**kept, **{name: fill(given) for name, fill in changing.items()})


def _inner(node: t.Node) -> list[str]:
    return [item.name for item in fields(node) if item.name != "span"]


def _of_part(value: object, names: Container[str]) -> Callable | None:
    if isinstance(value, t.Node):
        return filler(value, names)
    if not isinstance(value, tuple) or not value or not isinstance(value[0], t.Node):
        return None
    row = [(part, filler(part, names)) for part in value]
    if all(fill is None for _, fill in row):
        return None
    return lambda given: tuple([part if fill is None else fill(given) for part, fill in row])
