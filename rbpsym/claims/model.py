"""Claims: printed formulas, where they stand, what their symbols mean, what is expected of them."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from typing import Any

from rbpsym.errors import Place
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen, field


class Outcome(StrEnum):
    """What was found out about a printed relation."""

    PROVED = "PROVED"
    DEFINITION = "DEFINITION"
    REFUTED = "REFUTED"
    UNDECIDED = "UNDECIDED"
    NOT_COMPUTED = "NOT A FORMULA WE COMPUTE"
    UNREAD = "COULD NOT BE READ"


CERTIFIED = "certified by Rocq"
EXPECTATIONS = {
    "proved": (Outcome.PROVED, Outcome.DEFINITION), "refuted": (Outcome.REFUTED,), "undecided": (Outcome.UNDECIDED,),
    "not computed": (Outcome.NOT_COMPUTED,),
}  # fmt: skip


class Printed(Frozen):
    """A LaTeX text as it is printed, and where it stands in the claims file."""

    latex: str
    place: Place | None = field(default=None, compare=False)


class Meaning(Frozen):
    """The phrase that says what a printed symbol means."""

    phrase: str
    place: Place | None = field(default=None, compare=False)


class Setting(Frozen):
    """What several claims share: a problem (or one phase of it) or a theory, the meanings of symbols, assumptions.

    `given` are relations that are assumed, as printed.
    """

    name: str
    problem: str = ""
    theory: str = ""
    fixed_axis: bool = False
    symbols: Mapping[str, Meaning] = field(default_factory=dict)
    given: tuple[Printed, ...] = ()
    place: Place | None = field(default=None, compare=False)
    phase: str = ""


class Claim(Frozen):
    """A printed formula with its meaning.

    id: stable. number, label, line: its place in the source. says: a sentence in words, of which
    `printed` is the formula. holds: "" (at whatever depth it is found to), "identity", "motion" or
    "start". expect: a key of EXPECTATIONS. right: the correct form of an erratum. not_computed: why
    nothing can be computed of it.
    """

    id: str
    setting: Setting
    printed: Printed | None
    number: str = ""
    label: str = ""
    line: int = 0
    says: str = ""
    holds: str = ""
    expect: str = "proved"
    right: Printed | None = None
    erratum: str = ""
    note: str = ""
    not_computed: str = ""
    place: Place | None = field(default=None, compare=False)


class ClaimsFile(Frozen):
    """The claims about one source, in its order.

    setting: for formulas without a claim, None where several settings are possible. unclaimed: "not computed" if
    it is expected of these that nothing is decided.
    """

    name: str
    title: str
    source: str
    text: str
    claims: tuple[Claim, ...]
    file: str = field(default="", compare=False)
    content: str = field(default="", compare=False, repr=False)
    setting: Setting | None = None
    unclaimed: str = ""


class Link(Frozen):
    """One relation of a chain with its outcome.

    relation: its tree, or its text in a result. how: by what it was proved. detail: the witness,
    or the reason why not. diagnosis: what seems to be meant. mathml: the relation, drawn. fix: the whole formula with
    this relation repaired, in the author's LaTeX; "" if that is not known, or was not proved as it is read again.
    """

    relation: Node | str
    outcome: Outcome
    how: str = ""
    detail: str = ""
    diagnosis: str = ""
    mathml: str = ""
    fix: str = ""


class Result(Frozen):
    """What was found out about a claim, or (`kind` "derivation") about a whole derivation.

    file and line: in the text; declared: file and line of the claim. right: the outcome of the
    declared correct form of an erratum, right_latex that form. known: a baseline holds it. rocq: what the prover says of
    it, CERTIFIED or why not; "" if it was not asked.
    """

    id: str
    number: str
    label: str
    line: int
    file: str
    latex: str
    outcome: Outcome
    expected: bool = False
    links: tuple[Link, ...] = ()
    detail: str = ""
    says: str = ""
    erratum: str = ""
    note: str = ""
    right: str = ""
    right_latex: str = ""
    seconds: float = field(default=0.0, compare=False)
    cached: bool = field(default=False, compare=False)
    kind: str = "claim"
    known: bool = False
    rocq: str = field(default="", compare=False)
    declared: tuple[str, int] = field(default=("", 0), compare=False)

    @property
    def is_finding(self) -> bool:
        """Is it not as expected, or so by a baseline alone?"""
        return not self.expected or self.known

    @property
    def diagnosis(self) -> str:
        """The first diagnosis of a near miss."""
        return next((link.diagnosis for link in self.links if link.diagnosis), "")

    @property
    def fix(self) -> str:
        """The formula with its one wrong relation repaired, in the author's LaTeX."""
        return next((link.fix for link in self.links if link.fix), "")

    @property
    def how(self) -> str:
        """By what the links were proved."""
        return ", ".join(dict.fromkeys(way for link in self.links if link.how for way in link.how.split(", ")))


TOLD = ("id", "number", "label", "line", "says", "note", "erratum")  # what a result repeats of its claim


def told_of(claim: Claim) -> dict[str, Any]:
    """What a result repeats of its claim, with the file and line of the claim in its claims file."""
    declared = (claim.place.file, claim.place.line) if claim.place else ("", 0)
    return {**{key: getattr(claim, key) for key in TOLD}, "declared": declared}


ORDER = (Outcome.UNREAD, Outcome.REFUTED, Outcome.UNDECIDED, Outcome.NOT_COMPUTED, Outcome.PROVED, Outcome.DEFINITION)


def worst(outcomes: list[Outcome]) -> Outcome:
    """The outcome of a chain: that of its weakest link."""
    return min(outcomes, key=ORDER.index) if outcomes else Outcome.NOT_COMPUTED
