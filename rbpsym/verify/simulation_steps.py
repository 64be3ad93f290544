"""The integrator of the oracle: Gragg's midpoint rule, extrapolated (Bulirsch and Stoer).

Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, II.9. It needs numpy alone: importing
scipy.integrate takes longer than all else that a derivation is made of.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from rbpsym.errors import NotApplicable

Rate = Callable[[float, np.ndarray], np.ndarray]

RTOL, ATOL = 1e-12, 1e-14
COLUMNS = 9  # of the table: an error of order 2 × COLUMNS at most
HALVINGS = 14


def over(rate: Rate, time: float, state: np.ndarray, step: float, halvings: int = HALVINGS) -> np.ndarray:
    """The state after a step, which is halved where the table does not settle.

    Raises NotApplicable where even the smallest part of it does not: the motion has come to a singularity.
    """
    try:
        with np.errstate(all="ignore"):  # close to a singularity numbers overflow, and the step is halved
            found = extrapolated(rate, time, state, step)
    except OverflowError:
        found = None
    if found is not None:
        return found
    if not halvings:
        raise NotApplicable(f"the simulation did not get beyond the time {time:.3g}")
    middle = over(rate, time, state, step / 2, halvings - 1)
    return over(rate, time + step / 2, middle, step / 2, halvings - 1)


def extrapolated(rate: Rate, time: float, state: np.ndarray, step: float) -> np.ndarray | None:
    """The corner of Aitken and Neville's table in h²; None if its last two entries differ too much."""
    first, row = rate(time, state), []
    for k in range(1, COLUMNS + 1):
        before, row = row, [midpoint(rate, time, state, first, step, 2 * k)]
        for j, known in enumerate(before, 1):
            row.append(row[-1] + (row[-1] - known) / ((k / (k - j)) ** 2 - 1))
        if k > 2 and is_settled(row[-1], row[-2]):
            return row[-1]
    return None


def midpoint(rate: Rate, time: float, state: np.ndarray, first: np.ndarray, step: float, count: int) -> np.ndarray:
    """Gragg's smoothed midpoint rule with an even number of parts; `first` is the rate at the beginning."""
    part = step / count
    last, now = state, state + part * first
    for k in range(1, count):
        last, now = now, last + 2 * part * rate(time + k * part, now)
    return (last + now + part * rate(time + step, now)) / 2


def is_settled(one: np.ndarray, other: np.ndarray) -> bool:
    """Are two entries the same up to the tolerance? (Not where one is no number.)"""
    return bool(np.all(np.abs(one - other) <= ATOL + RTOL * np.maximum(np.abs(one), np.abs(other))))
