"""Integrals between fixed ends, each by an antiderivative."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rbpsym.algebra import substitute
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
            inner, integrand = None, node.integrand
            if isinstance(integrand, t.Integral):
                inner = _integral(integrand, integrand.integrand)
                integrand = inner.claim.right
            have = _integral(node, integrand)
            found.append(search.note("integral", have.claim, of=have.of, inner=inner))
    return found


def _integral(node: t.Integral, integrand: t.Node) -> Have:
    primitive = antiderivative(scalar(integrand), node.var)
    if primitive is None:
        raise Undecided("no closed form of an integral was found")
    ends = [substitute(primitive, {node.var: scalar(end)}) for end in (node.upper, node.lower)]
    return Have("", "integral", Claim(node, tree_of(ends[0] - ends[1])), tree_of(primitive))
