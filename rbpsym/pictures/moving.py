"""How a system begins to move, in plain numbers, from the accelerations that were derived; or why there is no motion.

Conditions that stay as equations hold at the start and are kept by the rates.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

from rbpsym.errors import NoNumber, NotApplicable
from rbpsym.field import Scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.compiled import entries_of
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.study import Study
from rbpsym.pictures.pose import fitted, shortest
from rbpsym.quantities import LENGTH, NUMBER

STILL = 1e-9
SOON = 1e-4

REASONS = {  # why there is no motion that can be followed
    "statics": "nothing moves: it is a problem of statics",
    "tied": "the speeds are tied by a condition that is no condition on the places",
    "no_start": "the statement does not say where the motion starts",
    "rest": "nothing moves",
    "at_start": "the motion is known at its start alone",
}


def at(value: Scalar, numbers: Mapping[str, Any]) -> float:
    """A quantity at one moment; not a number where it has none."""
    try:
        return float(number(value, numbers))
    except NoNumber:
        return math.nan


def reactions(study: Study) -> dict[str, Scalar]:
    """The unknown forces: along the motion where they are known so, else as functions of the state."""
    return {**study.dynamics.reactions, **(study.reactions_along_motion or {})}


def require_motion(study: Study) -> None:
    """Raises NotApplicable if there is no motion that could be followed."""
    system = study.system
    if not study.problem.coordinates:
        raise NotApplicable(REASONS["statics"])
    if study.at_start:
        raise NotApplicable(REASONS["at_start"])
    if system.speed_ties:
        raise NotApplicable(REASONS["tied"])
    if any(name not in system.scope.start for name in system.independent):
        raise NotApplicable(REASONS["no_start"])


class Defined(dict[str, float]):
    """Numbers by name; what is defined by a formula is worked out when it is asked for."""

    def __init__(self, numbers: Mapping[str, float], formulas: Mapping[str, Scalar]) -> None:
        super().__init__(numbers)
        self.formulas = formulas

    def __missing__(self, name: str) -> float:
        self[name] = number(self.formulas[name], self)
        return self[name]


class Moving(Frozen):
    """A system with numbers for its parameters: its state at the start, how that changes, and all numbers of a state."""

    study: Study
    given: Mapping[str, float]

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What a state consists of."""
        return (*self.study.system.coordinates, *self.study.system.speeds, "t")

    @cached_property
    def shown(self) -> tuple[str, ...]:
        """The coordinates that are shown: the independent ones, or all where everything is driven."""
        return tuple(self.study.system.independent) or tuple(c.name for c in self.study.problem.coordinates)

    @cached_property
    def sizes(self) -> dict[str, float]:
        """What a far way is for each coordinate: a radian, or a length of the problem."""
        lengths = [q.name for q in self.study.problem.parameters if q.dimension == LENGTH and self.given.get(q.name)]
        length = abs(self.given[lengths[0]]) if lengths else 1.0
        kinds = {c.name: c.quantity.dimension for c in self.study.problem.coordinates}
        return {name: 1.0 if kind == NUMBER else length for name, kind in kinds.items()}

    def numbers(self, state: Any) -> dict[str, Any]:
        """All numbers of a state. Raises NoNumber where one has no value."""
        formulas = self.study.system.defined
        found = Defined({**self.given, **dict(zip(self.names, state, strict=True))}, formulas)
        for name in formulas:
            found[name]
        return found

    def with_forces(self, state: Any) -> dict[str, Any]:
        """The same with the unknown forces."""
        numbers = self.numbers(state)
        return {**numbers, **{name: at(value, numbers) for name, value in reactions(self.study).items()}}

    def rate(self, _: float, state: Any) -> Any:
        """Speeds and accelerations."""
        numbers, system = self.numbers(state), self.study.system
        entries, size = [number(value, numbers) for value in entries_of(self.study)], len(system.speeds)
        mass = [entries[k * size : (k + 1) * size] for k in range(size)]
        gains = shortest(mass, entries[size * size : size * size + size]) if mass else []
        return [*(numbers[f"{name}_dot"] for name in system.coordinates), *gains, 1.0]

    def after(self, state: Any, time: float) -> Any:
        """The state a short time later."""
        return [value + time * rate for value, rate in zip(state, self.rate(0.0, state), strict=True)]

    def start(self) -> Any:
        """Where the motion starts; what the author left open is where the conditions that stay want it."""
        scope, still = self.study.system.scope.start, dict.fromkeys((*self.study.system.speeds, "t"), 0.0)
        found = {**sample(self.study.problem), **self.given, **still}
        found |= {name: at(scope[name], self.given) for name in self.names if name in scope}
        if self.study.system.implicit:
            found = fitted(self.study.system, found)
        state: Sequence[float] = [found[name] for name in self.names]
        if not all(map(math.isfinite, state)):
            raise NotApplicable("the start has no numbers")
        return state

    def pace(self, state: Any) -> float:
        """The time in which the fastest coordinate moves by its size; infinite if nothing moves."""
        now, soon = self.numbers(state), self.numbers(self.after(state, SOON))
        paces = [math.inf]
        for name in self.shown:
            speed = now[f"{name}_dot"] / self.sizes[name]
            gain = (soon[f"{name}_dot"] - now[f"{name}_dot"]) / SOON / self.sizes[name]
            paces += [1 / abs(speed)] if abs(speed) > STILL else []
            paces += [math.sqrt(1 / abs(gain))] if abs(gain) > STILL else []
        return min(paces)
