"""The work of a force on a body as its power added up along the motion."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.document.plots.evaluation import Evaluator
from rbpsym.document.plots.motion import Journey, Leg
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.study import Study


def work_done(way: Journey, force: str, body: str, half: str) -> list[float]:
    """∫F·V_cm dt ("T") or ∫τ_cm ω dt ("theta") from the very start; a phase goes on where the last one ended."""
    done = 0.0

    def of(leg: Leg) -> list[float]:
        nonlocal done
        found = [done + value for value in added_up(leg.moments.times, powers(leg, force, body, half))]
        done = found[-1]
        return found

    return way.joined(of)


def powers(leg: Leg, force: str, body: str, half: str) -> list[float]:
    """The power at each moment, with the unknown forces of that moment."""
    value = power(leg.study, force, body, half)
    if not value:
        return [0.0] * len(leg.moments.times)
    evaluate = Evaluator({"": value})
    return [evaluate(numbers)[""] for numbers in leg.numbers]


def power(study: Study, force: str, body: str, half: str) -> Scalar:
    """F·V_cm or τ_cm ω of all parts of a force on a body."""
    state = study.system.bodies[body]
    parts = [one for one in study.system.forces if (one.name, one.on) == (force, body)]
    if half == "T":
        return sum((one.vector.dot(state.velocity) for one in parts if one.vector), NOTHING)
    return sum((torque_about_center(one, state) for one in parts), NOTHING) * state.omega


def added_up(times: Sequence[float], values: Sequence[float]) -> Iterator[float]:
    """The integral from the first moment to each: over two stretches of time the parabola through three values."""
    total = 0.0
    yield total
    for k in range(1, len(times)):
        near = range(k - 1, k + 2) if k + 1 < len(times) else range(max(k - 2, 0), k + 1)
        total += parabola([times[n] for n in near], [values[n] for n in near], times[k - 1], times[k])
        yield total


def parabola(times: Sequence[float], values: Sequence[float], low: float, high: float) -> float:
    """The integral from `low` to `high` of the curve of least degree through two or three points (Simpson's rule)."""
    middle = (low + high) / 2
    inside = [through(times, values, time) for time in (low, middle, high)]
    return (high - low) / 6 * (inside[0] + 4 * inside[1] + inside[2])


def through(times: Sequence[float], values: Sequence[float], time: float) -> float:
    """The value at a time of the curve of least degree through some points (Lagrange)."""
    total = 0.0
    for k, value in enumerate(values):
        for n, other in enumerate(times):
            if n != k:
                value *= (time - other) / (times[k] - other) if times[k] != other else 0.5
        total += value
    return total
