"""Roads to the motion, each with the lines that it takes: what a teacher weighs before writing the first of them.

A road begins with one balance (about a point, along a direction, of some of the bodies) and takes as few further ones as
determine all accelerations. An unknown force that stands in none of its lines has dropped out.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from rbpsym.chapters.methods.balances import LONGEST, MOST_CANDIDATES, MOST_EXTRA, Balance, all_balances, may_close, plan
from rbpsym.field import is_zero
from rbpsym.frozen import Frozen
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.study import Study


class Road(Frozen):
    """`first` is the balance with which it begins; None for `kind` "bodies" (Newton's and Euler's equations of each) and
    "energy" (that of the whole). `lines` are its equations, `stay` and `drop` the unknown forces that are in them and not."""

    kind: str
    first: Balance | None
    lines: int
    stay: tuple[str, ...]
    drop: tuple[str, ...]
    is_taken: bool = False


def roads(study: Study) -> list[Road]:
    """All of them, those with the fewest lines and the fewest unknown forces first; `is_taken` where the notes go."""
    wanted, unknown = study.system.accelerations, study.system.unknowns
    if not wanted:
        return []
    chosen = plan(study)
    candidates = [b for b in all_balances(study) if b.unknowns][:MOST_CANDIDATES]
    found = [_bodies(study)]
    if len(wanted) == 1 and study.first_integral is not None:
        found.append(Road("energy", None, 1, (), unknown))
    for first in candidates:
        lines = _shortest(first, candidates, wanted)
        if lines:
            stay = tuple(name for name in unknown if any(name in line.unknowns for line in lines))
            is_taken = chosen is not None and first.row in [balance.row for balance in chosen.balances]
            found.append(Road(first.kind, first, len(lines), stay, tuple(n for n in unknown if n not in stay), is_taken))
    return sorted(found, key=lambda road: (road.lines, len(road.stay), not road.is_taken))


def _bodies(study: Study) -> Road:
    rows = [row for row in study.newton_euler_rows if not is_zero(row)]
    return Road("bodies", None, len(rows), study.system.unknowns, ())


def _shortest(first: Balance, candidates: Sequence[Balance], wanted: tuple[str, ...]) -> tuple[Balance, ...]:
    """The fewest lines, this one first, that determine the accelerations and not without it; () if there are too many."""
    others = [balance for balance in candidates if balance is not first]
    for size in range(len(wanted), min(len(wanted) + MOST_EXTRA, LONGEST) + 1):
        for more in combinations(others, size - 1):
            if _closes((first, *more), wanted) and not _closes(more, wanted):
                return (first, *more)
    return ()


def _closes(lines: tuple[Balance, ...], wanted: tuple[str, ...]) -> bool:
    if not may_close(lines, len(lines), wanted):
        return False
    names = tuple(sorted(frozenset().union(*(line.unknowns for line in lines))))
    return not solve_linear([line.row for line in lines], names).free
