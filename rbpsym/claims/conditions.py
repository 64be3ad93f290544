"""Conditions of a display: where it is said to hold, and what stands before an arrow that is true in some states only."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from rbpsym.claims.ground import Ground
from rbpsym.claims.integrals import valued
from rbpsym.claims.model import Link, Outcome
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.points import names_of
from rbpsym.decide.signs import sign
from rbpsym.expr import tree as t
from rbpsym.field import Space
from rbpsym.frozen import replace
from rbpsym.typeset.text import to_text

ORDERS = ("<", "<=", ">", ">=")
Nodes = tuple[t.Node, ...]


def relations(node: t.Node) -> Iterator[t.Chain]:
    """The single relations that a chain or a system asserts."""
    return (t.relation(*one) for one in t.relations(node))


def asserted(node: t.Node, conditions: Nodes = (), sources: Nodes = ()) -> Iterator[tuple[t.Chain, Nodes, list[t.Chain]]]:
    """The single relations, each with the conditions under which it is said to hold, and those from which it is to follow."""
    if isinstance(node, t.Relations):
        for row in node.rows:
            yield from asserted(row, (*conditions, *node.conditions), (*sources, *node.sources))
    else:
        yield from ((link, conditions, [one for node in sources for one in relations(node)]) for link in relations(node))


def under(conditions: Nodes, relation: t.Chain, ground: Ground, decide: Callable[[t.Chain, Ground], Link]) -> Link:
    """A relation decided as it stands; if it does not hold so, then where the conditions of its display hold: at the place
    that an equation names, within the range that inequalities leave, to first order in what is small."""
    found, links = decide(relation, ground), [link for node in conditions for link in relations(node)]
    if not links or found.outcome not in (Outcome.REFUTED, Outcome.UNDECIDED):
        return found
    said = ", ".join(to_text(node) for node in conditions)
    places = [link for link in links if _is_place(link, ground)]
    small = [link for link in links if link.ops == ("->",) and link.items[1] == t.ZERO and relation.ops == ("~",)]
    narrowed = _narrowed([link for link in links if link not in (*places, *small)], ground)
    unknown = replace(found, outcome=Outcome.UNDECIDED, how="", detail=f"it is not decided where {said}")
    if narrowed is None:
        return unknown
    if places:
        there = places[0] if len(places) == 1 else t.Relations(tuple(places))
        relation = t.relation(t.At(relation.items[0], there), relation.ops[0], t.At(relation.items[1], there))
    found = decide(relation, replace(narrowed, small=tuple(filter(None, (_named(link, ground) for link in small)))))
    given = {name for place in places if (name := _named(place, ground))}
    if found.outcome is Outcome.REFUTED and {name.removesuffix("_dot") for name in given} - given:
        return unknown  # where the motion has that speed is not known
    return replace(found, how=f"{found.how} where {said}") if found.how else found


def _named(link: t.Chain, ground: Ground) -> str | None:
    """The generator for which the symbol on its left stands."""
    left = link.items[0]
    return ground.generator(left.name) if isinstance(left, t.Sym) else None


def _is_place(link: t.Chain, ground: Ground) -> bool:
    """Whether it gives a value to a coordinate, a speed, the time or a parameter, which a formula is a function of."""
    name = _named(link, ground) if link.ops == ("=",) else None
    return name is not None and name not in ground.motion.unsettled


def is_state(link: t.Chain, ground: Ground) -> bool:
    """Whether it holds in some states and says nothing of a law: what a function of the state is there, a range, what vanishes or
    is small."""
    (left, right), [op] = link.items, link.ops
    if op != "=" or (right == t.ZERO and isinstance(left, t.Sym)):
        return op in (*ORDERS, "=", "->")
    lawful = {*ground.motion.ledger, *ground.motion.unsettled, "t", None}
    names, fixed = ({ground.generator(name) for name in t.names(side)} for side in (left, right))
    is_rate = any(isinstance(part, t.Deriv) for part in t.walk(left))
    return not is_rate and names.isdisjoint(lawful) and fixed.isdisjoint({*lawful, *ground.motion.scope.start})


def _narrowed(links: list[t.Chain], ground: Ground) -> Ground | None:
    """The ground with the ranges that inequalities give to its names; None if one of them gives none."""
    given: Assumptions | None = ground.motion.assumptions
    for link in links:
        (left, right), [op] = link.items, link.ops
        low, high = (left, right) if op in ("<", "<=") else (right, left)
        given = _bounded(low, high, ground, given, op in ("<=", ">=")) if given and op in ORDERS else None
    return replace(ground, assumed=given) if given else None


def _bounded(low: t.Node, high: t.Node, ground: Ground, given: Assumptions, closed: bool) -> Assumptions | None:
    for node, bound, end in ((low, high, 1), (high, low, 0)):
        name = ground.generator(node.name) if isinstance(node, t.Sym) and node.name != "pi" else None
        value = valued(bound, ground)
        if name is None or isinstance(value, Space) or names_of([value]):
            continue
        lower, upper = ends = given.range_of(name)
        kind = "positive" if (old := ends[end]) is None else sign((old - value) * (1 if end else -1)).kind
        if kind is None:
            return None
        if kind == "positive":
            lower, upper = (lower, value) if end else (value, upper)
        if lower is not None and upper is not None and sign(upper - lower, given).kind != "positive":
            return None  # no state is there, and of none anything could be said
        sides = given.sides_of(name)
        keeps = closed if kind == "positive" else end in sides and (closed or kind != "zero")
        return given.with_range(name, lower, upper, (sides - {end}) | ({end} if keeps else set()))
    return None
