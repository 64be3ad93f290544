"""More moments where curves bend: between two of them no curve turns by more than a few degrees."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from rbpsym.document.plots.trajectory import Trajectory

BEND = math.radians(5)
SEEN = 0.012  # of the width of a panel: shorter pieces look like dots
MOST = 1500  # moments
PARTS = 8  # of a stretch at once
ROUNDS = 3

Curves = Sequence[tuple[Sequence[float], Sequence[float]]]  # over what, and the values
Drawn = Callable[[Trajectory], Curves]


def refined(way: Trajectory, drawn: Drawn) -> Trajectory:
    """The motion with as many moments as its curves need to look smooth."""
    for _ in range(ROUNDS):
        parts = parts_of(drawn(way), len(way.times) - 1)
        if max(parts, default=1) == 1 or sum(parts) > MOST:
            break
        way = way.with_more(parts)
    return way


def parts_of(curves: Curves, count: int) -> list[int]:
    """How many parts each stretch between two moments needs."""
    found = [1] * count
    for across, values in curves:
        points = list(zip(shares(across), shares(values), strict=True))
        for place, turn in turns(points):
            for k in (place - 1, place):
                if k < count and math.dist(points[k], points[k + 1]) > SEEN:
                    found[k] = max(found[k], min(PARTS, math.ceil(turn / BEND)))
    return found


def shares(values: Sequence[float]) -> list[float]:
    """The values between 0 and 1; what has no value stays so."""
    known = [value for value in values if math.isfinite(value)] or [0.0]
    low, wide = min(known), max(known) - min(known)
    return [(value - low) / wide if wide > 1e-12 * max(map(abs, known)) else 0.0 for value in values]


def turns(points: Sequence[tuple[float, float]]) -> Iterator[tuple[int, float]]:
    """How much a broken line turns at each of its inner points."""
    for place in range(1, len(points) - 1):
        (a, b), (c, d), (e, f) = points[place - 1 : place + 2]
        turn = math.atan2((c - a) * (f - d) - (d - b) * (e - c), (c - a) * (e - c) + (d - b) * (f - d))
        if math.isfinite(turn):
            yield place, abs(turn)
