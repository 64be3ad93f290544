"""A paper walked in order: each formula decided with the symbols that its claim binds.

A displayed formula without a claim is read with the symbols of the formula before it; what can't
be read so is said to be no formula that is computed. It is never counted as passed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from rbpsym.errors import RbpsymError
from rbpsym.verify.claims_cache import digest
from rbpsym.verify.claims_check import Checker, unread
from rbpsym.verify.claims_model import Claim, Outcome, Result, Setting
from rbpsym.verify.paper_bind import Pair, plain, printed
from rbpsym.verify.paper_source import told_at
from rbpsym.verify.paper_walk import Formula, Paper

UNBOUND = "no claim binds its symbols"
IN_TEXT = "it stands in a sentence, and no claim asks for it"


@dataclass(frozen=True)
class PaperChecker:
    """Decides the pairs of a paper: claims by their checkers, the rest by `other` in the last setting or `default`."""

    paper: Paper
    checkers: dict[str, Checker]
    other: Checker
    default: Setting | None = None

    def results(self, pairs: list[Pair]) -> Iterator[Result]:
        """The results in the paper's order."""
        setting = self.default
        for pair in pairs:
            if pair.claim is None:
                yield self._without_claim(pair.formula, setting)
                continue
            setting = pair.claim.setting
            yield self.result(pair)

    def result(self, pair: Pair) -> Result:
        """The result of a claim with the paper's own formula."""
        claim, formula = pair.claim, pair.formula
        if formula is None:
            return self._only_claimed(claim)
        try:
            own = replace(printed(formula, self.paper), place=None)
            found = self.checkers[claim.id].check(claim, own)
        except RbpsymError as error:
            found = unread(claim, self._told(error, formula))
        return replace(
            found, latex=formula.latex, line=formula.line, file=formula.file, number=formula.number or claim.number
        )

    def _only_claimed(self, claim: Claim) -> Result:
        """A claim in words, or one whose formula is not in the paper any more."""
        if claim.printed and not claim.says:
            return unread(claim, "the formula of this claim was not found in the text")
        return replace(self.checkers[claim.id].check(claim), file=self.paper.text.origins[0][0])

    def _told(self, error: RbpsymError, formula: Formula) -> str:
        is_own = error.place is None or not error.place.file
        return str(told_at(error, self.paper.text, formula.offset) if is_own else error)

    def _without_claim(self, formula: Formula, setting: Setting | None) -> Result:
        name = next(iter(formula.labels), "") or formula.number or digest(plain(formula.latex))[:8]
        claim = Claim(f"unclaimed: {name}", setting or Setting("none"), None, formula.number)
        blank = Result(
            claim.id,
            formula.number,
            next(iter(formula.labels), ""),
            formula.line,
            formula.file,
            formula.latex,
            Outcome.NOT_COMPUTED,
            True,
            detail=UNBOUND if formula.displayed else IN_TEXT,
        )
        if setting is None or not formula.displayed or not formula.is_relation:
            return blank
        return self._tried(blank, claim, formula)

    def _tried(self, blank: Result, claim: Claim, formula: Formula) -> Result:
        """With the symbols of the formula before; a symbol that is unknown there makes it no claim."""
        try:
            found = self.other.check(claim, replace(printed(formula, self.paper), place=None))
        except RbpsymError as error:
            return replace(blank, detail=f"{UNBOUND}: {error.what}")
        return replace(
            found,
            id=blank.id,
            line=formula.line,
            file=formula.file,
            label=blank.label,
            expected=found.outcome not in (Outcome.REFUTED, Outcome.UNDECIDED),
        )
