"""The moments of a motion as numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from rbpsym.algebra.scalar import Scalar
from rbpsym.document.plots.evaluation import Evaluator
from rbpsym.document.plots.integrator import State
from rbpsym.errors import NoNumber
from rbpsym.mechanics.numbers import number

if TYPE_CHECKING:
    from rbpsym.document.plots.running import Run

Numbers = Mapping[str, float]


@dataclass(frozen=True)
class Trajectory:
    """Moments of a motion: `times`, and `states` as numbers by name (coordinates, speeds, parameters).

    `turns` are the moments at which the first coordinate turned back; `raw` what is integrated.
    """

    coordinates: tuple[str, ...]
    times: tuple[float, ...]
    states: tuple[Numbers, ...]
    turns: tuple[int, ...] = ()
    raw: tuple[State, ...] = ()
    run: Run | None = field(default=None, repr=False, compare=False)

    def part(self, count: int) -> Trajectory:
        """The first moments."""
        return replace(self, times=self.times[:count], states=self.states[:count], raw=self.raw[:count])

    def values(self, value: Scalar) -> list[float]:
        """A quantity at all moments; not a number where it has none."""
        evaluate = Evaluator({"": value})
        return [evaluate(state)[""] for state in self.states]

    def with_more(self, parts: Sequence[int]) -> Trajectory:
        """The same with each stretch between two moments divided into so many parts."""
        times, raw, places = [self.times[0]], [self.raw[0]], [0]
        for k, count in enumerate(parts):
            span = self.times[k + 1] - self.times[k]
            for share in range(1, count):
                times.append(self.times[k] + span * share / count)
                raw.append(self.run.after(self.times[k], self.raw[k], span * share / count) or self.raw[k])
            times.append(self.times[k + 1])
            raw.append(self.raw[k + 1])
            places.append(len(raw) - 1)
        turns = tuple(places[turn] for turn in self.turns if turn < len(places))
        return self.run.trajectory(times, raw, turns)


def at(value: Scalar, numbers: Numbers) -> float:
    """A quantity at one moment."""
    try:
        return float(number(value, numbers))
    except NoNumber:
        return math.nan


def crossings(values: Sequence[float]) -> Iterator[int]:
    """Places before which a quantity changes its sign."""
    for place in range(1, len(values)):
        if values[place - 1] > 0 >= values[place]:
            yield place
