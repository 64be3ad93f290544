"""What is assumed beside a claim: premises, each solved for one quantity, and the conditions of its display."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.present import present
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.algebra.vector import Space
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.points import names_of
from rbpsym.equality.signs import sign
from rbpsym.errors import RbpsymError, ReadError
from rbpsym.notation import tree as t
from rbpsym.notation.text import to_text
from rbpsym.verify.claims_ground import Ground, Question
from rbpsym.verify.claims_integrals import valued
from rbpsym.verify.claims_model import Link, Outcome, Printed

# what a value may not be, by the declared sign of its name
CONTRADICTS = {
    "positive": frozenset(("zero", "negative", "nonpositive")),
    "nonnegative": frozenset(("negative",)),
    "nonzero": frozenset(("zero",)),
}
OPEN = ("<", ">")  # relations that may hold within an interval and not at its ends
Decide = Callable[[t.Chain, Ground], Link]


def relations(node: t.Node) -> Iterator[t.Chain]:
    """The single relations that a chain or a system asserts."""
    if isinstance(node, t.System):
        for row in node.rows:
            yield from relations(row)
    elif isinstance(node, t.Chain):
        for left, op, right in zip(node.items, node.ops, node.items[1:], strict=False):
            yield t.Chain((left, right), (op,))


def premises(given: Iterable[tuple[Printed, t.Node]], ground: Ground) -> dict[str, Scalar]:
    """What the given relations make of one quantity each, in their order.

    A work that is given to be zero has the power zero. Raises ReadError for what can't be solved for one quantity,
    or only so that it contradicts a declared sign.
    """
    found: dict[str, Scalar] = {}
    for printed, relation in ((printed, relation) for printed, node in given for relation in relations(node)):
        try:
            name, value = _solved(relation, ground, found)
        except RbpsymError as error:
            raise ReadError(error.what, instead=error.instead, place=printed.place) from None
        found = {known: substitute(old, {name: value}) for known, old in found.items()} | {name: value}
    return found


def _solved(relation: t.Chain, ground: Ground, found: dict[str, Scalar]) -> tuple[str, Scalar]:
    """(the quantity that a given relation is solved for, its value): one that stands in it, before any other."""
    question, declared = Question(ground), ground.motion.assumptions
    left, right = (valued(side, ground) for side in relation.items)
    if relation.ops != ("=",) or isinstance(left, Space) or isinstance(right, Space):
        raise ReadError("only an equation between numbers can be given")
    gap = left - right
    moving = any(depends_on(gap, name) for name in (*ground.motion.ledger, *ground.motion.starts))
    gap = substitute(question.seen(question.rate(gap) if moving else gap, "motion"), found)
    alone = [ground.generator(side.name) for side in relation.items if isinstance(side, t.Sym)]
    printed = sorted(filter(None, (ground.generator(name) for name in t.names(relation))))
    refused = ""
    for name in dict.fromkeys((*alone, *printed, *names_of([gap]))):
        if name is None or name in ground.motion.scope.rates or name.endswith(("_dot", "_ddot")):
            continue
        slope = derivative(gap, name)
        if not slope or depends_on(slope, name):
            continue
        value = -(substitute(gap, {name: NOTHING}) / slope)
        is_limit = name in alone and not value  # m = 0, said of a mass, is a limit
        kind = sign(value, declared).kind
        if is_limit or kind not in CONTRADICTS.get(declared.sign_of(name), ()):
            return name, value
        refused = refused or f"this makes {to_text(t.Sym(name))} {kind}, which is declared {declared.sign_of(name)}"
    raise ReadError(refused or "what is given can't be solved for one quantity")


def told(ground: Ground) -> str:
    """What each premise was solved for, in words."""
    pairs = ((t.Sym(name.strip()), present(value)) for name, value in ground.premises.items())
    return " and ".join(f"given {to_text(t.equation(*pair))}" for pair in pairs)


def under(conditions: tuple[t.Node, ...], ground: Ground) -> Callable[[t.Chain, Decide], Link]:
    """Decides a relation as it stands; if it does not hold so, then where the conditions of its display hold."""
    links = [link for node in conditions for link in relations(node)]
    said = ", ".join(to_text(node) for node in conditions)
    narrowed, closed = _narrowed(links, ground), any(op in ("<=", ">=") for link in links for op in link.ops)

    def decided(relation: t.Chain, decide: Decide) -> Link:
        found = decide(relation, ground)
        if not links or found.outcome not in (Outcome.REFUTED, Outcome.UNDECIDED):
            return found
        found = decide(relation, narrowed) if narrowed else found
        ends = found.outcome is Outcome.PROVED and closed and relation.ops[0] in OPEN
        if narrowed is None or ends:
            return replace(found, outcome=Outcome.UNDECIDED, detail=f"it is not decided where {said}")
        return replace(found, how=f"{found.how} where {said}") if found.how else found

    return decided


def _narrowed(links: list[t.Chain], ground: Ground) -> Ground | None:
    """The ground with the ranges that inequalities give to its names; None if one of them gives none."""
    given = ground.motion.assumptions
    for link in links:
        (left, right), [op] = link.items, link.ops
        low, high = (left, right) if op in ("<", "<=") else (right, left)
        given = op in ("<", "<=", ">", ">=") and given and _bounded(low, high, ground, given)
    return replace(ground, assumed=given) if given else None


def _bounded(low: t.Node, high: t.Node, ground: Ground, given: Assumptions) -> Assumptions | None:
    for node, bound, end in ((low, high, 1), (high, low, 0)):
        name = ground.generator(node.name) if isinstance(node, t.Sym) and node.name != "pi" else None
        value = valued(bound, ground)
        if name is None or isinstance(value, Space) or names_of([value]):
            continue
        ends = list(given.range_of(name))
        gain = NOTHING if ends[end] is None else (ends[end] - value) * (1 if end else -1)
        kind = "positive" if ends[end] is None else sign(gain).kind
        if kind is None:
            return None
        ends[end] = value if kind == "positive" else ends[end]
        return given.with_range(name, *ends)
    return None
