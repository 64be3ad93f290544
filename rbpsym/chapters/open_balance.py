"""A position of rest that no formula gives: its equation, why there is only one, the small motion about it."""

from __future__ import annotations

from typing import Any

from rbpsym.expr import tree as t
from rbpsym.field import Scalar, root, substitute, symbol
from rbpsym.mechanics.rest import AtRest
from rbpsym.proof.draft import Draft


def write(draft: Draft, item: AtRest) -> None:
    """The balance of the forces, how many places there are, stability, and the frequency."""
    draft.define(item.place, symbol(item.place))
    _balance(draft, item)
    if item.stable is None:
        return
    _slope(draft, item)
    if item.ends:
        _ends(draft, item)
    if item.frequency_squared is not None:
        _small_motion(draft, item, item.frequency_squared)
    elif item.decay is not None:
        _dying_motion(draft, item, *item.decay)


def _balance(draft: Draft, item: AtRest) -> None:
    there = substitute(item.force, {item.name: symbol(item.place)})
    draft.add(
        "balance",
        "open_balance",
        _apart(draft.show(there)),
        "oscillations.open.rest",
        premises=draft.those(f"motion.{item.name}"),
        is_result=item.stable is not None,
        name=t.Sym(item.name),
        place=t.Sym(item.place),
        variant="one" if item.stable is not None else "other" if draft.study.equilibria else "any",
        data={"balance": item},
    )


def _apart(shown: t.Node) -> t.Node:
    """What vanishes as two sums that are equal, without the factors that all terms share."""
    factors = shown.factors if isinstance(shown, t.Mul) else (shown,)
    shared = next((f for f in factors if isinstance(_bare(f), t.Add)), shown)
    bare = _bare(shared)
    terms = bare.terms if isinstance(bare, t.Add) else (shown,)
    taken = [term.arg for term in terms if isinstance(term, t.Neg)]
    kept = [term for term in terms if not isinstance(term, t.Neg)]
    return t.equation(t.add(*taken), t.add(*kept)) if taken and kept else t.equation(shown, t.ZERO)


def _bare(node: t.Node) -> t.Node:
    return node.arg if isinstance(node, t.Group | t.Neg) else node


def _slope(draft: Draft, item: AtRest) -> None:
    """The force falls or grows throughout: there is at most one place."""
    force = draft.show(item.force)
    rate = t.Deriv(t.Group(force) if isinstance(force, t.Add) else force, item.name)
    relation = "<" if item.stable else ">"
    draft.add(
        "balance_slope",
        "inequality",
        t.Chain((rate, draft.show(item.slope), t.ZERO), ("=", relation)),
        "oscillations.open.stable" if item.stable else "oscillations.open.unstable",
        premises=["balance"],
        name=t.Sym(item.name),
        variant="some" if item.ends else "most",
    )


def _ends(draft: Draft, item: AtRest) -> None:
    """The force at the ends of the range has opposite signs."""
    coordinate = draft.study.problem.coordinate(item.name)
    named = {"lower": coordinate.lower, "upper": coordinate.upper}
    ends: dict[str, Any] = {side: t.equation(t.Sym(item.name), end) for side, end in named.items() if end is not None}
    rows = [_at_end(draft, end, item.stable is (k == 0)) for k, end in enumerate(item.ends)]
    draft.add(
        "balance_ends",
        "open_ends",
        t.Relations(tuple(rows)),
        "oscillations.open.ends",
        premises=["balance"],
        name=t.Sym(item.name),
        variant="stable" if item.stable else "unstable",
        data={"balance": item},
        **ends,
    )


def _at_end(draft: Draft, value: Scalar, is_positive: bool) -> t.Node:
    return t.relation(draft.show(value), ">" if is_positive else "<", t.ZERO)


def _dying_motion(draft: Draft, item: AtRest, square: Scalar, loss: Scalar) -> None:
    away, speed = t.Group(t.add(t.Sym(item.name), t.neg(t.Sym(item.place)))), t.Sym(f"{item.name}_dot")
    pull, drag = t.mul(draft.show(square, factor=True), away), t.mul(draft.show(loss, factor=True), speed)
    draft.add(
        "open_linear",
        "open_linear",
        t.relation(t.Sym(f"{item.name}_ddot"), "~", t.add(t.neg(pull), t.neg(drag))),
        "oscillations.open.damped",
        premises=["balance", *draft.those(f"motion.{item.name}")],
        is_result=True,
        place=t.Sym(item.place),
        data={"balance": item},
    )


def _small_motion(draft: Draft, item: AtRest, square: Scalar) -> None:
    letter = t.Sym(draft.free("vartheta"))
    draft.context.scalars[letter.name] = root(square)
    away = t.Group(t.add(t.Sym(item.name), t.neg(t.Sym(item.place))))
    draft.add(
        "open_linear",
        "open_linear",
        t.relation(t.Sym(f"{item.name}_ddot"), "~", t.neg(t.mul(t.Pow(letter, t.TWO), away))),
        "oscillations.open.linear",
        premises=["balance", *draft.those(f"motion.{item.name}")],
        place=t.Sym(item.place),
        letter=letter,
        data={"balance": item},
    )
    draft.add(
        "open_frequency",
        "identity",
        t.equation(t.Pow(letter, t.TWO), draft.show(square, factor=True)),
        "oscillations.open.frequency",
        premises=["open_linear"],
        is_result=True,
        letter=letter,
    )
