"""Sines and cosines that the known ranges of their angles keep positive."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import NOTHING, PI, Scalar
from rbpsym.kernel.claim import Claim
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
