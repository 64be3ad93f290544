"""Claims found again in a paper: by number and label, by label, by number, or by the formula itself."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from difflib import SequenceMatcher

from rbpsym.errors import RbpsymError
from rbpsym.verify.claims_model import Claim, Printed
from rbpsym.verify.paper_macros import expanded
from rbpsym.verify.paper_source import told_at
from rbpsym.verify.paper_walk import Formula, Paper

_WRAPPED = re.compile(r"\s*(?:\\left\s*)?\(([^()]*=[^()]*|[^()]*\\approx[^()]*?)(?:\\right\s*)?\)\s*")
LIKENESS = 0.6
NEAR = 40  # lines


@dataclass(frozen=True, slots=True)
class Pair:
    """A formula of the paper with its claim; one of them may be missing."""

    formula: Formula | None
    claim: Claim | None


def bound(paper: Paper, claims: Iterable[Claim]) -> list[Pair]:
    """Formulas and claims in the order of the paper.

    Displayed formulas and inline relations all occur; claims in words stand at their line.
    """
    claims, taken = list(claims), {}
    for match in (_labelled, _same, _inline, _numbered, _changed):
        for claim in claims:
            if claim.id not in {c.id for c in taken.values()} and (formula := match(claim, paper, taken)) is not None:
                taken[formula] = claim
    found = [Pair(formula, taken.get(formula)) for formula in _asserting(paper)]
    placed = {claim.id for claim in taken.values()}
    found += [Pair(None, claim) for claim in claims if claim.id not in placed]
    order = {claim.id: place for place, claim in enumerate(claims)}
    return sorted(found, key=lambda pair: (_line(pair), order.get(pair.claim.id, -1) if pair.claim else -1))


def _asserting(paper: Paper) -> Iterator[Formula]:
    return (formula for formula in paper.formulas if formula.displayed or formula.is_relation)


def _line(pair: Pair) -> int:
    return pair.formula.line if pair.formula else pair.claim.line


def _displayed(claim: Claim, paper: Paper, taken: dict, *tests: Callable[[Formula], bool]) -> Formula | None:
    """The first free displayed formula that passes the first test that any of them passes."""
    if claim.printed is None or not (claim.number or claim.label):
        return None
    free = [formula for formula in paper.displayed if formula not in taken]
    return next((f for test in tests for f in free if test(f)), None)


def _labelled(claim: Claim, paper: Paper, taken: dict) -> Formula | None:
    """By the label, and the number if the label is given twice."""
    if not claim.label:
        return None
    named = (lambda f: f.number == claim.number and claim.label in f.labels, lambda f: claim.label in f.labels)
    return _displayed(claim, paper, taken, *named)


def _same(claim: Claim, paper: Paper, taken: dict) -> Formula | None:
    """Without a label: the same formula, if it can be with the same number."""
    wanted = plain(claim.printed.latex) if claim.printed else ""
    alike = (lambda f: f.number == claim.number and plain(f.latex) == wanted, lambda f: plain(f.latex) == wanted)
    return None if claim.label else _displayed(claim, paper, taken, *alike)


def _numbered(claim: Claim, paper: Paper, taken: dict) -> Formula | None:
    """Without a label: the formula of that number."""
    return None if claim.label else _displayed(claim, paper, taken, lambda f: f.number == claim.number)


def _inline(claim: Claim, paper: Paper, taken: dict) -> Formula | None:
    """The same formula, in the nearest line."""
    if not _is_inline(claim):
        return None
    wanted = plain(claim.printed.latex)
    same = [f for f in _asserting(paper) if f not in taken and plain(f.latex) == wanted]
    return min(same, key=lambda f: abs(f.line - claim.line), default=None)


def _changed(claim: Claim, paper: Paper, taken: dict) -> Formula | None:
    """A formula near the claim's line that is much like it: it was changed."""
    if not _is_inline(claim) or claim.says:
        return None
    wanted = plain(claim.printed.latex)
    near = [f for f in _asserting(paper) if f not in taken and not f.displayed and abs(f.line - claim.line) <= NEAR]
    ranked = [(SequenceMatcher(None, plain(f.latex), wanted).ratio(), f) for f in near]
    likeness, formula = max(ranked, key=lambda item: item[0], default=(0.0, None))
    return formula if likeness >= LIKENESS else None


def _is_inline(claim: Claim) -> bool:
    return claim.printed is not None and not claim.number and not claim.label


def plain(latex: str) -> str:
    """The formula without spacing and delimiters around the whole, to compare it."""
    latex = re.sub(r"\\(?:left|right|,|;|!|:|nonumber)(?![A-Za-z])|[\s~]|[.,;]\s*$", "", latex)
    while latex[:1] == "(" and latex[-1:] == ")" and latex.count("(") == 1:
        latex = latex[1:-1]
    return latex


def printed(formula: Formula, paper: Paper) -> Printed:
    """The formula of the paper with its macros put in. Raises ReadError told in its line."""
    try:
        latex = expanded(formula.latex, paper.macros)
    except RbpsymError as error:
        raise told_at(error, paper.text, formula.offset) from None
    whole = _WRAPPED.fullmatch(latex)
    return Printed(whole[1] if whole else latex)
