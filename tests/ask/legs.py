"""The motion in maximal coordinates through all phases, each ended by its own event, and what was watched on the way."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from rbpsym.ask.asked import Asked
from rbpsym.errors import RbpsymError
from rbpsym.frozen import replace
from rbpsym.mechanics.friction import senses
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.pushing import begins as supposed
from rbpsym.mechanics.study import Study
from rbpsym.numeric.integration import Event, Trajectory, followed
from rbpsym.oracles.simulation import Bench
from rbpsym.oracles.simulation_phases import WATCHES, End, struck
from rbpsym.oracles.simulation_placement import Start
from rbpsym.statement.model import Phase
from tests.oracles.compare import _bench, _goes_as_told
from tests.oracles.motion import Watch, _moves, _ranges, _scale, declared_start, watches

LONGEST, LOOKS, MOST, FAR, LEFT = 30.0, 160, 400, 1e-5, 1e-6
FAINT = 1e-9  # a speed that is none
DISTINCT = 1e13  # the condition of equations that tell their forces apart
PHASE = 10  # times that a phase is followed to its own event
LATE, CUT, TURNED = "it is not followed any longer", "it ends", "it has turned twice"


class Undecided(Exception):
    """The simulation does not decide what is asked for at these numbers."""


class Ended(Exception):
    """What is asked for does not come as it is told, with the reason."""


@dataclass(frozen=True, eq=False)
class Leg:
    """A phase as far as it was followed: its place among the phases, the bench, how it began, its path, how its regime ended."""

    place: int
    bench: Bench
    watched: Mapping[tuple[str, str], Watch]
    path: Trajectory
    near: np.ndarray
    clock: float
    end: float
    broken: str = ""

    @cached_property
    def looks(self) -> list[tuple[float, np.ndarray, dict[str, float]]]:
        """(time, coordinates, names) at many times."""
        near, found = self.near, []
        for time in np.linspace(0.0, self.end, LOOKS):
            near = self.bench.placement.coordinates(self.path.at(time)[: self.bench.equations.size].tolist(), near)
            found.append((float(time), near, self._named(time, near)))
        return found

    def names(self, time: float) -> dict[str, float]:
        """All that the simulation knows at a time: parameters, places, speeds, accelerations, forces, t."""
        return self._named(time, next((q for at, q, _ in reversed(self.looks) if at <= time), self.near))

    def _named(self, time: float, near: np.ndarray) -> dict[str, float]:
        bench, state = self.bench, self.path.at(time)
        size = bench.equations.size
        where, speed = state[:size].tolist(), state[size : 2 * size].tolist()
        bench.placement.mechanism.clock = float(state[-1])
        balance = bench.equations.at(state[:size], state[size : 2 * size])
        q, rates = bench.placement.state(where, speed, near)
        gained = bench.placement.accelerations(q, rates, where, speed, balance.gained)
        known = {**bench.placement.numbers(q, rates), "t": float(state[-1]), "pi": math.pi}
        known |= {f"{n}_ddot": float(a) for n, a in zip(bench.placement.names, gained, strict=True)}
        forces = (item.multiplier for item in bench.equations.kept)
        return known | dict(zip(forces, balance.multipliers.tolist(), strict=True))


def first_change(leg: Leg, watch: Callable[[float, dict[str, float]], float]) -> float | None:
    """The first time at which it changes its sign."""
    from scipy.optimize import brentq

    values = [(time, watch(time, names)) for time, _, names in leg.looks]
    size = max(1e-6, *(abs(value) for _, value in values))
    begun = next((k for k, (_, value) in enumerate(values) if abs(value) > 1e-9 * size), len(values))
    for (low, a), (high, b) in zip(values[begun:], values[begun + 1 :], strict=False):
        if a * b < 0:
            return float(brentq(lambda time: watch(time, leg.names(time)), low, high, xtol=1e-13))
        if abs(b) <= 1e-9 * size:
            return high
    return None


def turns(leg: Leg) -> float:
    """The time until a coordinate turns round, or the end."""
    speeds = [[names[f"{n}_dot"] for n in leg.bench.derived.system.independent] for _, _, names in leg.looks]
    pairs = zip(leg.looks[1:], speeds, speeds[1:], strict=False)
    turned = (look[0] for look, a, b in pairs if any(x * y < 0 and abs(x) > FAINT for x, y in zip(a, b, strict=True)))
    return next(turned, leg.end)


def lasts(asked: Asked, leg: Leg, time: float) -> None:
    """Raises Ended where the stated regime ends before: a contact pulls, grips give way, a slip turns, a range is left."""
    scale, room, near = _scale(leg.bench, leg.path.at(0.0)), _ranges(leg.bench, asked.study(leg.place)), [leg.near]
    for at, _, _ in leg.looks:
        if 0 < at >= time * (1 - 1e-6):
            break
        state, said = leg.path.at(at), f"at t = {at:.4g} of {time:.4g} in phase {asked.names[leg.place]}"
        for (kind, of), value in leg.watched.items():
            if value(state) < -LEFT * scale[kind]:
                raise Undecided(f"the string {of} runs out") if kind == "string" else Ended(f"{kind} {of} {said}")
        leg.bench.placement.mechanism.clock = float(state[-1])
        for key, left in room(state, near).items():
            if left < -LEFT:
                raise Ended(f"range {key[1]} {said}")


def legs_of(asked: Asked, numbers: Mapping[str, float]) -> list[Leg]:
    """The phases one after the other, each by its own event."""
    legs, clock, begun = [], 0.0, None
    for place, name in enumerate(asked.names):
        try:
            study = asked.study(place)
            bench = _bench(study, numbers)
        except (ValueError, ZeroDivisionError) as error:
            raise Ended(f"the phase {name} has no start: {error}") from None
        begun = begun or _declared(study, bench, numbers)
        phase = asked.problem.phases[place] if place + 1 < len(asked.names) else None
        leg = _leg(study, bench, begun, phase, place, clock)
        legs.append(leg)
        if phase is None or leg.broken:
            return legs
        done, size = leg.path.at(leg.end), bench.equations.size
        bench.placement.mechanism.clock = 0.0
        try:
            following = _bench(asked.study(place + 1), numbers)
        except (RbpsymError, ValueError, ZeroDivisionError):
            return legs
        after, _ = struck(bench, following, End(leg.end, done[:size], done[size : 2 * size]), phase.impulses)
        q = leg.looks[-1][1]
        begun, clock = (
            replace(begun, where=done[:size], speed=after, q=q, rates=bench.placement.speeds(q, done[:size], after)),
            clock + leg.end,
        )
    return legs


def _declared(study: Study, bench: Bench, numbers: Mapping[str, float]) -> Start:
    start = declared_start(bench)
    if start is None:
        raise Undecided("no start is declared in full")
    known = study.system.scope.start
    if any(n in known and abs(q - number(known[n], numbers)) > 1 for n, q in zip(bench.placement.names, start.q, strict=True)):
        raise Undecided("its angles are counted from another turn")
    _goes_as_told(study, bench.sample)
    if any(number(one.value, numbers) <= 0 for one in supposed(study) if one.op == ">"):
        raise Undecided("what is supposed of the start does not hold")
    where, speed = start.where.tolist(), start.speed.tolist()
    rows = [item.at(where, speed) for item in bench.equations.kept]
    if np.linalg.cond(bench.equations._matrix(rows, where, speed)) > DISTINCT:
        raise Undecided("statics does not tell its forces apart")
    return start


def _leg(study: Study, bench: Bench, begun: Start, phase: Phase | None, place: int, clock: float) -> Leg:
    """One phase from its start to its event, to where its regime ends, or (the last one) to where it has turned twice."""
    size, step = bench.equations.size, bench.usual_time(begun)
    state = np.concatenate([begun.where, begun.speed, [0.0]])
    bench.placement.mechanism.clock = 0.0
    watched = watches(bench, study)
    if phase is not None and phase.event == "at once":
        return Leg(place, bench, watched, followed(bench.rate(), state, step * 1e-3), begun.q, clock, 0.0)
    own = WATCHES[phase.event](bench, phase, begun) if phase else lambda *state: 1.0
    scale, room, near = _scale(bench, state), _ranges(bench, study), [begun.q]
    kept = [Event(lambda time, s, v=v, n=scale[key[0]]: v(s) / n + FAR) for key, v in watched.items()]

    def left(time: float, state: np.ndarray) -> float:
        bench.placement.mechanism.clock = time
        return min([*room(state, near).values(), 1.0]) + FAR

    def speed(time: float, state: np.ndarray) -> float:
        q, rates = bench.placement.state(state[:size].tolist(), state[size : 2 * size].tolist(), near[0])
        near[0] = q
        return float(rates[bench.placement.names.index(study.system.independent[0])])

    if phase is None and study.system.independent and not _moves(bench, begun):
        raise Undecided("at rest it may go either way")
    whole = len(study.system.independent) == 1 and not study.system.has_clock and phase is None
    ends = [Event(lambda time, s: own(time, s[:size], s[size : 2 * size])), *kept, Event(left)]
    most = 1 if senses(study.system) else 2  # what rubs or brakes has the stated sense until then
    ends += [Event(speed, most)] if whole else []
    path = followed(
        bench.rate(),
        state,
        LONGEST * step * (PHASE if phase else 1),
        events=ends,
        longest=step,
        tolerances=(1e-11, 1e-13),
        most=MOST,
    )
    turned, cut = whole and len(path.seen[-1]) == most, any(path.seen[1 : 2 + len(kept)])
    broken = "" if phase and path.seen[0] else CUT if cut else TURNED if turned else LATE
    end = _cut(path, [*watched.values()]) if broken == CUT else path.times[-1]
    return Leg(place, bench, watched, path, begun.q, clock, end, broken)


def _cut(path: Trajectory, kept: list[Watch]) -> float:
    """Where the first of what is watched vanishes in the last step: its event comes a little later, for the sake of rounding."""
    from scipy.optimize import brentq

    low, high = path.times[-2:]
    ends = [value for value in kept if value(path.at(low)) > 0 > value(path.at(high))]
    return min((float(brentq(lambda time, v=v: v(path.at(time)), low, high, xtol=1e-14)) for v in ends), default=high)
