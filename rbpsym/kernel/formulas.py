"""The formulas that are written out in claims and proofs, and a short text of one."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.kernel.certificates import Multiples, Proof
from rbpsym.kernel.claim import Claim
from rbpsym.notation import tree as t
from rbpsym.notation.machine import to_machine


def sides(claim: Claim) -> Iterator[t.Node]:
    """The sides of a claim and of what it rests on."""
    yield from (claim.left, claim.right)
    for item in claim.given:
        yield from sides(item)


def _multiplied(multiples: Multiples) -> Iterator[t.Node]:
    for factor, known in multiples.known:
        yield from (factor, *sides(known.claim))
    yield from (factor for factor, _ in multiples.circles)


def formulas(proof: Proof) -> Iterator[t.Node]:
    """All that is written out in a proof."""
    yield from _multiplied(proof.multiples)
    if proof.like:
        yield proof.like[0]
        yield from _multiplied(proof.like[1])
    yield from (node for node in (proof.factor, *proof.parts) if node is not None)
    for have in proof.steps:
        if have.how not in ("sign", "gap"):
            yield from (have.of, *sides(have.claim), *_multiplied(have.multiples), *_multiplied(have.begin))


def brief(rest: t.Node) -> str:
    """A formula as text, cut to a line."""
    told = to_machine(rest)
    return told if len(told) < 80 else f"{told[:77]}…"

