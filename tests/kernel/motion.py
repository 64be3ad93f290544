"""The letters of a derivation in numbers along one motion, and whether a claim about functions of time is true of it."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from rbpsym.errors import NoNumber
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, derivative, names_in, symbol
from rbpsym.field.evaluate import scalar, time_derivative
from rbpsym.kernel.claim import TIME, Proposition, is_along_time
from rbpsym.kernel.claims import ClaimSource
from rbpsym.kernel.components import START
from rbpsym.mechanics.numbers import sample
from rbpsym.numeric.formulas import compiled
from rbpsym.pictures.plots.following import Flow, leg

SHARE = 0.3  # of the time in which something moves far
CLOSE = 2e-3  # of their size may both sides be apart: sums over the time are those of trapezoids


class Motion:
    """A motion from the start: the numbers of all letters at some times, and (by their names) the rates of what changes.

    `open`: letters for places that only an equation tells.
    """

    def __init__(self, source: ClaimSource) -> None:
        study, given = source.study, sample(source.study.problem, source.study.problem.example)
        flow = Flow(study, given)
        pace = flow.pace(flow.start())
        way = leg(source.derivation, given, end=SHARE * pace if math.isfinite(pace) else 1.0)
        self.source, self.times = source, way.moments
        self.numbers = {name: self.row(value) for name, value in way.numbers.items()}
        states = np.array([self.numbers[name] for name in flow.names]).T
        gains = dict(zip(flow.names, np.array([flow.rate(0.0, state) for state in states]).T, strict=True))
        self.numbers |= {f"{name.removesuffix('_dot')}_ddot": gains[name] for name in study.system.speeds}
        found = self._letters()
        self.rates = {name: self.of(time_derivative(value, source.letters.scope)) for name, value in found.items()}
        self.rates |= {name: self.of(rate) for name, rate in (source.letters.scope.rates | source.letters.works).items()}
        self.rates |= {c.name: self.numbers[f"{c.name}_dot"] for c in study.problem.coordinates}
        self.numbers |= {name: self.summed(self.rates[name]) for name in source.letters.works}
        self.numbers |= {f"{name}'": rate for name, rate in self.rates.items()}
        self.numbers |= {name + START: self.row(values[0]) for name, values in self.numbers.items()}

    def row(self, value: object) -> np.ndarray:
        """A number at each moment."""
        return np.broadcast_to(np.asarray(value, float), self.times.shape)

    def _letters(self) -> dict[str, Scalar]:
        """The values of letters, those of vectors by components; each gets its numbers once what stands in it has."""
        letters = self.source.letters
        found: dict[str, Scalar] = dict(letters.scalars)
        for name, vector in letters.vectors.items():
            *plane, out = vector.components()
            found |= dict(zip((f"{name}_x", f"{name}_y"), plane, strict=True)) | ({} if any(plane) else {name: out})
        self.open = {name for name, value in found.items() if value == symbol(name)} - self.numbers.keys()
        found = {name: value for name, value in found.items() if name not in {*self.numbers, *self.open}}
        waiting = dict(found)
        while waiting:
            ready = {name: self.of(value) for name, value in waiting.items() if not names_in(value) & waiting.keys()}
            assert ready, sorted(waiting)
            self.numbers |= ready
            waiting = {name: value for name, value in waiting.items() if name not in ready}
        return found

    def of(self, value: Scalar) -> np.ndarray:
        """A value at all moments."""
        return self.row(compiled([value])(self.numbers)[0])

    def summed(self, rate: np.ndarray) -> np.ndarray:
        """What a rate adds up to since the start."""
        return np.concatenate([[0.0], np.cumsum((rate[1:] + rate[:-1]) / 2 * np.diff(self.times))])

    def side(self, node: t.Node) -> np.ndarray:
        """A side of a claim at all moments. Raises NoNumber where it has no value."""
        found = self.of(scalar(self._without_sums(node)))
        if not np.isfinite(found).all():
            raise NoNumber(f"no number is known for {sorted(t.names(node) - self.numbers.keys())}")
        return found

    def _without_sums(self, node: t.Node) -> t.Node:
        """With a letter for each integral along the motion."""
        if not (isinstance(node, t.Integral) and (node.var == TIME or is_along_time(node, self.source.moving))):
            return t.mapped(node, self._without_sums)
        name = f"sum {len(self.numbers)}"
        self.numbers[name] = self.summed(self.of(scalar(node.integrand)) * self.rates[node.var])
        return t.Sym(name)

    def rate(self, node: t.Node) -> np.ndarray:
        """The rate of a side at all moments."""
        value = scalar(node)
        return self.row(sum(self.of(derivative(value, name)) * self.rates[name] for name in names_in(value) & self.rates.keys()))

    def holds(self, claim: Proposition) -> bool:
        """Whether the claim is true at all these moments; what is strict, after the first of them."""
        left, right = (self.rate if claim.kind == "rate" else self.side)(claim.left), self.side(claim.right)
        return bool(HOLD[claim.kind](left, right, CLOSE * (np.abs(left).max() + np.abs(right).max() + CLOSE)))


HOLD: dict[str, Callable[[np.ndarray, np.ndarray, float], np.bool]] = {
    "equal": lambda left, right, close: np.abs(left - right).max() < close,
    "rate": lambda left, right, close: np.abs(left - right).max() < close,
    "start": lambda left, right, close: np.abs(left - right)[0] < close,
    "more": lambda left, right, _: (left > right)[1:].all(),
    "least": lambda left, right, close: (left > right - close).all(),
    "differ": lambda left, right, _: (left != right)[1:].all(),
}
