"""A derivation with the numbers of its motion, phase by phase."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.derivation.step import Derivation
from rbpsym.document.plots.evaluation import Evaluator
from rbpsym.document.plots.following import require_motion, trajectory
from rbpsym.document.plots.running import Run, Stop
from rbpsym.document.plots.sampling import Curves, refined
from rbpsym.document.plots.scales import Scales, scales
from rbpsym.document.plots.trajectory import Numbers, Trajectory, at, crossings
from rbpsym.errors import NotApplicable
from rbpsym.mechanics.endings import State
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.study import Study

MANY, FEW = 10, 5  # of many turns forces, works and energies are shown over a few
AFTERWARDS = 1.5  # how much longer than all phases before it the last one is followed


@dataclass(frozen=True)
class Leg:
    """A phase of the motion: what was derived of it, its moments, when it begins, what it is called ("" for the first)."""

    derivation: Derivation
    moments: Trajectory
    began: float = 0.0
    name: str = ""

    @property
    def study(self) -> Study:
        """The mechanics of the phase."""
        return self.derivation.study

    @property
    def times(self) -> list[float]:
        """The time since the very start."""
        return [self.began + time for time in self.moments.times]

    @cached_property
    def reactions(self) -> Mapping[str, Scalar]:
        """The unknown forces: along the motion where they are known so, else as functions of the state."""
        return {**self.study.dynamics.reactions, **(self.study.reactions_along_motion or {})}

    @cached_property
    def numbers(self) -> list[Numbers]:
        """All numbers at all moments, those of the unknown forces too."""
        evaluate = Evaluator(self.reactions)
        return [{**state, **evaluate(state)} for state in self.moments.states]


@dataclass(frozen=True)
class Journey:
    """The legs of a motion. A list over all of them has a gap (not a number) where one ends and the next begins."""

    legs: tuple[Leg, ...]

    def joined(self, of: Callable[[Leg], Sequence[float]]) -> list[float]:
        """The numbers of all legs with the gaps."""
        found: list[float] = []
        for leg in self.legs:
            found += [math.nan, *of(leg)] if found else of(leg)
        return found

    def values(self, value: Scalar) -> list[float]:
        """A quantity that is the same formula in all legs."""
        return self.joined(lambda leg: leg.moments.values(value))

    @property
    def times(self) -> list[float]:
        """The time since the start."""
        return self.joined(lambda leg: leg.times)

    @property
    def states(self) -> tuple[Numbers, ...]:
        """The numbers at all moments."""
        return tuple(state for leg in self.legs for state in leg.moments.states)

    @property
    def turns(self) -> tuple[int, ...]:
        """Where the only leg turns back."""
        return self.legs[0].moments.turns if len(self.legs) == 1 else ()

    def changed(self, of: Callable[[Trajectory], Trajectory]) -> Journey:
        """The same with another last leg."""
        last = self.legs[-1]
        return Journey((*self.legs[:-1], replace(last, moments=of(last.moments))))


@dataclass(frozen=True)
class Motion:
    """A derivation with the numbers of its motion.

    `whole` are all moments; `way` those until it turns back for the first time, if curves are drawn over the
    coordinate (and a few turns of a motion that is shaken); `real` is the way as far as no contact is lost.
    """

    derivation: Derivation
    scales: Scales
    whole: Journey

    @property
    def is_single(self) -> bool:
        """Is there one phase with one coordinate?"""
        return len(self.whole.legs) == 1 and len(self.coordinates) == 1

    @property
    def is_over_place(self) -> bool:
        """Are the curves drawn over the coordinate? (It must determine the speed.)"""
        return self.is_single and bool(self.derivation.study.squares)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The coordinates that are shown, of all phases."""
        return tuple(dict.fromkeys(name for leg in self.whole.legs for name in leg.moments.coordinates))

    @cached_property
    def way(self) -> Journey:
        """The moments over which forces, works and energies are shown."""
        return self.whole.changed(lambda moments: moments.part(seen(moments, self)))

    @cached_property
    def loss(self) -> tuple[str, int] | None:
        """The first force that changes its sign though it can only push (or pull), and the moment of the last leg behind it."""
        last = self.way.legs[-1]
        names = [n for e in last.study.problem.constraints for n in pushes(e) if n in last.reactions]
        found = []
        for name in names:
            places = list(crossings(last.moments.values(last.reactions[name])))
            found += [(places[0], name)] if places else []
        return (min(found)[1], min(found)[0]) if found else None

    @cached_property
    def real(self) -> Journey:
        """The way as far as no contact is lost."""
        if self.loss is None:
            return self.way
        return self.way.changed(lambda moments: moments.part(self.loss[1] + 1))


def motion(derivation: Derivation) -> Motion:
    """The motion of a derived problem in numbers, with all its phases.

    Raises NotApplicable where there is none, or where the end of a phase has no closed form.
    """
    found = scales(derivation.study.problem)
    require_motion(derivation.study)
    rough = Motion(derivation, found, Journey(tuple(legs(derivation, found))))
    fine = (replace(leg, moments=refined(leg.moments, drawn(leg, rough))) for leg in rough.whole.legs)
    return replace(rough, whole=Journey(tuple(fine)))


def legs(derivation: Derivation, found: Scales) -> Iterator[Leg]:
    """The phases one after the other."""
    problem = derivation.study.problem
    parts = (derivation, *(phase.derivation for phase in derivation.phases))
    endings = [stage.began.before for stage in stages(problem)[1:]] if problem.phases else []
    began = 0.0
    for k, part in enumerate(parts):
        name = derivation.phases[k - 1].name if k else ""
        moments = first(part, found, endings[k]) if k < len(endings) else last(part, found, began)
        yield Leg(part, moments, began, name)
        began += moments.times[-1]


def last(part: Derivation, found: Scales, before: float) -> Trajectory:
    """The moments of the last phase; after others it is not followed much longer than they took."""
    end = AFTERWARDS * before if before else math.inf
    return trajectory(part.study, found.numbers, end, displaced=not before)


def first(part: Derivation, found: Scales, ending: State) -> Trajectory:
    """The moments of a phase that another one follows. Raises NotApplicable if its end is not reached."""
    end = math.inf if ending.time is None else at(ending.time, found.numbers)
    if end == 0:
        run = Run(part.study, dict(found.numbers), end)
        return run.trajectory([0.0], [run.start()], ())
    stop = None if math.isfinite(end) else arrival(part.study, found, ending)
    moments = trajectory(part.study, found.numbers, end, stop, displaced=False)
    if stop and abs(stop(moments.states[-1])) > 1e-6 * max(moments.run.sizes.values()):
        raise NotApplicable("with these numbers a phase does not come to its end")
    return moments


def arrival(study: Study, found: Scales, ending: State) -> Stop:
    """How far the coordinate that moves most is from its place at the end of a phase."""
    run = Run(study, dict(found.numbers), math.inf)
    start = run.numbers_at(0.0, run.start())
    ways = {name: at(ending.places[name], found.numbers) - start[name] for name in run.shown}
    name = max(ways, key=lambda name: abs(ways[name]) / run.sizes[name])
    goal = start[name] + ways[name]
    return lambda numbers: numbers[name] - goal


def seen(moments: Trajectory, moving: Motion) -> int:
    """How many moments of the last leg forces, works and energies are shown over."""
    turn = 0 if moving.is_over_place else FEW if len(moments.turns) > MANY else len(moments.turns)
    return moments.turns[turn] + 1 if turn < len(moments.turns) else len(moments.times)


def drawn(leg: Leg, moving: Motion) -> Callable[[Trajectory], Curves]:
    """The curves that must look smooth: places, speeds and forces in time, and over the coordinate."""
    others = Evaluator({**leg.reactions, "K": sum(leg.study.kinetic, NOTHING)})

    def curves(moments: Trajectory) -> Curves:
        places, speeds = (
            [[state[f"{name}{dot}"] for state in moments.states] for name in moments.coordinates]
            for dot in ("", "_dot")
        )
        values = [*speeds, *zip(*(found.values() for found in map(others, moments.states)), strict=True)]
        across = places[0] if moving.is_over_place else moments.times
        count = seen(moments, moving)
        return [(moments.times, place) for place in places] + [(across[:count], value[:count]) for value in values]

    return curves
