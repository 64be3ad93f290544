"""Steps that are spoilt on purpose, from a seed: a changed sign or factor, a premise or a range that is left out.

A wrong claim is tried with its old proof, and each spoilt step with whatever proof the search finds for it then.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from random import Random

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.kernel.certificates import Lemma
from rbpsym.kernel.certify import Written, declared, granted, lemma_of, text
from rbpsym.kernel.claim import Proposition
from rbpsym.kernel.coqc import with_prelude
from rbpsym.kernel.rocq import REFUSED, identifier

Attempt = list[Lemma]  # as one: it has come through if each of them is accepted


def _turned(claim: Proposition) -> Proposition:
    """The other sign on the right; what is more becomes less."""
    if claim.kind in ("more", "least"):
        return replace(claim, left=claim.right, right=claim.left)
    return replace(claim, right=t.neg(claim.right))


def _doubled(claim: Proposition) -> Proposition:
    """A factor on the right."""
    if claim.kind in ("more", "least"):
        return replace(claim, right=t.Add((claim.left, t.ONE)))
    return replace(claim, right=t.Mul((t.TWO, claim.right)))


def _moved(claim: Proposition) -> Proposition:
    """One more on the right."""
    return replace(claim, right=t.add(claim.right, t.ONE))


WRONG = {"sign": _turned, "factor": _doubled}


def _vanishes(whole: Written, lemma: Lemma, id: str) -> bool:
    """Whether both sides are 0, so that neither sign nor factor changes what is said: by the premises, as it is."""
    claim = lemma.claim
    if claim.kind in ("more", "least") or t.ZERO in (claim.left, claim.right):
        return claim.kind not in ("more", "least")
    nothing = replace(lemma, name=f"{lemma.name}'zero", claim=replace(claim, left=t.ZERO, right=claim.right, kind="equal"))
    return any(_proved(whole, [nothing], id, ""))


def spoilt(whole: Written, id: str, kind: str, chance: Random) -> list[Attempt] | None:
    """What there is to try of a step that is spoilt in one way; None where there is nothing to spoil."""
    step, lemmas, gone = whole.source.steps[id], [each for each in whole.lemmas[id] if not _is_idle(each)], ""
    if kind in WRONG and lemmas:
        lemma = chance.choice(lemmas)
        wrong = _moved if _vanishes(whole, lemma, id) else WRONG[kind]
        lemmas = [replace(lemma, name=f"{lemma.name}'{kind}", claim=wrong(lemma.claim))]
        return [lemmas, *_proved(whole, lemmas, id, "")]
    used = [premise for premise in step.premises if premise not in whole.unused.get(id, ())]
    listed = [premise for premise in used if premise.startswith("range.") == (kind == "range")]
    if kind in WRONG or not lemmas or not listed:
        return None
    gone = chance.choice(listed)
    return [*_proved(whole, [replace(each, name=f"{each.name}'{kind}") for each in lemmas], id, f"{identifier(gone)}'")]


def _proved(whole: Written, lemmas: list[Lemma], id: str, gone: str) -> Iterator[Attempt]:
    """The claims of some lemmas as the search proves them, if it proves each; without the premise that is gone."""
    known = (granted(whole.source, whole.source.steps[id]), declared(whole.source))
    claims, further = ({n: c for n, c in each.items() if not gone or not n.startswith(gone)} for each in known)
    try:
        found = [lemma_of(whole, f"{each.name}'again", each.claim, (), (claims, further)) for each in lemmas]
    except (RbpsymError, ZeroDivisionError):
        return
    if all(made.claim.given == each.claim.given for made, each in zip(found, lemmas, strict=True)):
        yield found


def draws(whole: Written, seed: int, count: int) -> list[list[Attempt]]:
    """What there is to try of so many spoilt steps, each another one or spoilt in another way."""
    chance = Random(seed)
    every = [(id, kind) for id in whole.lemmas for kind in (*WRONG, "premise", "range")]
    chance.shuffle(every)
    found = (spoilt(whole, id, kind, chance) for id, kind in every)
    return [attempts for attempts, _ in zip((each for each in found if each is not None), range(count), strict=False)]


def come_through(whole: Written, spoilt_steps: list[list[Attempt]]) -> list[str]:
    """Names of what coqc accepts, none of which should be."""
    attempts = [attempt for attempts in spoilt_steps for attempt in attempts]
    tried = {lemma.name: [lemma] for attempt in attempts for lemma in attempt}
    told = with_prelude([text(Written(whole.source, lemmas=tried), trial=True)])[0]
    assert not told.returncode, told.stderr[-400:]
    refused = set(re.findall(rf"^{REFUSED}(\S+)", told.stdout, re.MULTILINE))
    return [attempt[0].name for attempt in attempts if not {lemma.name for lemma in attempt} & refused]


def _is_idle(lemma: Lemma) -> bool:
    """0 = 0 stays true with another sign or factor."""
    return lemma.claim.left == lemma.claim.right == t.ZERO
