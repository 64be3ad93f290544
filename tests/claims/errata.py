"""`python -m tests.claims.errata COUNT SEED`: errors of one token in the formulas that ship, and the same said otherwise.

An error must be refuted, unless the formula stays true (found with floating-point numbers on a road of its own); told are
how many were, of how many the repair is the very formula that was printed, and which true rewritings were refuted (none may be).
"""

from __future__ import annotations

import random
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

from rbpsym.claims.check import Checker, read, relations
from rbpsym.claims.diagnosis import diagnosis
from rbpsym.claims.ground import glossary, with_own_symbols
from rbpsym.claims.integrals import valued
from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Claim, Outcome, Printed
from rbpsym.claims.run import Worlds
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.places import sites
from rbpsym.present.forms import present
from rbpsym.statement.library import library_folder
from rbpsym.typeset.text import to_text
from tests.claims.injected import injected, rewritten
from tests.mutants.changed import is_different

REWRITTEN = "rewritten"


class Trial(NamedTuple):
    """A formula made of the one that a claim prints."""

    path: Path
    claim: Claim
    kind: str
    latex: str


def trials(path: Path) -> Iterator[Trial]:
    """All of a claims file."""
    for claim in load_claims(path).claims:
        if claim.expect == "proved" and claim.printed and "=" in claim.printed.latex:
            letters = [symbol for symbol in claim.setting.symbols if len(symbol) < 7 and r"\vec" not in symbol][:5]
            yield from (Trial(path, claim, *made) for made in injected(claim.printed.latex, letters))
            yield from (Trial(path, claim, REWRITTEN, latex) for latex in rewritten(claim.printed.latex, letters))


def drawn(count: int, seed: int) -> list[Trial]:
    """So many of all, each kind as often as any other, those of a file together."""
    dice, kinds = random.Random(seed), {}
    for path in sorted((library_folder() / "claims").glob("*.toml")):
        for trial in trials(path):
            kinds.setdefault(trial.kind, []).append(trial)
    chosen = [trial for rows in kinds.values() for trial in dice.sample(rows, min(len(rows), -(-count // len(kinds))))]
    return sorted(chosen, key=lambda trial: trial.path)


def stays_true(trial: Trial, checker: Checker) -> bool:
    """By floating-point numbers: do both sides agree in every link?"""
    setting = with_own_symbols(trial.claim.setting, checker.world(trial.claim.setting))
    words = checker.reading(glossary(setting.symbols), setting)
    node = read(Printed(trial.latex), words)
    ground = checker.ground(setting, words, node)
    return not any(is_different(link, ground, trial.claim.holds) for link in relations(node))


def judged(trial: Trial, checker: Checker) -> str:
    """What became of it, in a word."""
    try:
        found = checker.check(trial.claim, Printed(trial.latex))
    except RbpsymError:
        return "unread"
    if trial.kind == REWRITTEN:
        return {Outcome.PROVED: "proved", Outcome.REFUTED: "FALSELY REFUTED"}.get(found.outcome, "undecided")
    if found.outcome is Outcome.REFUTED:
        return _repaired(found.fix, trial, checker)
    if found.outcome is Outcome.PROVED:
        return "true" if stays_true(trial, checker) else "MISSED"
    return "undecided"


def _repaired(fix: str, trial: Trial, checker: Checker) -> str:
    """Is the repair what was printed, but for the order of factors and other names of the same; another true formula; or none?"""
    if not fix:
        return "no repair"
    (told, values), (printed, wanted) = (_meant(latex, trial, checker) for latex in (fix, trial.claim.printed.latex))
    return "exact" if told == printed or (bool(wanted) and values == wanted) else "other repair"


def _meant(latex: str, trial: Trial, checker: Checker) -> tuple[str, list[str]]:
    """The formula with factors and terms sorted, each symbol by what it means; the values of its sides, if they are numbers."""
    setting = with_own_symbols(trial.claim.setting, checker.world(trial.claim.setting))
    words = checker.reading(glossary(setting.symbols), setting)
    node = read(Printed(latex), words)
    ground = checker.ground(setting, words, node)
    told = _sorted(node, {name: str(found) for name, found in ground.scope.scalars.items()})
    try:
        sides = [valued(item, ground) for link in relations(node) for item in link.items]
        return told, [to_text(present(side)) for side in sides]
    except (RbpsymError, AttributeError):
        return told, []


def _sorted(node: t.Node, meanings: dict[str, str]) -> str:
    if isinstance(node, t.Group):
        return _sorted(node.arg, meanings)
    if isinstance(node, (t.Sym, t.Vec)):
        return f"{type(node).__name__} {meanings.get(node.name, node.name)}"
    parts = [_sorted(part, meanings) for path, part in sites(node) if len(path) == 1]
    own = [str(getattr(node, key)) for key in ("name", "value", "ops", "wrt", "var") if hasattr(node, key)]
    return f"{type(node).__name__}({own}, {sorted(parts) if isinstance(node, (t.Mul, t.Add)) else parts})"


def run(count: int, seed: int, tell: Callable[[str], None] = print) -> bool:
    """Was every error caught, and no rewriting refuted?"""
    counts: dict[str, Counter[str]] = {}
    checker, path = None, None
    for trial in drawn(count, seed):
        if trial.path != path:
            checker, path = Checker(Worlds(trial.path.parent), diagnosis), trial.path
        word = judged(trial, checker)
        counts.setdefault(trial.kind, Counter())[word] += 1
        if word not in ("exact", "proved", "unread", "true"):
            tell(f"{word}: {trial.path.stem} {trial.claim.id} ({trial.kind}): {trial.latex}   <- {trial.claim.printed.latex}")
    for kind, words in counts.items():
        tell(f"{kind}: " + ", ".join(f"{number} {word}" for word, number in words.most_common()))
    said = Counter(word for kind, words in counts.items() if kind != REWRITTEN for word in words.elements())
    errors = sum(said.values()) - said["unread"] - said["true"]
    caught = said["exact"] + said["other repair"] + said["no repair"]
    repaired = f"{said['exact']} repaired exactly, {said['other repair']} otherwise"
    left = f"{said['true']} left it true, {said['unread']} could not be read"
    tell(f"{caught} of {errors} errors caught, {repaired}; {left}; rewritings: {dict(counts.get(REWRITTEN, {}))}")
    return not said["MISSED"] and not counts.get(REWRITTEN, Counter())["FALSELY REFUTED"]


if __name__ == "__main__":
    sys.exit(0 if run(int(sys.argv[1]), int(sys.argv[2])) else 1)
