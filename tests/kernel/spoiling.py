"""Lemmas that are spoilt on purpose, from a seed: a changed sign, factor or premise, or a range that is left out."""

from __future__ import annotations

from dataclasses import replace
from random import Random

from rbpsym.expr import tree as t
from rbpsym.kernel.certificates import Lemma
from rbpsym.kernel.certify import Written, text
from rbpsym.kernel.claim import Proposition


def _turned(claim: Proposition) -> Proposition:
    """The other sign on the right; what is more becomes less."""
    if claim.kind in ("more", "least"):
        return replace(claim, left=claim.right, right=claim.left)
    return replace(claim, right=t.add(t.neg(claim.right), t.ONE) if claim.right == t.ZERO else t.neg(claim.right))


def _doubled(claim: Proposition) -> Proposition:
    """A factor on the right; one more where nothing stands there."""
    if claim.kind in ("more", "least"):
        return replace(claim, right=t.Add((claim.left, t.ONE)))
    return replace(claim, right=t.ONE if claim.right == t.ZERO else t.Mul((t.TWO, claim.right)))


def spoilt(lemma: Lemma, kind: str, chance: Random) -> Lemma | None:
    """The lemma spoilt in one way; None where there is nothing to spoil."""
    name = f"{lemma.name}'{kind}"
    if kind in ("sign", "factor"):
        wrong = (_turned if kind == "sign" else _doubled)(lemma.claim)
        return replace(lemma, name=name, claim=wrong)
    ranges = [id for id in lemma.premises if id.startswith("range'")]
    wanted = ranges if kind == "range" else [id for id in lemma.premises if id not in ranges]
    if not wanted:
        return None
    gone = chance.choice(wanted)
    return replace(lemma, name=name, premises={id: claim for id, claim in lemma.premises.items() if id != gone})


def draws(whole: Written, seed: int, count: int) -> list[Lemma]:
    """So many spoilt lemmas of a derivation, each of another lemma or in another way."""
    chance = Random(seed)
    lemmas = [lemma for each in whole.lemmas.values() for lemma in each if not _is_idle(lemma)]
    every = [(lemma, kind) for lemma in lemmas for kind in ("sign", "factor", "premise", "range")]
    chance.shuffle(every)
    found = (spoilt(lemma, kind, chance) for lemma, kind in every)
    return [lemma for lemma in found if lemma is not None][:count]


def _is_idle(lemma: Lemma) -> bool:
    """0 = 0 stays true with another sign or factor."""
    return lemma.claim.left == lemma.claim.right == t.ZERO


def attempted(whole: Written, lemmas: list[Lemma]) -> str:
    """The source that tries each of them; what is not accepted says so."""
    return text(Written(whole.source, lemmas={lemma.name: [lemma] for lemma in lemmas}), trial=True)
