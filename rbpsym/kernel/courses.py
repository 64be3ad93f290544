"""Coordinates, speeds and letters as functions of the time, where the premises give their rates so."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from rbpsym.algebra import NOTHING, names_in, substitute, symbol
from rbpsym.algebra.integration import antiderivative
from rbpsym.errors import Undecided
from rbpsym.kernel.certificates import Known
from rbpsym.kernel.claims import TIME

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search


def courses(search: Search, known: Sequence[Known]) -> list[Known]:
    """What each is at any time, from its start; what has a rate without a closed form is left out."""
    found: dict[str, Known] = {}
    free = [item for item in known if item.is_free]
    names = [name for name in search.rates if name != TIME and name not in search.integrals]
    for name in (*names, *names):  # speeds first, then what they move
        if name not in found:
            with suppress(Undecided):
                found[name] = _course(search, name, [*free, *found.values()])
    search.fixed -= found.keys()
    return [*found.values()]


def _course(search: Search, name: str, known: Sequence[Known]) -> Known:
    """A letter less its start and what its rate gives does not change."""
    rate, _ = search.follow(search.rates[name], known)
    way = None if any(map(search.moving, names_in(rate) - {TIME})) else antiderivative(rate, TIME)
    if way is None:
        raise Undecided("its rate is no function of the time")
    begun = [Known(item.name, item.claim, "0") for item in known if item.name in search.given]
    start, _ = search.follow(search.at_start(symbol(name)), begun)
    search.by_rates(symbol(name) - start - way + substitute(way, {TIME: NOTHING}), known)
    have = search.haves[-1]
    return Known(have.name, have.claim)
