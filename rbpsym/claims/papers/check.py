"""A paper walked in order: each formula decided with the symbols that its claim binds.

A displayed relation without a claim is judged only where that is asked for: read with the symbols of its claims file,
or with those that comments above it name, never with those of another claim. Where nothing can be computed of it, that is
not as expected, unless the claims file expects it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from difflib import SequenceMatcher
from pathlib import Path

from rbpsym.claims.check import Checker, unread
from rbpsym.claims.model import EXPECTATIONS, Claim, ClaimsFile, Outcome, Printed, Result, Setting
from rbpsym.claims.papers.claims import Beside
from rbpsym.claims.papers.macros import expanded, unexpanded
from rbpsym.claims.papers.source import told_at
from rbpsym.claims.papers.walk import Formula, Paper
from rbpsym.claims.run import digest
from rbpsym.errors import RbpsymError, ReadError
from rbpsym.frozen import Frozen, replace

_THOUSANDS = re.compile(r"(?<![\d,.(\[_^])(?<![_^]\{)\d{1,3}(?:(?:,|\{,\})\d{3})+(?![\d,)\]])")  # a list stands in brackets
_WRAPPED = re.compile(r"\s*(?:\\left\s*)?\(([^()]*=[^()]*|[^()]*\\approx[^()]*?)(?:\\right\s*)?\)\s*")
LIKENESS = 0.6
NEAR = 40  # lines


class Pair(Frozen):
    """A formula of the paper with its claim; one of them may be missing."""

    formula: Formula | None
    claim: Claim | None


Taken = dict[Formula, Claim]


def bound(paper: Paper, claims: Iterable[Claim], beside: Iterable[tuple[Formula, Claim]] = ()) -> list[Pair]:
    """Formulas and claims in the order of the paper, those that are `beside` their formulas among them.

    Displayed formulas and inline relations all occur; claims in words stand at their line.
    """
    claims, taken = list(claims), dict(beside)
    placed = {claim.id for claim in taken.values()}
    for match in (_labelled, _same, _inline, _numbered, _changed):
        for claim in claims:
            if claim.id not in placed and (formula := match(claim, paper, taken)) is not None:
                taken[formula] = claim
                placed.add(claim.id)
    found = [Pair(formula, taken.get(formula)) for formula in _asserting(paper)]
    found += [Pair(None, claim) for claim in claims if claim.id not in placed]
    order = {claim.id: place for place, claim in enumerate(claims)}
    return sorted(found, key=lambda pair: (_offset(pair, paper), order.get(pair.claim.id, -1) if pair.claim else -1))


def _asserting(paper: Paper) -> Iterator[Formula]:
    return (formula for formula in paper.formulas if formula.displayed or formula.is_relation)


def _offset(pair: Pair, paper: Paper) -> int:
    """Where the formula stands in the text, or the line of a claim in words in its first file."""
    return pair.formula.offset if pair.formula else paper.text.offset(pair.claim.line if pair.claim else 0)


def _displayed(claim: Claim, paper: Paper, taken: Taken, *tests: Callable[[Formula], bool]) -> Formula | None:
    """The first free displayed formula that passes the first test that any of them passes."""
    if claim.printed is None or not (claim.number or claim.label):
        return None
    free = [formula for formula in paper.displayed if formula not in taken]
    return next((f for test in tests for f in free if test(f)), None)


def _labelled(claim: Claim, paper: Paper, taken: Taken) -> Formula | None:
    """By the label, and the number if the label is given twice."""
    if not claim.label:
        return None
    named = (lambda f: f.number == claim.number and claim.label in f.labels, lambda f: claim.label in f.labels)
    return _displayed(claim, paper, taken, *named)


def _same(claim: Claim, paper: Paper, taken: Taken) -> Formula | None:
    """Without a label: the same formula, if it can be with the same number."""
    wanted = plain(claim.printed.latex) if claim.printed else ""
    alike = (lambda f: f.number == claim.number and plain(f.latex) == wanted, lambda f: plain(f.latex) == wanted)
    return None if claim.label else _displayed(claim, paper, taken, *alike)


def _numbered(claim: Claim, paper: Paper, taken: Taken) -> Formula | None:
    """Without a label: the formula of that number."""
    return None if claim.label else _displayed(claim, paper, taken, lambda f: f.number == claim.number)


def _inline(claim: Claim, paper: Paper, taken: Taken) -> Formula | None:
    """The same formula, in the nearest line."""
    if (wanted := _inline_text(claim)) is None:
        return None
    same = [f for f in _asserting(paper) if f not in taken and plain(f.latex) == wanted]
    return min(same, key=lambda f: abs(f.line - claim.line), default=None)


def _changed(claim: Claim, paper: Paper, taken: Taken) -> Formula | None:
    """The formula near the claim's line that is most like it, much like it or in that very line: it was changed."""
    if (wanted := _inline_text(claim)) is None or claim.says:
        return None
    near = [f for f in _asserting(paper) if f not in taken and f.is_relation and abs(f.line - claim.line) <= NEAR]
    ranked = [(SequenceMatcher(None, plain(f.latex), wanted).ratio(), f.line == claim.line, f) for f in near]
    likeness, same, formula = max(ranked, key=lambda item: item[:2], default=(0.0, False, None))
    return formula if likeness >= LIKENESS or same else None


def _inline_text(claim: Claim) -> str | None:
    """Its formula, if that has neither number nor label."""
    return plain(claim.printed.latex) if claim.printed is not None and not claim.number and not claim.label else None


def plain(latex: str) -> str:
    """The formula without spacing and delimiters around the whole, to compare it."""
    latex = re.sub(r"\\(?:left|right|,|;|!|:|nonumber)(?![A-Za-z])|[\s~]|[.,;]\s*$", "", latex)
    while latex[:1] == "(" and latex[-1:] == ")" and latex.count("(") == 1:
        latex = latex[1:-1]
    return latex


_BARE = re.compile(r"_\s*(?:\{[^{}]*\}|\S)|(?<!\d)\(\s*[1-9]\d*,\d+\s*\)|(?<![\d,.])(\d+),(?=\d+(?![\d,]))")  # 0,5, but no (1,2)


def printed(formula: Formula, paper: Paper) -> Printed:
    """The formula of the paper with its macros put in. Raises ReadError told in its line."""
    if formula.fault:
        raise ReadError(formula.fault, instead="Close it.", place=paper.text.place(formula.block))
    try:
        latex = expanded(formula.latex, paper.macros)
    except RbpsymError as error:
        raise told_at(error, paper.text, formula.offset) from None
    if paper.decimal in (",", "{,}"):
        latex = re.sub(r"(?<=\d)\{,\}(?=\d)", "{.}", latex)  # of the same length, so that places are kept
        if paper.decimal == ",":
            latex = _BARE.sub(lambda found: f"{found[1]}." if found[1] else found[0], latex)
    elif paper.decimal:
        latex = _THOUSANDS.sub(lambda found: found[0].replace("{,}", "   ").replace(",", " "), latex)
    whole = _WRAPPED.fullmatch(latex)
    return Printed(whole[1] if whole else latex)


UNKNOWN = re.compile(r"unknown symbol “(.+)”")
NO_RELATION = "it relates nothing"
UNBOUND = "no claim binds its symbols"
IN_TEXT = "it stands in a sentence, and no claim asks for it"


class OpenClaims(Frozen):
    """A claims file with its checker: what formulas are read with that no claim asks for."""

    file: ClaimsFile
    checker: Checker


class PaperChecker(Frozen):
    """Decides the pairs of a paper: claims by their checkers; the rest, if `judged`, in the scope of their place or file; in
    sentences, too, if they are `asked`."""

    paper: Paper
    checkers: dict[str, Checker]
    scopes: tuple[OpenClaims, ...]
    beside: Beside
    here: Checker
    judged: bool = False
    asked: bool = False

    def results(self, pairs: list[Pair]) -> Iterator[Result]:
        """The results in the paper's order."""
        for pair in pairs:
            if pair.claim:
                yield self.result(pair.claim, pair.formula)
            elif self.judged and pair.formula and (pair.formula.displayed or pair.formula.is_relation or not self.asked):
                yield self._without_claim(pair.formula)

    def scope(self, formula: Formula) -> OpenClaims | None:
        """The setting in force, the claims file that names the formula's text, or the only one; None if several may be meant."""
        setting = self.beside.setting(formula)
        if setting is not None:
            return OpenClaims(ClaimsFile("", "", "", "", (), setting=setting), self.here)
        own = [scope for scope in self.scopes if scope.file.text and Path(scope.file.text).name == Path(formula.file).name]
        found = own or self.scopes
        return found[0] if len(found) == 1 else None

    def result(self, claim: Claim, formula: Formula | None) -> Result:
        """The result of a claim with the paper's own formula."""
        if formula is None:
            return self._only_claimed(claim)
        own, checker = None, self.checkers[claim.id]
        try:
            own = replace(printed(formula, self.paper), place=None)
            found = checker.check(claim, own)
        except RbpsymError as error:
            found = unread(claim, self._told(error, formula), checker.respelled(claim, own, error))
        links = tuple(replace(link, fix=self._own(link.fix, formula)) for link in found.links)
        number = formula.number or claim.number
        return replace(found, links=links, latex=formula.latex, line=formula.line, file=formula.file, number=number)

    def _own(self, fix: str, formula: Formula) -> str:
        """A repaired formula with the macros of its author."""
        fix = fix.replace("{.}", "{,}") if "," in self.paper.decimal else fix
        fix = re.sub(r"(?<=\d)\.(?=\d)", ",", fix) if self.paper.decimal == "," else fix
        return unexpanded(formula.latex, fix, self.paper.macros) if fix else ""

    def _only_claimed(self, claim: Claim) -> Result:
        """A claim in words, or one whose formula is not in the paper any more."""
        if claim.printed and not claim.says:
            return unread(claim, "the formula of this claim was not found in the text")
        return replace(self.checkers[claim.id].check(claim), file=self.paper.text.origins[0][0])

    def _told(self, error: RbpsymError, formula: Formula) -> str:
        is_own = error.place is None or not error.place.file
        return str(told_at(error, self.paper.text, formula.offset) if is_own else error)

    def _without_claim(self, formula: Formula) -> Result:
        label = next(iter(formula.labels), "")
        name = label or formula.number or digest(plain(formula.latex))[:8]
        scope = self.scope(formula)
        setting = scope.file.setting if scope else None
        claim = Claim(f"unclaimed: {name}", setting or Setting("none"), None, formula.number)
        asserts = formula.is_relation and (formula.displayed or self.asked)
        passes = not asserts or bool(scope and scope.file.unclaimed)
        why = UNBOUND if asserts else NO_RELATION if formula.displayed else IN_TEXT
        told = (claim.id, formula.number, label, formula.line, formula.file, formula.latex)
        blank = Result(*told, Outcome.NOT_COMPUTED, passes, detail=why)
        if not asserts or blank.expected:
            return blank
        if scope is None or setting is None:
            return replace(blank, detail=f"{UNBOUND}, and there are several {'files' if scope is None else 'settings'}")
        return self._tried(blank, claim, formula, scope)

    def _tried(self, blank: Result, claim: Claim, formula: Formula, scope: OpenClaims) -> Result:
        """With the symbols of its claims file; a symbol that is unknown there makes it no claim."""
        try:
            found = scope.checker.check(claim, replace(printed(formula, self.paper), place=None))
        except RbpsymError as error:
            return replace(blank, detail=f"{UNBOUND}: {error.what}{_cure(error)}")
        expected = found.outcome in EXPECTATIONS["proved"]
        return replace(found, id=blank.id, line=formula.line, file=formula.file, label=blank.label, expected=expected)


def _cure(error: RbpsymError) -> str:
    """What to write for a symbol without a meaning."""
    symbol = UNKNOWN.search(error.what)
    if not symbol:
        return ""
    own = f"“rbpsym: {symbol[1]} is ...” in a comment"
    return f"; say what it means: {own}, or [symbols] '{symbol[1]}' = \"...\", or claim the formula"
