"""Certificates: how a claim follows from others, neutral of any prover; whether it is so, a prover says."""

from __future__ import annotations

from dataclasses import dataclass, field

from rbpsym.kernel.claims import Claim
from rbpsym.notation import tree as t


@dataclass(frozen=True, slots=True)
class Known:
    """An equation that may be used: by its name, at the time `when` ("t" or "0"); `claim.given` holds there."""

    name: str
    claim: Claim
    when: str = "t"


@dataclass(frozen=True, slots=True)
class Multiples:
    """left - right = Σ factor × (left - right of a known equation) + Σ factor × (sin² + cos² - 1 of an angle)."""

    known: tuple[tuple[t.Node, Known], ...] = ()
    circles: tuple[tuple[t.Node, t.Node], ...] = ()


@dataclass(frozen=True, slots=True)
class Have:
    """A claim on the way. how: "still" (the rate of what vanishes), "flat" (no rate, and 0 at the start), "integral".

    multiples: for "still" those that show what vanishes (`of`), for "flat" those that show that its rate is 0, and
    `begin` that it is 0 at the start; source: the premises that it rests on.
    """

    name: str
    how: str
    claim: Claim
    of: t.Node = t.ZERO
    multiples: Multiples = field(default_factory=Multiples)
    begin: Multiples = field(default_factory=Multiples)
    source: str = ""
    inner: Have | None = None


@dataclass(frozen=True, slots=True)
class Proof:
    """What is shown on the way, then the claim.

    like: for a rate, the formula that is derived, and why it is the same; factor: what is divided by; square: a, s, p
    where left - right is a s² + p.
    """

    steps: tuple[Have, ...] = ()
    multiples: Multiples = field(default_factory=Multiples)
    like: tuple[t.Node, Multiples] | None = None
    factor: t.Node | None = None
    square: tuple[t.Node, t.Node, t.Node] | None = None
