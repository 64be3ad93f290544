"""The motion in numbers: positions and speeds step by step from the accelerations that were derived.

A step is a small part of the time in which the system moves by its own size; its accuracy is that of
`integrator`. Conditions that stay as equations hold at the start and are kept by the rates.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from rbpsym.algebra.calculus import derivative
from rbpsym.algebra.evaluate import time_derivative
from rbpsym.algebra.scalar import NOTHING
from rbpsym.document.plots.evaluation import Evaluator
from rbpsym.document.plots.integrator import State, advance, solved
from rbpsym.document.plots.trajectory import Numbers, Trajectory, at
from rbpsym.errors import NotApplicable
from rbpsym.mechanics.numbers import bound, sample
from rbpsym.mechanics.study import Study
from rbpsym.quantities import LENGTH, NUMBER

STEP = 0.08
MOST = 900  # steps, shared by the coordinates
LONG = 60  # paces
PUSH = 0.02  # of its size is what rests at an unstable place displaced by
TURNINGS = 4  # of the first coordinate, after which an oscillation has been seen: two periods
SHAKEN = 20  # the same where a given motion drives it
SEVERAL = 8  # the same where several coordinates oscillate
FAR = 2 * math.pi  # how many sizes of its own a coordinate may move; twice as many where it is driven
STILL = 1e-9
LEAST = 80  # steps in a time that is known
REST = "nothing moves"
ROOT = 14  # tries to find the moment of an event

Stop = Callable[[Numbers], float]  # its sign changes where the motion is to end


@dataclass(frozen=True)
class Run:
    """One integration: a system with its numbers, and when it ends."""

    study: Study
    numbers: dict[str, float]
    end: float
    stop: Stop | None = None

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What is integrated: the coordinates that are no closed form of others, then the independent speeds."""
        return (*self.study.system.coordinates, *self.study.system.speeds)

    @cached_property
    def shown(self) -> tuple[str, ...]:
        """The coordinates that are shown: the independent ones, or all where everything is driven."""
        system = self.study.system
        return tuple(system.independent) or tuple(c.name for c in self.study.problem.coordinates)

    @cached_property
    def sizes(self) -> dict[str, float]:
        """How far a coordinate moves in a step of size one: a radian, or a length of the problem."""
        quantities = self.study.problem.parameters
        lengths = [self.numbers[q.name] for q in quantities if q.dimension == LENGTH and self.numbers.get(q.name)]
        length = abs(lengths[0]) if lengths else 1.0
        kinds = {c.name: c.quantity.dimension for c in self.study.problem.coordinates}
        return {name: 1.0 if kind == NUMBER else length for name, kind in kinds.items()}

    @cached_property
    def others(self) -> Evaluator:
        """The dependent coordinates, then the speed of each coordinate that is not independent."""
        system, found = self.study.system, dict(self.study.system.dependent)
        for name in (c.name for c in self.study.problem.coordinates):
            if f"{name}_dot" not in system.speeds:
                rate = system.scope.rates.get(name)
                closed = system.dependent.get(name, NOTHING)
                found[f"{name}_dot"] = time_derivative(closed, system.scope) if rate is None else rate
        return Evaluator(found)

    @cached_property
    def gains(self) -> Evaluator:
        """The accelerations where they have short closed formulas, else the entries of M and f of M q̈ = f."""
        dynamics = self.study.dynamics
        entries = [*(value for row in dynamics.mass_matrix for value in row), *dynamics.forcing]
        if dynamics.accelerations is not None:
            closed = Evaluator({name: dynamics.accelerations[name] for name in self.study.system.accelerations})
            if closed.size <= 2 * Evaluator(dict(enumerate(entries))).size:
                return closed
        return Evaluator({f"[{k}]": value for k, value in enumerate(entries)})

    def start(self) -> State:
        """Where the motion starts; what the author left open is where the conditions that stay want it."""
        scope, guess = self.study.system.scope.start, sample(self.study.problem) | self.numbers
        found = tuple(
            at(scope[name], self.numbers) if name in scope else 0.0 if name.endswith("_dot") else guess[name]
            for name in self.names
        )
        if not all(map(math.isfinite, found)):
            raise NotApplicable("the start has no numbers")
        return self.fitted(found)

    def fitted(self, state: State) -> State:
        """The state whose open coordinate keeps the one condition that stays (Newton's method)."""
        system = self.study.system
        open_ = [n for n in system.coordinates if n not in system.independent and n not in system.scope.start]
        if len(system.implicit) != 1 or len(open_) != 1:
            return state
        place, gap = self.names.index(open_[0]), system.implicit[0].value
        slope = derivative(gap, open_[0])
        for _ in range(40):
            numbers = self.numbers_at(0.0, state)
            move = at(gap, numbers) / (at(slope, numbers) or 1.0)
            state = (*state[:place], state[place] - move, *state[place + 1 :])
        return state

    def numbers_at(self, time: float, state: State) -> dict[str, float]:
        """All numbers of a moment, those of dependent coordinates and speeds too."""
        found = self.numbers | {"t": time} | dict(zip(self.names, state, strict=True))
        return found | self.others(found)

    def rates(self, time: float, state: State) -> State:
        """Speeds and accelerations."""
        numbers, system = self.numbers_at(time, state), self.study.system
        speeds = tuple(numbers[f"{name}_dot"] for name in system.coordinates)
        return speeds + self.accelerations(numbers)

    def accelerations(self, numbers: Numbers) -> State:
        """From the closed formulas, or from M q̈ = f where there are none."""
        found, count = tuple(self.gains(numbers).values()), len(self.study.system.accelerations)
        if len(found) == count:
            return found
        rows = [list(found[k * count : (k + 1) * count]) for k in range(count)]
        return solved(rows, list(found[count * count :]))

    def after(self, time: float, state: State, span: float) -> State | None:
        """The state a little later; None where there is none."""
        return advance(self.rates, time, state, span)

    def pace(self, time: float, state: State) -> float:
        """The time in which the fastest coordinate moves by its size; infinite if nothing moves."""
        paces = [math.inf]
        for name, speed, gain in self.speeds_and_gains(time, state):
            size = self.sizes[name]
            paces += [size / abs(speed)] if abs(speed) > STILL * size else []
            paces += [math.sqrt(size / abs(gain))] if abs(gain) > STILL * size else []
        return min(paces)

    def speeds_and_gains(self, time: float, state: State) -> Iterator[tuple[str, float, float]]:
        """Each coordinate that is shown, its speed, and its acceleration (by a difference where all is driven)."""
        numbers, system = self.numbers_at(time, state), self.study.system
        if system.independent:
            gains = dict(zip(system.independent, self.accelerations(numbers), strict=True))
        else:
            later = self.after(time, state, 1e-4)
            ahead = self.numbers_at(time + 1e-4, later or state)
            gains = {n: (ahead[f"{n}_dot"] - numbers[f"{n}_dot"]) / 1e-4 for n in self.shown}
        yield from ((name, numbers[f"{name}_dot"], gains[name]) for name in self.shown)

    def pushed(self, state: State) -> State:
        """The start; what rests where the forces balance is displaced a little. Raises NotApplicable if it stays."""
        if math.isfinite(self.pace(0.0, state)):
            return state
        for sign in (1, -1):
            after = list(state)
            for name in self.study.system.independent:
                after[self.names.index(name)] += sign * PUSH * self.sizes[name]
            if math.isfinite(self.pace(0.0, tuple(after))) and self.share_inside(0.0, tuple(after), state) == 1:
                return tuple(after)
        raise NotApplicable(REST)

    def all(self, state: State) -> Trajectory:
        """The moments up to the end: the time, the stop, the end of a range, far away, or two periods."""
        times, raw, turns = [0.0], [state], []
        while len(raw) < MOST / len(self.shown) and times[-1] < self.latest(state) and not self.is_enough(turns):
            size = min(self.stride(times[-1], raw[-1], state), self.latest(state) - times[-1])
            after = self.after(times[-1], raw[-1], size)
            if after is None or not all(map(math.isfinite, after)):
                break
            share, why = self.share(times[-1], raw[-1], size, after, turns, len(raw))
            after = after if share == 1 else self.after(times[-1], raw[-1], size * share) or raw[-1]
            times.append(times[-1] + size * share)
            raw.append(after)
            turns += [len(raw) - 1] if why == "turn" else []
            if why == "end" or self.is_far(state, times[-1], after):
                break
        return self.trajectory(times, raw, tuple(turns))

    @property
    def is_open(self) -> bool:
        """Is it left to the motion itself how long it is followed?"""
        return self.stop is None and not math.isfinite(self.end)

    def latest(self, start: State) -> float:
        """The time beyond which it is not followed."""
        return self.end if math.isfinite(self.end) else LONG * self.pace(0.0, start)

    def is_enough(self, turns: list[int]) -> bool:
        """Has an oscillation been seen long enough?"""
        if not self.is_open:
            return False
        shaken = self.study.system.has_clock and not self.study.squares
        return len(turns) >= (SHAKEN if shaken else TURNINGS if len(self.shown) == 1 else SEVERAL)

    def stride(self, time: float, now: State, start: State) -> float:
        """The length of a step; where the end is known, not less than a small part of the whole."""
        longest = 3 * self.pace(0.0, start) if self.is_open else math.inf
        least = self.end / LEAST if math.isfinite(self.end) else 0.0
        return max(least, min(STEP * self.pace(time, now), longest))

    def share(self, time: float, before: State, size: float, after: State, turns, count: int) -> tuple[float, str]:
        """The part of a step until something happens, and what: it ends, or turns back."""
        inside = self.share_inside(time + size, after, before)
        stopped = self.share_until(time, before, size, after)
        if min(inside, stopped) < 1:
            return min(inside, stopped), "end"
        if not self.study.system.independent or count <= (turns or [0])[-1] + 2:
            return 1.0, ""
        name = self.study.system.independent[0]
        place = self.names.index(f"{name}_dot")
        if before[place] * after[place] >= 0:
            return 1.0, ""
        return self.root(time, before, size, lambda numbers: numbers[f"{name}_dot"]), "turn"

    def share_until(self, time: float, before: State, size: float, after: State) -> float:
        """The part of a step until the stop changes its sign."""
        if self.stop is None:
            return 1.0
        one, two = self.stop(self.numbers_at(time, before)), self.stop(self.numbers_at(time + size, after))
        passes = one * two < 0 or (two == 0 and one != 0)
        return self.root(time, before, size, self.stop) if passes else 1.0

    def root(self, time: float, before: State, size: float, value: Stop) -> float:
        """The share of a step at which a number changes its sign (false position, after Illinois)."""
        ends = [(0.0, value(self.numbers_at(time, before)))]
        ends.append((1.0, self.value_at(time, before, size, 1.0, value)))
        for _ in range(ROOT):
            (low, one), (high, two) = ends
            share = (low * two - high * one) / (two - one) if one != two else high
            here = self.value_at(time, before, size, share, value)
            if here == 0 or high - low < 1e-12:
                return share
            ends = [(low, one / 2), (share, here)] if here * two > 0 else [(share, here), (high, two / 2)]
        return ends[1][0]

    def value_at(self, time: float, before: State, size: float, share: float, value: Stop) -> float:
        """A number after a share of a step."""
        state = self.after(time, before, size * share) or before
        return value(self.numbers_at(time + size * share, state))

    def share_inside(self, time: float, after: State, before: State) -> float:
        """The part of a step that stays inside the declared ranges."""
        numbers, earlier, share = self.numbers_at(time, after), self.numbers_at(time, before), 1.0
        for coordinate in self.study.problem.coordinates:
            name = coordinate.name
            for end, sign in ((coordinate.lower, -1), (coordinate.upper, 1)):
                limit, moved_by = bound(end, numbers), numbers[name] - earlier[name]
                if limit is not None and sign * (numbers[name] - limit) > 0 and sign * moved_by > 0:
                    share = min(share, max((limit - earlier[name]) / moved_by, 1e-6))
        return share

    def is_far(self, start: State, time: float, now: State) -> bool:
        """Has a coordinate gone far?"""
        if not self.is_open:
            return False
        one, two = self.numbers_at(0.0, start), self.numbers_at(time, now)
        far = FAR if self.study.system.independent else 2 * FAR
        return max(abs(two[name] - one[name]) / self.sizes[name] for name in self.shown) > far

    def trajectory(self, times: Sequence[float], raw: Sequence[State], turns: tuple[int, ...]) -> Trajectory:
        """The moments with all their numbers."""
        states = tuple(self.numbers_at(t, s) for t, s in zip(times, raw, strict=True))
        return Trajectory(self.shown, tuple(times), states, turns, tuple(raw), self)
