"""Seeded parameter sets: ratios to the sample numbers log-uniform in [1/5, 5], within declared signs, bounds and ranges."""

from __future__ import annotations

import random
from collections.abc import Iterator

from rbpsym.mechanics.numbers import _middle, _speed, number, sample
from rbpsym.mechanics.study import Study

WIDEST = 5.0
TRIES = 60  # of a set until its bounds are kept
EDGE = 0.05  # of a range at either end, where a start is not put

Numbers = dict[str, float]


def drawn(study: Study, seed: int) -> Iterator[Numbers]:
    """Numbers for all parameters, coordinates and speeds, one set after the other, without end."""
    source = random.Random(f"{study.problem.name} {seed}")
    while True:
        yield next(found for found in (_set(study, source) for _ in range(10**6)) if found is not None)


def _set(study: Study, source: random.Random) -> Numbers | None:
    """A set that keeps what is declared; None if it does not within some tries."""
    problem, first = study.problem, sample(study.problem)
    own = {q.name: q for q in problem.parameters}
    names = [name for name in first if name in own or name in problem.implicit]
    found = dict(first)
    for name in names:
        ratio = WIDEST ** source.uniform(-1, 1)
        given = name in own and name not in problem.implicit  # a start that is not declared is on the side of the sample
        flipped = given and own[name].sign == "real" and source.random() < 0.5
        found[name] = first[name] * ratio * (-1 if flipped else 1)
    for _ in range(TRIES):
        broken = [name for name in names if not _keeps(study, name, found)]
        if not broken:
            break
        for name in broken:
            found[name] = _within(study, name, found, source, first[name])
    else:
        return None
    for coordinate in problem.coordinates:
        found[coordinate.name] = _middle(coordinate, found)
        found[f"{coordinate.name}_dot"] = _speed(coordinate, found)
    return found | {"t": 0.0}


def bounds(study: Study, name: str, numbers: Numbers) -> tuple[float | None, float | None]:
    """The declared range of a parameter or coordinate at these numbers."""
    low, high = (None if e is None else number(e, numbers) for e in study.assumptions.ranges.get(name, (None, None)))
    return (0.0 if low is None and study.assumptions.sign_of(name) == "positive" else low), high


def _keeps(study: Study, name: str, numbers: Numbers) -> bool:
    try:
        low, high = bounds(study, name, numbers)
    except (ValueError, ZeroDivisionError):  # a root of what is negative while other bounds are not yet kept
        return False
    room = EDGE * (high - low) if None not in (low, high) else 0.0
    value = numbers[name]
    return (low is None or value > low + room) and (high is None or value < high - room)


def _within(study: Study, name: str, numbers: Numbers, source: random.Random, first: float) -> float:
    """A number in the range: anywhere between two bounds, beyond the one bound by a ratio as of the others."""
    try:
        low, high = bounds(study, name, numbers)
    except (ValueError, ZeroDivisionError):
        return first * WIDEST ** source.uniform(-1, 1)
    if None not in (low, high):
        return low + source.uniform(EDGE, 1 - EDGE) * (high - low)
    ratio = WIDEST ** source.uniform(-1, 1)
    size = abs(low if low is not None else high) or abs(first)
    return low + size * ratio if low is not None else high - size * ratio
