"""`make mutants`: every claim against its mutants and its rewrites; the last line has the figures.

All mutants must be REFUTED and all rewrites PROVED; UNDECIDED is a failure too.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path

from rbpsym.claims.check import Checker, decide, read, relations
from rbpsym.claims.ground import Ground, glossary, with_own_symbols
from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Claim, Outcome
from rbpsym.claims.run import Worlds
from rbpsym.expr import tree as t
from rbpsym.typeset.text import to_text
from tests.mutants.changed import is_different, mutants
from tests.mutants.rewritten import rewrites

WANTED = 20


@dataclass(frozen=True, slots=True)
class Trial:
    """A mutant or rewrite of a claim, with what was decided and what should be."""

    claim: str
    relation: t.Chain
    wanted: Outcome
    found: Outcome
    detail: str
    seconds: float

    @property
    def is_passed(self) -> bool:
        """Was it decided as it should be?"""
        return self.found is self.wanted


def trials(path: Path, wanted: int = WANTED) -> Iterator[Trial]:
    """All trials of a claims file, `wanted` mutants and rewrites a claim."""
    checker = Checker(Worlds(path.parent))
    for claim in load_claims(path).claims:
        true = claim.right if claim.expect == "refuted" else claim.printed
        if claim.not_computed or true is None:
            continue
        claim = replace(claim, setting=with_own_symbols(claim.setting, checker.world(claim.setting)))
        words = checker.reading(glossary(claim.setting.symbols), claim.setting)
        node = read(true, words)
        ground = checker.ground(claim.setting, words, node)
        if checker.check(claim).outcome is not Outcome.DEFINITION:
            yield from _of_claim(claim, list(relations(node)), ground, wanted)


def _of_claim(claim: Claim, links: list[t.Chain], ground: Ground, wanted: int) -> Iterator[Trial]:
    different = (
        other
        for link in links
        for other in mutants(_equation(link), ground)
        if is_different(other, ground, claim.holds)
    )
    equal = (other for others in _in_turn([rewrites(link, ground) for link in links]) for other in others)
    yield from _decided(claim, islice(different, wanted), ground, Outcome.REFUTED)
    yield from _decided(claim, islice(equal, wanted), ground, Outcome.PROVED)


def _equation(link: t.Chain) -> t.Chain:
    """X ≠ 0 is denied by X = c X; other relations are changed as they stand."""
    if link.ops != ("!=",):
        return link
    return t.Chain((link.items[0], link.items[0]), ("=",))


def _in_turn(sources: list[Iterator[t.Chain]]) -> Iterator[list[t.Chain]]:
    """One of each source in turn."""
    while sources:
        taken = [(source, next(source, None)) for source in sources]
        yield [item for _, item in taken if item is not None]
        sources = [source for source, item in taken if item is not None]


def _decided(claim: Claim, others: Iterable[t.Chain], ground: Ground, wanted: Outcome) -> Iterator[Trial]:
    for other in others:
        begun = time.perf_counter()
        link = decide(other, ground, claim.holds)
        yield Trial(claim.id, other, wanted, link.outcome, link.detail, time.perf_counter() - begun)


def run(paths: Iterable[Path], tell: Callable[[str], None] = print, wanted: int = WANTED) -> bool:
    """Runs all trials; was every one decided as it should be, and were there enough?"""
    found = [trial for path in paths for trial in trials(path, wanted)]
    for trial in found:
        if not trial.is_passed:
            tell(f"{trial.claim}: {to_text(trial.relation)} is {trial.found}, not {trial.wanted}: {trial.detail}")
    few = list(_too_few(found, wanted))
    for claim, kind, count in few:
        tell(f"{claim}: only {count} of {wanted} {kind}")
    tell(_figures(found))
    return not few and all(trial.is_passed for trial in found) and bool(found)


def _too_few(found: list[Trial], wanted: int) -> Iterator[tuple[str, str, int]]:
    for claim in dict.fromkeys(trial.claim for trial in found):
        for kind, outcome in (("mutants", Outcome.REFUTED), ("rewrites", Outcome.PROVED)):
            count = sum(trial.claim == claim and trial.wanted is outcome for trial in found)
            if count < wanted:
                yield claim, kind, count


def _figures(found: list[Trial]) -> str:
    parts = []
    for kind, outcome in (("mutants refuted", Outcome.REFUTED), ("rewrites proved", Outcome.PROVED)):
        these = [trial for trial in found if trial.wanted is outcome]
        passed = sum(trial.is_passed for trial in these)
        share = 100 * passed / len(these) if these else 0
        parts.append(f"{passed}/{len(these)} {kind} ({share:.4g} %)")
    claims, slowest = len({trial.claim for trial in found}), max((trial.seconds for trial in found), default=0)
    return f"{claims} claims: {', '.join(parts)}; slowest {slowest:.3f} s"


if __name__ == "__main__":
    from rbpsym.statement.library import library_folder

    chosen = [Path(name) for name in sys.argv[1:]] or sorted((library_folder() / "claims").glob("*.toml"))
    sys.exit(0 if run(chosen) else 1)
