"""A paper walked in order: each formula decided with the symbols that its claim binds.

A displayed relation without a claim is read with the symbols of its claims file, never with those of another
claim; where nothing can be computed of it, that is not as expected, unless the claims file expects it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from rbpsym.errors import RbpsymError
from rbpsym.verify.claims_cache import digest
from rbpsym.verify.claims_check import Checker, unread
from rbpsym.verify.claims_model import EXPECTATIONS, Claim, ClaimsFile, Outcome, Result, Setting
from rbpsym.verify.paper_bind import Pair, plain, printed
from rbpsym.verify.paper_source import told_at
from rbpsym.verify.paper_walk import Formula, Paper

UNKNOWN = re.compile(r"unknown symbol “(.+)”")
NO_RELATION = "it relates nothing"
UNBOUND = "no claim binds its symbols"
IN_TEXT = "it stands in a sentence, and no claim asks for it"


@dataclass(frozen=True)
class Scope:
    """A claims file with its checker: what formulas are read with that no claim asks for."""

    file: ClaimsFile
    checker: Checker


@dataclass(frozen=True)
class PaperChecker:
    """Decides the pairs of a paper: claims by their checkers, the rest in the scope of their file."""

    paper: Paper
    checkers: dict[str, Checker]
    scopes: tuple[Scope, ...]

    def results(self, pairs: list[Pair]) -> Iterator[Result]:
        """The results in the paper's order."""
        for pair in pairs:
            yield self.result(pair) if pair.claim else self._without_claim(pair.formula)

    def scope(self, formula: Formula) -> Scope | None:
        """The claims file that names the formula's text, or the only one; None if several may be meant."""
        own = [
            scope for scope in self.scopes if scope.file.text and Path(scope.file.text).name == Path(formula.file).name
        ]
        found = own or self.scopes
        return found[0] if len(found) == 1 else None

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

    def _without_claim(self, formula: Formula) -> Result:
        name = next(iter(formula.labels), "") or formula.number or digest(plain(formula.latex))[:8]
        scope = self.scope(formula)
        setting = scope.file.setting if scope else None
        claim = Claim(f"unclaimed: {name}", setting or Setting("none"), None, formula.number)
        asserts = formula.displayed and formula.is_relation
        blank = Result(
            claim.id,
            formula.number,
            next(iter(formula.labels), ""),
            formula.line,
            formula.file,
            formula.latex,
            Outcome.NOT_COMPUTED,
            not asserts or bool(scope and scope.file.unclaimed),
            detail=(UNBOUND if asserts else NO_RELATION) if formula.displayed else IN_TEXT,
        )
        if not asserts or blank.expected:
            return blank
        if scope is None or setting is None:
            return replace(blank, detail=f"{UNBOUND}, and there are several {'files' if scope is None else 'settings'}")
        return self._tried(blank, claim, formula, scope)

    def _tried(self, blank: Result, claim: Claim, formula: Formula, scope: Scope) -> Result:
        """With the symbols of its claims file; a symbol that is unknown there makes it no claim."""
        try:
            found = scope.checker.check(claim, replace(printed(formula, self.paper), place=None))
        except RbpsymError as error:
            return replace(blank, detail=f"{UNBOUND}: {error.what}{_cure(error)}")
        return replace(
            found,
            id=blank.id,
            line=formula.line,
            file=formula.file,
            label=blank.label,
            expected=found.outcome in EXPECTATIONS["proved"],
        )


def _cure(error: RbpsymError) -> str:
    """What to write for a symbol without a meaning."""
    symbol = UNKNOWN.search(error.what)
    return f"; say what it means: [symbols] '{symbol[1]}' = \"...\", or claim the formula" if symbol else ""
