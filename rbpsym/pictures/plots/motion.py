"""A derivation with the numbers of its motion, phase by phase."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property

import numpy as np

from rbpsym.field import Scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.phases import stages
from rbpsym.pictures.moving import require_motion
from rbpsym.pictures.plots.following import Leg, leg
from rbpsym.pictures.plots.scales import Scales, scales
from rbpsym.proof.step import Derivation

MANY, FEW = 10, 5  # of many turns forces, works and energies are shown over a few
AFTERWARDS = 1.5  # how much longer than all phases before it the last one is followed


class Journey(Frozen):
    """The legs of a motion. What is joined over all of them has a gap (not a number) where one ends and the next begins."""

    legs: tuple[Leg, ...]

    def joined(self, of: Callable[[Leg], Sequence[float]]) -> np.ndarray:
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
    found = scales(derivation.study.problem)
    require_motion(derivation.study)
    return PlottedMotion(derivation, found, Journey(tuple(legs(derivation, found))))


def legs(derivation: Derivation, found: Scales) -> Iterator[Leg]:
    """The phases one after the other; the last one is not followed much longer than those before it took."""
    problem, began = derivation.study.problem, 0.0
    endings = [stage.began.before for stage in stages(problem)[1:]] if problem.phases else []
    parts = [("", derivation), *((phase.name, phase.derivation) for phase in derivation.phases)]
    for (name, part), ending in zip(parts, [*endings, None], strict=False):
        if part.study.at_start:
            return
        end = math.inf if ending else AFTERWARDS * began or math.inf
        yield (one := leg(part, found.numbers, end, ending, began=began, name=name))
        began += one.moments[-1]
