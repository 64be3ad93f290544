"""Dormand and Prince's method of order 5 with its error of order 4: a step, and a stretch of time with steps as needed."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

State = tuple[float, ...]
Rate = Callable[[float, State], State]

NODES = (0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0)
STAGES = (
    (),
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)
FOURTH = (5179 / 57600, 0.0, 7571 / 16695, 393 / 640, -92097 / 339200, 187 / 2100, 1 / 40)
GAPS = tuple(a - b for a, b in zip((*STAGES[6], 0.0), FOURTH, strict=True))
TOLERANCE = 1e-7
SMALLEST = 1e-7  # of the stretch: below it there is no solution to be followed


def step(rate: Rate, time: float, state: State, size: float) -> tuple[State, float]:
    """The state after a step, and its error as a multiple of the tolerance."""
    slopes: list[State] = []
    after = state
    for node, weights in zip(NODES, STAGES, strict=True):
        after = moved(state, slopes, weights, size)
        slopes.append(rate(time + node * size, after))
    gaps = moved((0.0,) * len(state), slopes, GAPS, size)
    return after, max(
        (abs(gap) / (TOLERANCE * max(1e-3, abs(q))) for gap, q in zip(gaps, after, strict=True)), default=0
    )


def moved(state: State, slopes: list[State], weights: tuple[float, ...], size: float) -> State:
    """The state moved along a mean of slopes."""
    return tuple(
        value + size * sum(w * slope[k] for w, slope in zip(weights, slopes, strict=True))
        for k, value in enumerate(state)
    )


def advance(rate: Rate, time: float, state: State, size: float) -> State | None:
    """The state after a stretch of time, in as many steps as the tolerance wants; None where there is none."""
    parts = 1
    while parts * SMALLEST < 1:
        found = in_parts(rate, time, state, size, parts)
        if found is not None:
            return found
        parts *= 4
    return None


def in_parts(rate: Rate, time: float, state: State, size: float, parts: int) -> State | None:
    """The state after equal steps; None if one of them is not accurate."""
    moments = [time + size * k / parts for k in range(parts + 1)]
    for begin, end in pairwise(moments):
        try:
            state, error = step(rate, begin, state, end - begin)
        except OverflowError:
            return None
        if not error <= 1:
            return None
    return state


def solved(rows: list[list[float]], right: list[float]) -> State:
    """The solution of a small linear system (Gauss with pivots)."""
    count = len(right)
    table = [[*row, value] for row, value in zip(rows, right, strict=True)]
    for k in range(count):
        pivot = max(range(k, count), key=lambda r: abs(table[r][k]))
        table[k], table[pivot] = table[pivot], table[k]
        for r in range(count):
            if r != k:
                share = table[r][k] / table[k][k]
                table[r] = [a - share * b for a, b in zip(table[r], table[k], strict=True)]
    return tuple(table[k][count] / table[k][k] for k in range(count))
