"""What a step says, as values that vanish, seen with what its reader knows of the letters in it."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Space, Value
from rbpsym.proof.context import Context
from rbpsym.proof.step import Step


def _pairs(step: Step) -> Iterator[tuple[t.Node, t.Node]]:
    for left, op, right in t.relations(step.statement):
        if op == "=":
            yield left, right


def _components(found: Value) -> tuple[Scalar, ...]:
    return found.components() if isinstance(found, Space) else (found,)


def _values(view: Context, step: Step) -> Iterator[Scalar]:
    """left - right of each equation that has values."""
    for left, right in _pairs(step):
        if not view.grows(left) and not view.grows(right):
            a, b = view.value(left), view.value(right)
            if isinstance(a, Space) == isinstance(b, Space):
                yield from (x - y for x, y in zip(_components(a), _components(b), strict=True))


def _growths(view: Context, step: Step) -> Iterator[Scalar]:
    """left - right of the rates, where both are integrals along the motion or changes."""
    for left, right in _pairs(step):
        if view.grows(left) or view.grows(right):
            yield view.rate(left) - view.rate(right)


def _constants(view: Context, step: Step) -> Iterator[Scalar]:
    """What is conserved: its rate vanishes, and it is what it was at the start."""
    if step.rule == "conservation":
        kept = step.data["value"]
        yield view.rate_of(kept)
        yield kept - view.start(kept)


READERS = (_values, _growths, _constants)
