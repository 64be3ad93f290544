"""What a wrong line of a student seems to mean: how it differs from a step that begins alike, and how much of it is right."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Space, Value, is_zero, names_in
from rbpsym.frozen import Frozen, replace

Valued = Callable[[t.Node], Value | None]


class LineSlip(Frozen):
    """The kind of a slip (a phrase “tutor.slip.KIND”), the part in which it is, how many of so many terms are right, and by
    what number the part is too large."""

    kind: str = ""
    part: t.Node | None = None
    right: int = 0
    terms: int = 0
    by: str = ""


def slip(wrong: t.Chain, steps: Iterable[t.Chain], value: Valued) -> LineSlip:
    """The first step beside which it is one; else the most terms that are right beside one."""
    best = LineSlip()
    rows = tuple(steps)
    alike = (operator.eq, lambda one, other: value(one) is not None and value(one) == value(other))
    for side, goal in (pair for is_same in alike for step in rows for pair in _beside(wrong, step, is_same)):
        given, true = value(side), value(goal)
        if true is None or given == true:
            continue
        if given is None or isinstance(given, Space) != isinstance(true, Space):
            found = _structural(side, goal)
        else:
            found = _told(side, goal, given, true, value)
        if found.kind and found.kind != "part":
            return found
        best = max(best, found, key=lambda one: (one.right, one.kind))
    return best


def _beside(wrong: t.Chain, step: t.Chain, is_same: Callable[[t.Node, t.Node], bool]) -> Iterator[tuple[t.Node, t.Node]]:
    """The side of the line that is not as in the step, with that of the step: where the other one is the same."""
    for this, other in ((0, -1), (-1, 0)):
        for its, goal in ((0, -1), (-1, 0)):
            if is_same(wrong.items[other], step.items[its]):
                yield wrong.items[this], step.items[goal]


def _told(side: t.Node, goal: t.Node, given: Any, true: Any, value: Valued) -> LineSlip:
    """How one side differs from what it should be."""
    if (ratio := _ratio(given, true)) is not None:
        return LineSlip("sign" if ratio == -1 else "times", side, by=str(ratio))
    terms, own = _terms(side), _terms(goal)
    values = [value(term) for term in terms]
    for term, its in zip(terms, values, strict=True):
        if its is not None and (kind := _of_term(given - true, its)):
            return LineSlip(kind, term)
    if any((its := value(term)) is not None and _ratio(true - given, its) == 1 for term in own):
        return LineSlip("missing", side)
    rights = [value(term) for term in own]
    odd = [term for term, its in zip(terms, values, strict=True) if its is None or its not in rights]
    wanted = [term for term, its in zip(own, rights, strict=True) if its is None or its not in values]
    count = len(terms) - len(odd)
    if len(odd) == len(wanted) == 1:
        return replace(_structural(odd[0], wanted[0], is_part=count > 0), right=count, terms=len(own))
    return LineSlip("", None, count, len(own))


def _structural(side: t.Node, goal: t.Node, *, is_part: bool = False) -> LineSlip:
    """The one place in which two formulas differ; the whole of what `is_part` of a sum, if there are several."""
    part, other = _apart(side, goal)
    kind = _kind(part, other)
    return LineSlip(kind, part) if part != side or kind != "part" or is_part else LineSlip()


def _apart(side: t.Node, goal: t.Node) -> tuple[t.Node, t.Node]:
    """The smallest parts in which two formulas differ, if it is one place."""
    own, others = tuple(t.children(side)), tuple(t.children(goal))
    if type(side) is type(goal) and len(own) == len(others):
        differing = [pair for pair in zip(own, others, strict=True) if pair[0] != pair[1]]
        if len(differing) == 1:
            return _apart(*differing[0])
    return side, goal


def _kind(part: t.Node, goal: t.Node) -> str:
    """What sort of change leads from one part to another."""
    if t.Neg(part) == goal or t.Neg(goal) == part:
        return "sign"
    if any(isinstance(one, t.Pow) and one.base in (part, goal) for one in (part, goal)):
        return "exponent"
    alike = {t.Fn: "function", t.Pow: "exponent", t.Num: "factor", t.Sym: "symbol"}
    return alike.get(type(part), "part") if type(part) is type(goal) else "part"


def _of_term(over: Value, its: Value) -> str:
    """What is wrong with a term by which the side is off."""
    ratio = _ratio(over, its)
    return "" if ratio is None else "sign" if ratio == 2 else "extra" if ratio == 1 else "factor"


def _ratio(one: Value, other: Value) -> int | Fraction | None:
    """The number by which they differ; None if it is none, or one of them vanishes."""
    if isinstance(one, Space) or isinstance(other, Space):
        pairs = zip(_parts(one), _parts(other), strict=True)
        ratios = {_ratio(a, b) for a, b in pairs if not (is_zero(a) and is_zero(b))}
        return ratios.pop() if len(ratios) == 1 else None
    return None if is_zero(one) or is_zero(other) else quotient(one, other)


def quotient(one: Scalar, other: Scalar) -> int | Fraction | None:
    """The number by which two values differ, if it is one."""
    return (one / other).number() if names_in(one) == names_in(other) else None


def _parts(value: Value) -> tuple[Scalar, ...]:
    return value.components() if isinstance(value, Space) else (value,) * 3


def _terms(node: t.Node) -> list[t.Node]:
    """The terms of a sum, also one after a sign."""
    if isinstance(node, t.Group):
        return _terms(node.arg)
    return list(node.terms) if isinstance(node, t.Add) else [node]
