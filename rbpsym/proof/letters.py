"""Which letters stand in a formula, and by what each has its meaning: a step or a fact."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.proof.context import Context
from rbpsym.proof.facts import definition
from rbpsym.proof.step import Step


def introduce(context: Context, step: Step) -> None:
    """Notes which letters the step introduces; one that stands in it and was never introduced is a fact of its own, and so is
    a work of which the step says what it comes to, and not along which path."""
    for row in t.chains(step.statement):
        first = row.items[0]
        is_said = not isinstance(first, t.Sym) or first.name not in context.works or isinstance(row.items[1], t.PathIntegral)
        if isinstance(first, (t.Sym, t.Vec)) and row.ops[0] == "=" and is_said and _is_letter(context, first):
            context.introduced.setdefault(first.name, (step.id, _said(context, row)))
    for name in letters(context, step.statement):
        if name not in context.introduced:
            fact = definition(name)
            context.facts[fact.id] = fact
            context.introduced[name] = (fact.id, None)


def _said(context: Context, row: t.Chain) -> t.Node | None:
    """What a chain says of its letter: None if it ends in what holds no further letter."""
    plain = [item for item in row.items[1:] if not letters(context, item)]
    return None if plain else row.items[-1]


def letters(context: Context, node: t.Node) -> list[str]:
    """Names in a formula that have a meaning of their own (an unknown force has none: its vector has)."""
    return sorted({part.name for part in context.parts(node, t.Sym, t.Vec) if _is_letter(context, part)})


def _is_letter(context: Context, part: Any) -> bool:
    if isinstance(part, t.Vec):
        return part.name in context.vectors
    if part.name in context.scalars or part.name in context.works:
        return True
    return part.name in context.vectors and part.name not in context.whole.system.unknowns


def introducers(context: Context, statements: Iterable[t.Node]) -> list[str]:
    """Ids of what introduced the letters in these, and those in what is said of them."""
    return list(dict.fromkeys(id for node in statements for id in _introducers(context, node)))


def _introducers(context: Context, node: t.Node) -> tuple[str, ...]:
    key = ("introducers", id(node), len(context.introduced))  # what is introduced stays
    if key not in context.rows:
        found: dict[str, None] = {}
        left = letters(context, node)
        while left:
            made_by, said = context.introduced.get(left.pop(), ("", None))
            if made_by and made_by not in found:
                found[made_by] = None
                left += [] if said is None else letters(context, said)
        context.rows[key] = (node, tuple(found))  # with the node, whose address is its name
    made: tuple[str, ...] = context.rows[key][1]
    return made


def fixed(context: Context) -> frozenset[str]:
    """The facts about starts and shapes, which no letter names."""
    if "fixed" not in context.rows:
        found = (id for id, fact in context.facts.items() if fact.kind in ("start", "shape"))
        context.rows["fixed"] = frozenset(found)
    known: frozenset[str] = context.rows["fixed"]
    return known
