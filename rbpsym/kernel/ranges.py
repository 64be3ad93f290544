"""Signs: sines and cosines that the known ranges of their angles keep positive, and what is more than something else."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from rbpsym.algebra import NOTHING, PI, Scalar, generator
from rbpsym.algebra.evaluate import scalar
from rbpsym.errors import Undecided
from rbpsym.kernel.certificates import Known, Multiples, partner, wound
from rbpsym.kernel.claim import Claim
from rbpsym.kernel.formulas import brief
from rbpsym.notation import tree as t

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search

QUARTERS = (("sin", NOTHING, PI), ("cos", PI * Fraction(-1, 2), PI * Fraction(1, 2)))


def _is_least(value: Scalar) -> bool:
    """Whether a multiple of π is not negative."""
    found = (value / PI).number()
    return found is not None and found >= 0


def note_signs(search: Search, *, signed: bool) -> None:
    """Sines and cosines that ranges keep positive; only if signs are spoken of, and their ranges are premises, is
    divided by them on the way."""
    ranges = {name: claim for name, claim in search.given.items() if claim.kind == "more"}
    for name in sorted({n for claim in ranges.values() for n in t.names(claim.left) | t.names(claim.right)} - {"pi"}):
        own = t.Sym(name)
        low = {scalar(claim.right): id for id, claim in ranges.items() if claim.left == own}
        high = {scalar(claim.left): id for id, claim in ranges.items() if claim.right == own}
        for kind, lowest, highest in QUARTERS:
            below = next((id for end, id in low.items() if _is_least(end - lowest)), None)
            above = next((id for end, id in high.items() if _is_least(highest - end)), None)
            if below and above:
                wave = t.Fn(kind, own)
                search.note("sign", Claim(wave, t.ZERO, "more"), source=f"{below} {above}")
                search.certain |= search.value(wave).atoms()
                if signed and (not search.moving(name) or not {below, above} & search.declared):
                    search.positive |= search.value(wave).atoms()


def above(search: Search, goal: Scalar, known: Sequence[Known]) -> tuple[Multiples, tuple[t.Node, t.Node, t.Node]]:
    """left - right is something positive, or that and a positive multiple of a square: the multiples, and a, s, p of a s² + p."""
    rest, _ = search.follow(goal, known)
    rest = wound(rest, "cos")
    if search.is_positive(rest):
        return search.follow(goal - rest, known)[1], (t.ONE, t.ZERO, search.tree(rest))
    for index in sorted(filter(partner, rest.num.atoms())):
        parts = {power: Scalar(part, rest.den) for power, part in rest.num.by_power(index).items()}
        if set(parts) <= {0, 1, 2} and 2 in parts and search.is_positive(parts[2]):
            a, b, c = (parts.get(power, NOTHING) for power in (2, 1, 0))
            left = wound(c - b * b / (a * 4))
            if search.is_positive(left):
                root = Scalar(generator(index)) + b / (a * 2)
                _, found = search.follow(goal - a * root * root - left, known)
                return found, (search.tree(a), search.tree(root), search.tree(left))
    raise Undecided("no square was found that leaves something positive of " + brief(search.tree(rest)))
