"""Integrals between fixed ends, each by an antiderivative."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rbpsym.algebra import reduce_roots, substitute
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.integration import antiderivative
from rbpsym.errors import Undecided
from rbpsym.kernel.certificates import Have, Known
from rbpsym.kernel.claim import Claim, tree_of
from rbpsym.kernel.claims import TIME
from rbpsym.notation import tree as t

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search


def integrated(search: Search) -> list[Known]:
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
    return Have("", "integral", Claim(node, tree_of(ends[0] - ends[1])), tree_of(primitive), inner=inner, parts=plain)
