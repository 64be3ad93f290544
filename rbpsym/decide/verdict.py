"""Verdicts: what was decided about a claim, how, and a witness that a person can check."""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from fractions import Fraction
from typing import TYPE_CHECKING

from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen
from rbpsym.showing import Shown

if TYPE_CHECKING:
    from rbpsym.decide.enclosure import Number


class Kind(StrEnum):
    """The three possible outcomes."""

    PROVED = "PROVED"
    REFUTED = "REFUTED"
    UNDECIDED = "UNDECIDED"


PROVED, REFUTED, UNDECIDED = Kind.PROVED, Kind.REFUTED, Kind.UNDECIDED


class Obligation(Frozen):
    """A condition without which the claim has no meaning, such as x != 0 after a division by x.

    `relation` shows it; `why` says what discharges it ("" if nothing does).
    """

    relation: Node
    why: str = ""

    @property
    def is_discharged(self) -> bool:
        """Whether the assumptions imply it."""
        return bool(self.why)


class Witness(Frozen):
    """A point at which both sides were computed.

    numbers: values of names. points: (angle, cosine, sine), the angle as text ("theta/2").
    left, right: values of the sides, exact fractions or enclosures; of: whose values, if not the sides' own.
    """

    numbers: tuple[tuple[str, Fraction], ...]
    points: tuple[tuple[str, Fraction, Fraction], ...]
    left: Number
    right: Number
    of: str = ""

    def __str__(self) -> str:
        parts = [f"cos({a}) = {c}, sin({a}) = {s}" for a, c, s in self.points]
        parts += [f"{name} = {number}" for name, number in self.numbers]
        whose = f": {self.of}" if self.of else ""
        return f"at {', '.join(parts) or 'every point'}{whose}: left = {self.left}, right = {self.right}"


class Verdict(Shown):
    """The outcome. `how` names the procedure, `reason` says why it is UNDECIDED."""

    kind: Kind
    how: str = ""
    witness: Witness | None = None
    obligations: tuple[Obligation, ...] = ()
    reason: str = ""

    @property
    def is_proved(self) -> bool:
        """Whether it is PROVED (perhaps with open obligations)."""
        return self.kind is PROVED

    @property
    def is_refuted(self) -> bool:
        """Whether it is REFUTED."""
        return self.kind is REFUTED

    @property
    def open_obligations(self) -> tuple[Obligation, ...]:
        """The conditions that the assumptions do not imply."""
        return tuple(item for item in self.obligations if not item.is_discharged)

    def __str__(self) -> str:
        detail = {PROVED: self.how, REFUTED: str(self.witness), UNDECIDED: self.reason}[self.kind]
        return f"{self.kind}: {detail}" if detail else str(self.kind)


def proved(how: str, obligations: Iterable[Obligation] = ()) -> Verdict:
    """PROVED by the exact procedure `how`."""
    return Verdict(PROVED, how, obligations=tuple(obligations))


def refuted(how: str, witness: Witness) -> Verdict:
    """REFUTED by a witness."""
    return Verdict(REFUTED, how, witness)


def undecided(reason: str) -> Verdict:
    """UNDECIDED, with the reason."""
    return Verdict(UNDECIDED, reason=reason)


def all_of(verdicts: Iterable[Verdict]) -> Verdict:
    """The verdict on a conjunction: the first refuted, else the first undecided, else PROVED."""
    found = list(verdicts)
    for kind in (REFUTED, UNDECIDED):
        failed = next((verdict for verdict in found if verdict.kind is kind), None)
        if failed is not None:
            return failed
    ways = dict.fromkeys(verdict.how for verdict in found)
    duties = dict.fromkeys(duty for verdict in found for duty in verdict.obligations)
    return proved(", ".join(ways), duties)
