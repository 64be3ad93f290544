"""What antiderivatives give: integrals between fixed ends, and letters as functions of the time."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from rbpsym.errors import Undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, names_in, reduce_roots, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.field.integration import antiderivative
from rbpsym.kernel.certificates import Have, KnownEquation
from rbpsym.kernel.claim import Proposition, tree_of
from rbpsym.kernel.claims import TIME

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search


def integrated(search: Search) -> list[KnownEquation]:
    """The values of the integrals that were met."""
    found = []
    for node in [*search.integrals.values()]:
        if node.var not in (*search.source.rates, TIME) and node in search.met:
            have = _integral(node)
            found.append(search.note("integral", have.claim, of=have.of, inner=have.inner, parts=have.parts))
    return found


def _integral(node: t.Integral) -> Have:
    """The value of an integral; of one inside first."""
    inner = _integral(node.integrand) if isinstance(node.integrand, t.Integral) else None
    integrand = node.integrand if inner is None else inner.claim.right
    primitive = antiderivative(scalar(integrand), node.var)
    if primitive is None:
        raise Undecided("no closed form of an integral was found")
    ends = [substitute(primitive, {node.var: scalar(end)}) for end in (node.upper, node.lower)]
    plain = (tree_of(reduce_roots(scalar(integrand).num)),) if any(isinstance(part, t.Sqrt) for part in t.walk(integrand)) else ()
    return Have("", "integral", Proposition(node, tree_of(ends[0] - ends[1])), tree_of(primitive), inner=inner, parts=plain)


def courses(search: Search, known: Sequence[KnownEquation]) -> list[KnownEquation]:
    """What each is at any time, from its start; what has a rate without a closed form is left out."""
    found: dict[str, KnownEquation] = {}
    free = [item for item in known if item.is_free]
    names = [name for name in search.rates if name != TIME and name not in search.integrals]
    for name in (*names, *names):  # speeds first, then what they move
        if name not in found:
            with suppress(Undecided):
                found[name] = _course(search, name, [*free, *found.values()])
    search.fixed -= found.keys()
    return [*found.values()]


def _course(search: Search, name: str, known: Sequence[KnownEquation]) -> KnownEquation:
    """A letter less its start and what its rate gives does not change."""
    rate, _ = search.follow(search.rates[name], known)
    way = None if any(map(search.moving, names_in(rate) - {TIME})) else antiderivative(rate, TIME)
    if way is None:
        raise Undecided("its rate is no function of the time")
    begun = [KnownEquation(item.name, item.claim, "0") for item in known if item.name in search.given]
    start, _ = search.follow(search.at_start(symbol(name)), begun)
    search.by_rates(symbol(name) - start - way + substitute(way, {TIME: NOTHING}), known)
    have = search.haves[-1]
    return KnownEquation(have.name, have.claim)
