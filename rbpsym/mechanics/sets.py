"""Sets of bodies that one may take together: those that hang together by what acts between them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations

MOST_BODIES = 4  # of more only the single ones and the whole are taken


def connected_sets(names: Sequence[str], links: Collection[tuple[str, str]]) -> Iterator[tuple[str, ...]]:
    """The connected sets of bodies, small ones first; `links` are pairs of bodies that act on each other."""
    if len(names) > MOST_BODIES:
        yield from ((name,) for name in names)
        yield tuple(names)
        return
    for size in range(1, len(names) + 1):
        yield from (subset for subset in combinations(names, size) if _is_connected(subset, links))


def _is_connected(subset: tuple[str, ...], links: Collection[tuple[str, str]]) -> bool:
    reached, border = set(), {subset[0]}
    while border:
        reached |= border
        border = {b for a, b in links if a in reached and b in subset} - reached
    return len(reached) == len(subset)
