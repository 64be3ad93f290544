"""Which balances to take: the fewest and simplest that close on the accelerations."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

from rbpsym.errors import LimitError
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.study import Study
from rbpsym.methods.balances import Balance, all_balances

MOST_CANDIDATES, MOST_EXTRA, LONGEST = 28, 3, 6


@dataclass(frozen=True)
class Plan:
    """The balances, and the unknowns that they determine together."""

    balances: tuple[Balance, ...]
    unknowns: tuple[str, ...]


def plan(study: Study) -> Plan | None:
    """The cheapest set that determines all accelerations; None if the search is too wide, or if
    the accelerations that the balances give grow beyond the limits."""
    try:
        return _search(study)
    except LimitError:
        return None


def _search(study: Study) -> Plan | None:
    wanted = study.system.accelerations
    candidates = all_balances(study)
    trivial = [b for b in candidates if b.unknowns]
    for size in range(len(wanted), min(len(wanted) + MOST_EXTRA, LONGEST) + 1):
        found = _cheapest(study, trivial[:MOST_CANDIDATES], size, wanted)
        if found is not None:
            return found
    return None


def _cheapest(study: Study, candidates: list[Balance], size: int, wanted: tuple[str, ...]) -> Plan | None:
    sets = [c for c in combinations(candidates, size) if _may_close(c, size, wanted)]
    for chosen in sorted(sets, key=lambda c: sum(b.cost for b in c)):
        unknowns = tuple(sorted(frozenset().union(*(b.unknowns for b in chosen))))
        solution = solve_linear([b.row for b in chosen], unknowns)
        if not solution.free:
            return Plan(tuple(_ordered(chosen)), unknowns)
    return None


def _may_close(chosen: tuple[Balance, ...], size: int, wanted: tuple[str, ...]) -> bool:
    unknowns = frozenset().union(*(b.unknowns for b in chosen))
    return len(unknowns) == size and set(wanted) <= unknowns


def _ordered(chosen: tuple[Balance, ...]) -> list[Balance]:
    """Those with the fewest unknowns first: they can be used at once."""
    return sorted(chosen, key=lambda b: (len(b.unknowns), len(b.bodies), b.cost))
