"""Impulses in maximal coordinates: the speeds after, and what each kind of impulse adds to their equations.

The `struck` of a kind, in the module `row` of its folder, gives its known impulse and its unknown ones, each with the
condition under which it parts.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from rbpsym.elements.impulses import IMPULSES
from rbpsym.elements.kinds import Parts
from rbpsym.frozen import Frozen
from rbpsym.oracles.simulation import Bench
from rbpsym.oracles.simulation_bodies import Mechanism, placed
from rbpsym.oracles.simulation_contacts import ROWS
from rbpsym.oracles.simulation_joints import Kept
from rbpsym.statement.model import Element, PointRef


class End(Frozen):
    """The simulated state at an event: time since the start of the phase, X, V."""

    time: float
    where: np.ndarray
    speed: np.ndarray


class Parting(Frozen):
    """An unknown impulse of size 1 as a generalized impulse, with what comes in proportion to it; after it the speed along
    the line is `wanted`."""

    name: str
    line: np.ndarray
    drag: np.ndarray
    wanted: float


Strikes = tuple[np.ndarray | float, list[Parting]]
STRUCK: Parts[Callable[[Element, Bench, End], Strikes]] = Parts(IMPULSES, "row", "struck")


def struck(
    before: Bench, after: Bench, end: End, impulses: tuple[Element, ...]
) -> tuple[np.ndarray, dict[str, float]]:
    """V after, and the impulses by the name of their force."""
    where, speed, size = end.where.tolist(), end.speed.tolist(), before.equations.size
    rows = [parting(kept, end, -kept.at(where, speed).drift) for kept in after.equations.kept]
    momentum = before.equations.masses * end.speed
    for element in impulses:
        given, own = STRUCK[element.kind](element, before, end)
        momentum, rows = momentum + given, [*rows, *own]
    g = np.array([row.line for row in rows]).reshape(len(rows), size)
    pushes = g + np.array([row.drag for row in rows]).reshape(len(rows), size)
    full = np.block([[np.diag(before.equations.masses), -pushes.T], [g, np.zeros((len(g), len(g)))]])
    found = np.linalg.lstsq(full, np.concatenate([momentum, [row.wanted for row in rows]]), rcond=None)[0]
    return found[:size], dict(zip((row.name for row in rows), found[size:].tolist(), strict=True))


def parting(kept: Kept, end: End, wanted: float) -> Parting:
    """The impulse of what keeps a condition; friction comes in proportion to its multiplier."""
    where, size = end.where.tolist(), end.speed.size
    drag = [entry for drag in kept.drags if drag.strikes for entry in drag.at(where, [])]
    return Parting(kept.multiplier, dense(kept.at(where, end.speed.tolist()).entries, size), dense(drag, size), wanted)


def met(element: Element, mechanism: Mechanism, start: list[float]) -> list[Kept]:
    """The conditions of a bounce, or of a constraint that begins, as those of a constraint that lasts."""
    values = element.values
    way = "string" if "path" in values else "rolling" if values.get("slip") == "none" else "contact"
    return ROWS[way if element.kind in IMPULSES else element.kind](element, mechanism, start)


def dense(entries: Iterable[tuple[int, float]], size: int) -> np.ndarray:
    """A row with all its zeros."""
    row = np.zeros(size)
    for column, entry in entries:
        row[column] += entry
    return row


def along(bench: Bench, end: End, *ends: tuple[PointRef, tuple[float, float]]) -> np.ndarray:
    """The generalized impulse of impulses at points."""
    size, where = bench.equations.size, end.where.tolist()
    spots = ((placed(bench.placement.mechanism.spot(ref), where, [0.0] * size), way) for ref, way in ends)
    return sum((dense(spot.along(*way), size) for spot, way in spots), np.zeros(size))
