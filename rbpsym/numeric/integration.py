"""Motions integrated: Dormand and Prince's method of order 8 (scipy's), with events found on its dense output."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from rbpsym.errors import NotApplicable
from rbpsym.frozen import Frozen

if TYPE_CHECKING:
    from scipy.integrate import DenseOutput, OdeSolution

Rate = Callable[[float, np.ndarray], np.ndarray]
SMALL = 1e-9  # what counts as nothing before an event


class Event(Frozen):
    """A number of time and state that is watched for changes of its sign; the motion ends after so many of them."""

    value: Callable[[float, np.ndarray], float]
    most: float = 1


class Trajectory(Frozen):
    """A motion: the times at the ends of the steps, the times of each event, the state at any time between."""

    times: tuple[float, ...]
    seen: tuple[tuple[float, ...], ...]
    at: OdeSolution


def followed(
    rate: Rate,
    start: Sequence[float] | np.ndarray,
    end: float,
    *,
    events: Sequence[Event] = (),
    longest: float = math.inf,
    most: float = math.inf,
    tolerances: tuple[float, float] = (1e-12, 1e-14),
) -> Trajectory:
    """The motion from the time 0 to `end`, or to an event, a singularity or the last of the `most` steps.

    `longest`: of a step; `tolerances`: relative and absolute. Raises NotApplicable where not a step can be taken.
    """
    from scipy.integrate import DOP853, DenseOutput, OdeSolution

    first, (relative, absolute) = np.array(start, dtype=float), tolerances
    times, pieces, seen = [0.0], list[DenseOutput](), [list[float]() for _ in events]
    before = [event.value(0.0, first) for event in events]
    with np.errstate(all="ignore"):  # close to a singularity numbers overflow, and the step gets shorter
        solver = DOP853(_quiet(rate), 0.0, first, end, rtol=relative, atol=absolute, max_step=longest)
        while solver.status == "running" and len(pieces) < most and np.isfinite(solver.f).all():
            solver.step()
            if solver.status == "failed":
                break
            pieces.append(solver.dense_output())
            after = [event.value(solver.t, solver.y) for event in events]
            times.append(_noted(events, before, after, pieces[-1], seen))
            if times[-1] < solver.t:
                break
            before = after
    if not pieces:
        raise NotApplicable("the motion does not get beyond the time 0")
    return Trajectory(tuple(times), tuple(map(tuple, seen)), OdeSolution([*times[:-1], pieces[-1].t], pieces))


def _quiet(rate: Rate) -> Rate:
    """The rate, not a number where there is none."""

    def quiet(time: float, state: np.ndarray) -> np.ndarray:
        try:
            return rate(time, state)
        except (OverflowError, np.linalg.LinAlgError):
            return np.full_like(state, math.nan)

    return quiet


def _noted(
    events: Sequence[Event], before: list[float], after: list[float], dense: DenseOutput, seen: list[list[float]]
) -> float:
    """Notes the events of a step in their order; returns the time at which the motion ends or the step does."""
    changed = [k for k, value in enumerate(before) if abs(value) > SMALL and value * after[k] <= 0]
    for time, place in sorted((_root(events[k].value, before[k], dense), k) for k in changed):
        seen[place].append(time)
        if len(seen[place]) >= events[place].most:
            return time
    return float(dense.t)


def _root(value: Callable[[float, np.ndarray], float], before: float, dense: DenseOutput) -> float:
    """The time at which a number changes its sign in a step; its end where rounding hides that."""
    from scipy.optimize import brentq

    if before * value(dense.t, dense(dense.t)) > 0:
        return float(dense.t)
    return float(brentq(lambda time: value(time, dense(time)), dense.t_old, dense.t, xtol=1e-14, rtol=1e-14))
