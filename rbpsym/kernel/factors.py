"""Equations by a factor that does not vanish: a multiple of left - right is shown to be 0."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.algebra import NOTHING, UNITY, Scalar, generator, names_in, substitute, symbol
from rbpsym.errors import Undecided
from rbpsym.kernel.certificates import Known, Proof, parted, reduced
from rbpsym.kernel.combining import stays, surely
from rbpsym.kernel.radicals import rootless
from rbpsym.kernel.ranges import signed
from rbpsym.notation import tree as t

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search


def cancelled(search: Search, goal: Scalar, known: Sequence[Known]) -> Proof:
    """A multiple of left - right vanishes, by a factor that does not."""
    values = [search.difference(item.claim, item.when) for item in known]
    rest, sums, rows = reduced(goal, values, search.order(), search.is_nonzero)
    for row in rows:
        factor = search.ratio(row.value, rest)
        if factor is not None and search.is_nonzero(factor):
            whole = {place: -factor * part for place, part in sums.items()}
            whole |= {place: whole.get(place, NOTHING) + part for place, part in row.multiples.items()}
            shown = t.mul(*map(search.tree, parted(factor)))
            return search.proof(search.summed(factor * goal, whole, known, values), factor=shown)
    raise Undecided("what stands beside it may vanish")


def cancelled_rates(search: Search, goal: Scalar, known: Sequence[Known]) -> Proof:
    """The same with the rates of what vanishes."""
    return cancelled(search, goal, [*known, *search.stills(known)])


def multiplied(search: Search, goal: Scalar, known: Sequence[Known]) -> Proof:
    """left - right times what holds letters below it vanishes, and that does not."""
    order = search.order()
    below = {generator(i): -e for i, e in goal.num.content()[1] if e < 0 and order(i)}
    below |= {goal.den: 1} if any(map(order, goal.den.atoms())) else {}
    factor = UNITY
    for part, exponent in below.items():
        factor = factor * Scalar(part) ** exponent
        if not (stays(search, Scalar(part)) or surely(search, Scalar(part), known)):
            raise Undecided("what stands below may vanish")
    if not below:
        raise Undecided("nothing stands below")
    return search.proof(search.shown(goal * factor, known), factor=search.tree(factor))


def conjugated(search: Search, goal: Scalar, known: Sequence[Known]) -> Proof:
    """left - right is linear in a root: times the same with the other root it vanishes, and that does not."""
    rest = search.follow(goal, known)[0]
    for name in sorted(names_in(rest) & search.roots.keys()):
        other = parted(substitute(rest, {name: -symbol(name)}))[1]
        if name not in names_in(rootless(search, rest * other)[0]) and signed(search, Scalar(other.num)) is not None:
            whole, taken = rootless(search, goal * other)
            found = search.shown(whole, known)
            more = tuple((search.tree(factor), item) for factor, item in taken)
            return search.proof(replace(found, known=(*found.known, *more)), factor=search.tree(other))
    raise Undecided("no other root")
