"""The motion of a system in numbers, from the accelerations that were derived; or why there is none to be followed.

Conditions that stay as equations hold at the start and are kept by the rates.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from rbpsym.errors import NotApplicable
from rbpsym.field import Scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.arrivals import ArrivalState as Ending
from rbpsym.mechanics.compiled import compiled_accelerations
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.friction import slips, spare
from rbpsym.mechanics.numbers import bound
from rbpsym.mechanics.phases import known_stages
from rbpsym.mechanics.study import Study
from rbpsym.numeric.formulas import compiled
from rbpsym.numeric.integration import Event, followed
from rbpsym.pictures.plots.scales import Scales, scales
from rbpsym.pictures.pose import REASONS, Moving, at, reactions, require_motion
from rbpsym.proof.step import Derivation

PACES = 60  # of the start, at most
PARTS = 16  # moments in a step of the integration
MOST = 600  # steps
PUSH = 0.02  # of its size is what rests at an unstable place displaced by
TURNINGS = 4  # of the first coordinate, after which an oscillation has been seen: two periods
SHAKEN = 20  # the same where a given motion drives it
SEVERAL = 8  # the same where several coordinates oscillate
FAR = 2 * math.pi  # how many sizes of its own a coordinate may move; twice as many where it is driven
EDGE = 1e-8  # what starts so near to the end of its range may go so far beyond it
TOLERANCES = 1e-9, 1e-11

Numbers = Mapping[str, Any]  # a number, or an array of one for each moment
State = np.ndarray  # coordinates that are no closed form of others, independent speeds, the time


class Flow(Moving):
    """The same with arrays: many states as columns."""

    @cached_property
    def _defined(self) -> tuple[tuple[str, ...], Callable[[Numbers], np.ndarray]]:
        found = self.study.system.defined
        return tuple(found), compiled(found.values(), found)

    @cached_property
    def _accelerations(self) -> Callable[..., np.ndarray]:
        return compiled_accelerations(self.study, self.given)

    def numbers(self, state: State) -> dict[str, Any]:
        """All numbers of a state, or of many as columns."""
        found = {**self.given, **dict(zip(self.names, state, strict=True))}
        names, values = self._defined
        return found | dict(zip(names, values(found), strict=True))

    def rate(self, _: float, state: State) -> State:
        """Speeds and accelerations."""
        numbers, names = self.numbers(state), self.study.system.coordinates
        speeds = [numbers[f"{name}_dot"] for name in names]
        gains = self._accelerations(state[-1], state[: len(names)], state[len(names) : -1])
        return np.array([*speeds, *gains, 1.0])

    def after(self, state: State, time: float) -> State:
        """The state a short time later."""
        return state + time * self.rate(0.0, state)

    def start(self) -> State:
        """Where the motion starts; what the author left open is where the conditions that stay want it."""
        return np.array(super().start())

    def room(self, state: State) -> float:
        """How far the coordinates are from the ends of their declared ranges, the least of all; negative outside."""
        numbers = self.numbers(state)
        ends = [(end, sign, c.name) for c in self.study.problem.coordinates for end, sign in ((c.lower, -1), (c.upper, 1))]
        gaps = (sign * (limit - numbers[name]) for end, sign, name in ends if (limit := bound(end, numbers)) is not None)
        return min(gaps, default=math.inf)

    def pushed(self, state: State) -> State:
        """The start; what rests where the forces balance is displaced a little. Raises NotApplicable if it stays."""
        if math.isfinite(self.pace(state)):
            return state
        free = [name in self.study.system.independent for name in self.names]
        sizes = np.array([self.sizes.get(name, 0.0) for name in self.names])
        for after in (state + PUSH * sizes * free, state - PUSH * sizes * free):
            if self.room(after) >= 0 and math.isfinite(self.pace(after)):
                return after
        raise NotApplicable(REASONS["rest"])


class Leg(Frozen):
    """A phase of the motion: what was derived of it, all numbers at its moments, when it begins, what it is called.

    `turns` are the moments at which the first coordinate turned back, `lost` those at which a force that can only
    push (or pull) comes to nothing, or static friction to its limit, with its name. The first leg has no name.
    """

    derivation: Derivation
    flow: Flow
    moments: np.ndarray
    numbers: Numbers
    turns: tuple[int, ...] = ()
    lost: tuple[tuple[int, str], ...] = ()
    began: float = 0.0
    name: str = ""

    @property
    def study(self) -> Study:
        """The mechanics of the phase."""
        return self.derivation.study

    @property
    def times(self) -> np.ndarray:
        """The time since the very start."""
        return self.began + self.moments

    def at(self, moment: int) -> dict[str, float]:
        """All numbers of a moment."""
        return {name: float(value[moment] if np.ndim(value) else value) for name, value in self.numbers.items()}

    def values(self, value: Scalar) -> np.ndarray:
        """A quantity at all moments; not a number where it has none."""
        return np.broadcast_to(compiled([value])(self.numbers)[0], self.moments.shape)

    def part(self, count: int) -> Leg:
        """The first moments."""
        numbers = {name: value[:count] if np.ndim(value) else value for name, value in self.numbers.items()}
        return replace(self, moments=self.moments[:count], numbers=numbers)


def leg(
    derivation: Derivation, given: Mapping[str, float], end: float = math.inf, ending: Ending | None = None, **told: Any
) -> Leg:
    """The motion from the start up to the time `end`, or to the `ending` of its phase; else as long as it is worth.

    What rests where it could move is displaced a little, if neither is given. `told`: of the leg.
    Raises NotApplicable where the start or the accelerations are not known, nothing moves, or the ending does not come.
    """
    study = derivation.study
    require_motion(study)
    flow, is_open = Flow(study, given), ending is None and not math.isfinite(end)
    start = flow.pushed(flow.start()) if is_open else flow.start()
    events = dict(watched(flow, start, is_open))
    if ending is None:  # the formulas hold as long as each friction keeps its sense
        events |= {f"slip {name}": least(flow, [slip]) for name, slip in slips(study.system).items()}
    if ending is not None and ending.time is not None:
        end = at(ending.time, given)
    elif ending is not None:
        events["arrival"] = arrival(flow, start, ending)
    if end == 0:
        return Leg(derivation, flow, np.zeros(1), with_forces(flow, start[:, None]), **told)
    pace = flow.pace(start)
    end = end if math.isfinite(end) else PACES * pace
    path = followed(flow.rate, start.tolist(), end, events=tuple(events.values()), most=MOST, tolerances=TOLERANCES,
                    longest=min(pace / 2, end if is_open else end / 5))  # fmt: skip
    seen = dict(zip(events, path.seen, strict=True))
    if not seen.get("arrival", True):
        raise NotApplicable("with these numbers a phase does not come to its end")
    breaks = sorted({*path.times, *(time for times in path.seen for time in times)})
    moments = np.unique(np.concatenate([np.linspace(*ends, PARTS + 1) for ends in pairwise(breaks)]))
    numbers = with_forces(flow, path.at(moments))
    places = {name: tuple(np.searchsorted(moments, times)) for name, times in seen.items()}
    left = {name: compiled(values)(numbers).min(axis=0) for name, values in giving_way(study).items()}
    lost = [(k, name) for name, value in left.items() for k in places[name] if value[k - 1] > 0]
    return Leg(derivation, flow, moments, numbers, places.get("turn", ()), tuple(lost), **told)


def arrival(flow: Flow, start: State, ending: Ending) -> Event:
    """The coordinate that moves most comes to its place at the end of a phase, or to rest where it only touches it."""
    begin, goals = flow.numbers(start), {name: at(ending.places[name], flow.given) for name in flow.shown}
    name = max(goals, key=lambda name: abs(goals[name] - begin[name]) / flow.sizes[name])
    if at(ending.speeds[name], flow.given) ** 2 < EDGE * begin[f"{name}_dot"] ** 2:
        return Event(lambda _, state: flow.numbers(state)[f"{name}_dot"])
    return Event(lambda _, state: flow.numbers(state)[name] - goals[name])


def with_forces(flow: Flow, states: State) -> Numbers:
    """All numbers of some states, those of the unknown forces too."""
    numbers, forces = flow.numbers(states), reactions(flow.study)
    return numbers | dict(zip(forces, compiled(forces.values())(numbers), strict=True))


def giving_way(study: Study) -> dict[str, list[Scalar]]:
    """By unknown force that can only push (or pull), itself; by static friction with a limit, what is left up to it."""
    known, constraints = reactions(study), study.problem.constraints
    found = {name: [known[name]] for element in constraints for name in pushes(element) if name in known}
    held = (element for element in constraints if element.values.get("friction") in known)
    grips = {element["friction"]: list(spare(element, known.__getitem__)) for element in held}
    return found | {name: values for name, values in grips.items() if values}


def watched(flow: Flow, start: State, is_open: bool) -> Iterator[tuple[str, Event]]:
    """What ends a motion or happens on its way: a range ends, it is far, it turns back, a contact is lost or slips."""
    study = flow.study
    edge = 0.0 if flow.room(start) > EDGE else EDGE
    yield "end", Event(lambda _, state: flow.room(state) + edge)
    if is_open:
        begin, far = flow.numbers(start), FAR if study.system.independent else 2 * FAR

        def left(_: float, state: State) -> float:
            now = flow.numbers(state)
            return float(far - max(abs(now[name] - begin[name]) / flow.sizes[name] for name in flow.shown))

        yield "far", Event(left)
    if study.system.independent:
        place, is_shaken = len(study.system.coordinates), study.system.has_clock and not study.squares
        enough = SHAKEN if is_shaken else TURNINGS if len(flow.shown) == 1 else SEVERAL
        yield "turn", Event(lambda _, state: state[place], enough if is_open else math.inf)

    for name, gaps in giving_way(study).items():
        yield name, least(flow, gaps, math.inf)


def least(flow: Flow, gaps: Sequence[Scalar], most: float = 1) -> Event:
    """The least of some values vanishes."""
    values = compiled(gaps)
    return Event(lambda _, state: float(values(flow.numbers(state)).min()), most)


# --- derivation with the numbers of its motion, phase by phase


MANY, FEW = 10, 5  # of many turns forces, works and energies are shown over a few
AFTERWARDS = 1.5  # how much longer than all phases before it the last one is followed


class Journey(Frozen):
    """The legs of a motion. What is joined over all of them has a gap (not a number) where one ends and the next begins."""

    legs: tuple[Leg, ...]

    def joined(self, of: Callable[[Leg], np.ndarray]) -> np.ndarray:
        """The numbers of all legs with the gaps."""
        return np.concatenate([part for one in self.legs for part in ([math.nan], of(one))][1:])

    def values(self, value: Scalar) -> np.ndarray:
        """A quantity that is the same formula in all legs."""
        return self.joined(lambda one: one.values(value))

    @property
    def times(self) -> np.ndarray:
        """The time since the start."""
        return self.joined(lambda one: one.times)

    def part(self, count: int) -> Journey:
        """The same with a last leg of so many moments."""
        return Journey((*self.legs[:-1], self.legs[-1].part(count)))


class PlottedMotion(Frozen):
    """A derivation with the numbers of its motion.

    `whole` are all moments; `way` those until it turns back for the first time, if curves are drawn over the
    coordinate (and a few turns of a motion that is shaken); `real` is the way as far as no contact is lost and nothing slips.
    """

    derivation: Derivation
    scales: Scales
    whole: Journey

    @property
    def is_over_place(self) -> bool:
        """Are the curves drawn over the coordinate? (It is the only one of a single phase and determines the speed.)"""
        return len(self.whole.legs) == 1 and len(self.coordinates) == 1 and bool(self.derivation.study.squares)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The coordinates that are shown, of all phases."""
        return tuple(dict.fromkeys(name for one in self.whole.legs for name in one.flow.shown))

    @cached_property
    def way(self) -> Journey:
        """The moments over which forces, works and energies are shown."""
        last = self.whole.legs[-1]
        turn = 0 if self.is_over_place else FEW if len(last.turns) > MANY else len(last.turns)
        return self.whole.part(last.turns[turn] + 1) if turn < len(last.turns) else self.whole

    @cached_property
    def loss(self) -> tuple[int, str] | None:
        """The moment of the last leg at which a force comes to nothing though it can only push (or pull), or static friction to
        its limit, and its name."""
        last = self.way.legs[-1]
        return min((lost for lost in last.lost if lost[0] < len(last.moments)), default=None)

    @cached_property
    def real(self) -> Journey:
        """The way as far as no contact is lost and nothing slips."""
        return self.way if self.loss is None else self.way.part(self.loss[0] + 1)


def motion(derivation: Derivation) -> PlottedMotion:
    """The motion of a derived problem in numbers, with all its phases.

    Raises NotApplicable where there is none, or where the end of a phase has no closed form.
    """
    found = scales(derivation.study)
    require_motion(derivation.study)
    return PlottedMotion(derivation, found, Journey(tuple(legs(derivation, found))))


def legs(derivation: Derivation, found: Scales) -> Iterator[Leg]:
    """The phases one after the other; the last one is not followed much longer than those before it took."""
    problem, began = derivation.study.problem, 0.0
    endings = [stage.began.before for stage in known_stages(problem)[0][1:] if stage.began is not None] if problem.phases else []
    parts = [("", derivation), *((phase.name, phase.derivation) for phase in derivation.phases)]
    for (name, part), ending in zip(parts, [*endings, None], strict=False):
        if part.study.at_start:
            return
        end = math.inf if ending else AFTERWARDS * began or math.inf
        yield (one := leg(part, found.numbers, end, ending, began=began, name=name))
        began += one.moments[-1]
