"""The motion in numbers: positions and speeds step by step from the accelerations that were derived.

Classical Runge–Kutta; a step is a small part of the time in which the system moves by its own size.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import Scalar
from rbpsym.errors import NotApplicable, RbpsymError
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.study import Study
from rbpsym.quantities import LENGTH, NUMBER

STEP = 0.05
MOST = 900  # steps, shared by the coordinates
LONG = 60  # paces
PUSH = 0.02  # of its size is what rests at an unstable place displaced by
TURNINGS = 4  # after which an oscillation has been seen: two periods
FAR = 2 * math.pi  # how many sizes of its own a coordinate may move
STILL = 1e-9

State = tuple[float, ...]  # positions, then speeds, of the independent coordinates


@dataclass(frozen=True)
class Trajectory:
    """Moments of a motion: `times`, and `states` as numbers by name (coordinates, speeds, parameters).

    `turned` is how often the one coordinate of a system turned back; the first time at `first_turn`.
    """

    coordinates: tuple[str, ...]
    times: tuple[float, ...]
    states: tuple[Mapping[str, float], ...]
    turns: tuple[int, ...] = ()

    def until_turn(self) -> Trajectory:
        """The motion up to where it turns back for the first time."""
        return self.part(self.turns[0] + 1) if self.turns else self

    def part(self, count: int) -> Trajectory:
        """The first moments."""
        return replace(self, times=self.times[:count], states=self.states[:count])

    def values(self, value: Scalar) -> list[float]:
        """A quantity at all moments; not a number where it has none."""
        return [at(value, state) for state in self.states]


def at(value: Scalar, numbers: Mapping[str, float]) -> float:
    """A quantity at one moment."""
    try:
        return float(number(value, numbers))
    except (ValueError, ZeroDivisionError, OverflowError):
        return math.nan


def trajectory(study: Study, numbers: Mapping[str, float], end: float = math.inf) -> Trajectory:
    """The motion from the start up to the time `end`. Raises NotApplicable where the start or the accelerations are not known."""
    names = movable(study)
    run = _Run(study, names, dict(numbers), sizes(study, names, numbers), end)
    return run.all(run.start())


def movable(study: Study) -> tuple[str, ...]:
    """The independent coordinates. Raises NotApplicable if the motion can't be followed."""
    system = study.system
    if system.implicit or system.speed_ties or not study.dynamics.accelerations:
        raise NotApplicable("the accelerations are not functions of independent coordinates alone")
    if any(name not in system.scope.start for name in system.independent):
        raise NotApplicable("the statement does not say where the motion starts")
    return tuple(system.independent)


def sizes(study: Study, names: Sequence[str], numbers: Mapping[str, float]) -> dict[str, float]:
    """How far a coordinate moves in a step of size one: a radian, or a length of the problem."""
    quantities = study.problem.parameters
    lengths = [numbers[q.name] for q in quantities if q.dimension == LENGTH and numbers.get(q.name)]
    length = abs(lengths[0]) if lengths else 1.0
    kinds = {c.name: c.quantity.dimension for c in study.problem.coordinates}
    return {name: 1.0 if kinds[name] == NUMBER else length for name in names}


@dataclass(frozen=True)
class _Run:
    """One integration."""

    study: Study
    names: tuple[str, ...]
    numbers: dict[str, float]
    sizes: Mapping[str, float]
    end: float

    def start(self) -> State:
        scope = self.study.system.scope.start
        found = [at(scope[name], self.numbers) for name in self.names]
        found += [at(scope[f"{name}_dot"], self.numbers) if f"{name}_dot" in scope else 0.0 for name in self.names]
        if not all(map(math.isfinite, found)):
            raise NotApplicable("the start has no numbers")
        return tuple(found)

    def numbers_at(self, time: float, state: State) -> dict[str, float]:
        """All numbers of a moment, those of dependent coordinates too."""
        count = len(self.names)
        found = dict(self.numbers) | {"t": time}
        found |= dict(zip(self.names, state[:count], strict=True))
        found |= {f"{name}_dot": speed for name, speed in zip(self.names, state[count:], strict=True)}
        for name, value in self.study.system.dependent.items():
            found[name] = at(value, found)
        return found

    def rates(self, time: float, state: State) -> State:
        """Speeds and accelerations."""
        numbers, gains = self.numbers_at(time, state), self.study.dynamics.accelerations
        found = tuple(at(gains[f"{name}_ddot"], numbers) for name in self.names)
        return (*state[len(self.names) :], *found)

    def step(self, time: float, state: State, size: float) -> State:
        """The state a little later."""
        one = self.rates(time, state)
        two = self.rates(time + size / 2, moved(state, one, size / 2))
        three = self.rates(time + size / 2, moved(state, two, size / 2))
        four = self.rates(time + size, moved(state, three, size))
        mean = tuple((a + 2 * b + 2 * c + d) / 6 for a, b, c, d in zip(one, two, three, four, strict=True))
        return moved(state, mean, size)

    def pace(self, time: float, state: State) -> float:
        """The time in which the fastest coordinate moves by its size; infinite if nothing moves."""
        rates, count = self.rates(time, state), len(self.names)
        paces = [math.inf]
        for place, name in enumerate(self.names):
            size, speed, gain = self.sizes[name], abs(rates[place]), abs(rates[count + place])
            paces += [size / speed] if speed > STILL * size else []
            paces += [math.sqrt(size / gain)] if gain > STILL * size else []
        return min(paces)

    def pushed(self, state: State) -> State:
        """The start; what rests where the forces balance is displaced a little. Raises NotApplicable if it stays."""
        if math.isfinite(self.pace(0.0, state)):
            return state
        for sign in (1, -1):
            after = (
                tuple(q + sign * PUSH * self.sizes[n] for n, q in zip(self.names, state, strict=False))
                + state[len(self.names) :]
            )
            if math.isfinite(self.pace(0.0, after)) and self.share_inside(0.0, after, state) == 1:
                return after
        raise NotApplicable("nothing moves")

    def all(self, state: State) -> Trajectory:
        """The moments up to the end of the range, far away, or after two periods."""
        state = self.pushed(state)
        first = self.pace(0.0, state)
        times, states, turns, time = [0.0], [state], [], 0.0
        while len(states) < MOST / len(self.names) and len(turns) < TURNINGS and time < min(self.end, LONG * first):
            size = STEP * min(self.pace(time, state), 40 * first)
            size = min(size, self.end - time)
            after = self.step(time, state, size)
            if not all(map(math.isfinite, after)):
                break
            share = self.share_inside(time + size, after, state)
            turned = len(self.names) == 1 and state[1] * after[1] < 0 and len(states) > (turns or [0])[-1] + 2
            if turned or share < 1:
                share = min(share, state[1] / (state[1] - after[1])) if turned else share
                size *= share
                after = self.step(time, state, size)
            time, state = time + size, after
            times.append(time)
            states.append(state)
            if turned:
                turns.append(len(states) - 1)
            elif share < 1 or self.is_far(states[0], state):
                break
        moments = tuple(self.numbers_at(t, s) for t, s in zip(times, states, strict=True))
        return Trajectory(self.names, tuple(times), moments, tuple(turns))

    def share_inside(self, time: float, after: State, before: State) -> float:
        """The part of a step that stays inside the declared ranges."""
        numbers, share = self.numbers_at(time, after), 1.0
        for coordinate in self.study.problem.coordinates:
            if coordinate.name not in self.names:
                continue
            place = self.names.index(coordinate.name)
            for bound, sign in ((coordinate.lower, -1), (coordinate.upper, 1)):
                limit = math.nan if bound is None else _bound(bound, numbers)
                moved_by = after[place] - before[place]
                if sign * (after[place] - limit) > 0 and sign * moved_by > 0:
                    share = min(share, max((limit - before[place]) / moved_by, 1e-6))
        return share

    def is_far(self, start: State, now: State) -> bool:
        """Has every coordinate that moves gone far?"""
        gone = [abs(now[k] - start[k]) / self.sizes[name] for k, name in enumerate(self.names)]
        return max(gone) > FAR


def moved(state: State, rates: State, size: float) -> State:
    """The state after moving at constant rates."""
    return tuple(value + size * rate for value, rate in zip(state, rates, strict=True))


def _bound(node, numbers: Mapping[str, float]) -> float:
    try:
        return at(scalar(node), numbers)
    except (KeyError, RbpsymError):
        return math.nan


def crossings(values: Sequence[float]) -> Iterator[int]:
    """Places before which a quantity changes its sign."""
    for place in range(1, len(values)):
        if values[place - 1] > 0 >= values[place]:
            yield place
