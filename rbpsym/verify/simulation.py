"""The simulation oracle: the statement integrated in maximal coordinates, with multipliers.

Nothing of the symbolic solution is used in it: every body has its own x, y and φ, each
constraint is a condition on accelerations with its unknown force as multiplier (index one), and
the motion is integrated by an eighth-order method. The derived accelerations, unknown forces,
squares of speeds and the first integral are then compared with it, state by state.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy

from rbpsym.algebra.calculus import derivative
from rbpsym.algebra.scalar import Scalar
from rbpsym.errors import NotApplicable
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.system import System
from rbpsym.verify.simulation_bodies import Mechanism
from rbpsym.verify.simulation_forces import laws
from rbpsym.verify.simulation_joints import conditions
from rbpsym.verify.simulation_numbers import Numbers

DURATION, STATES, RANDOM_STATES = 0.5, 20, 12
RTOL, ATOL = 1e-12, 1e-13


@dataclass(frozen=True)
class SimulationReport:
    """Largest relative differences; `errors` by quantity, `drift` of the first integral (None: none).

    A difference is relative to the largest value that the quantities of its kind (all
    accelerations, all unknown forces) have along the motion.
    """

    max_relative_error: float
    errors: Mapping[str, float] = field(default_factory=dict)
    drift: float | None = None
    states: int = 0


def simulate(
    system: System, dynamics: Dynamics, *, integral: Scalar | None = None,
    squares: Mapping[str, Scalar] | None = None, along: Mapping[str, Scalar] | None = None,
) -> SimulationReport:
    """Runs the simulation from the declared start and compares. Raises NotApplicable for unknown kinds."""
    bench = _Bench(system, dynamics)
    errors = _Errors()
    for state in bench.random_states():
        bench.compare(state, errors)
    states = bench.trajectory()
    for state in states:
        bench.compare(state, errors)
        bench.compare_motion(state, errors, squares or {}, along or {})
    drift = None if integral is None else _drift([bench.known(s).of(integral) for s in states])
    found = errors.relative()
    worst = max([*found.values(), drift or 0.0], default=0.0)
    return SimulationReport(float(worst), {k: float(v) for k, v in found.items()}, drift, len(states) + RANDOM_STATES)


def _drift(values: Sequence[float]) -> float:
    scale = max(map(abs, values), default=0.0) or 1.0
    return float((max(values) - min(values)) / scale) if values else 0.0


class _Errors:
    """Largest differences and largest values by kind of quantity."""

    def __init__(self) -> None:
        self.difference: dict[str, float] = {}
        self.scale: dict[str, float] = {}

    def note(self, kind: str, derived: float, simulated: float) -> None:
        self.difference[kind] = max(self.difference.get(kind, 0.0), abs(derived - simulated))
        self.scale[kind] = max(self.scale.get(kind, 0.0), abs(simulated), abs(derived))

    def relative(self) -> dict[str, float]:
        return {kind: value / self.scale[kind] if self.scale[kind] > 1e-9 else value
                for kind, value in self.difference.items()}


@dataclass(frozen=True)
class _State:
    """Coordinates and speeds by name, and the same state in maximal coordinates."""

    names: Mapping[str, float]
    where: Any
    speed: Any


class _Bench:
    """The mechanism, and the symbolic side to be compared with it."""

    def __init__(self, system: System, dynamics: Dynamics) -> None:
        self.system, self.dynamics = system, dynamics
        self.base = sample(system.problem)
        self.mechanism = Mechanism(system.problem, self.base)
        bodies = system.bodies.values()
        self.places = [v for b in bodies for v in (b.center.x, b.center.y, b.pose.angle)]
        self.speeds = [v for b in bodies for v in (b.velocity.x, b.velocity.y, b.omega)]
        self.rates = [v for b in bodies for v in (b.acceleration.x, b.acceleration.y, b.alpha)]
        start = self.state(self._start())
        self.start = start
        self.laws = laws(self.mechanism, lambda where, speed: self.coordinates(where, speed, start).names)
        self.conditions = conditions(self.mechanism, list(start.where))
        self.masses = numpy.array(self.mechanism.masses)
        self.live = self.masses > 0

    def _start(self) -> dict[str, float]:
        """The declared start; the middle of the range and a generic speed where none is declared."""
        names = dict(self.base)
        for k, coordinate in enumerate(self.system.independent):
            start = self.system.scope.start
            if coordinate in start:
                names[coordinate] = number(start[coordinate], self.base)
            speed = start.get(f"{coordinate}_dot")
            names[f"{coordinate}_dot"] = 0.3 - 0.2 * k if speed is None else number(speed, self.base)
        return names

    def state(self, names: dict[str, float]) -> _State:
        """The state in maximal coordinates at given coordinates and speeds."""
        names = self._tied(names)
        known = Numbers(names)
        return _State(names, numpy.array(known.row(self.places)), numpy.array(known.row(self.speeds)))

    def _tied(self, names: dict[str, float]) -> dict[str, float]:
        """Coordinates that conditions tie are found by Newton's method; their speeds are not free."""
        free = [n for n in self.system.coordinates if n not in self.system.independent]
        for _ in range(50 if self.system.implicit else 0):
            known = Numbers(names)
            values = numpy.array(known.row(c.value for c in self.system.implicit))
            if numpy.abs(values).max() < 1e-14:
                break
            slopes = [known.row(derivative(c.value, n) for n in free) for c in self.system.implicit]
            step = numpy.linalg.lstsq(numpy.array(slopes), values, rcond=None)[0]
            names = {**names, **{n: names[n] - d for n, d in zip(free, step, strict=True)}}
        return names

    def known(self, state: _State) -> Numbers:
        """Values at a state."""
        return Numbers(state.names)

    def accelerations(self, where, speed):
        """(A of all bodies, multipliers by name): M A = F + Gᵀ λ, G A = -bias."""
        where, speed = list(where), list(speed)
        load = numpy.zeros(len(where))
        for law in self.laws:
            for item in law(where, speed):
                load[3 * item.body : 3 * item.body + 3] += (item.x, item.y, item.torque)
        rows = [kept.at(where, speed) for kept in self.conditions]
        gradient = numpy.zeros((len(rows), len(where)))
        for k, row in enumerate(rows):
            for column, entry in row.entries:
                gradient[k, column] += entry
        return self._solve(load, gradient, numpy.array([row.bias for row in rows]))

    def _solve(self, load, gradient, bias):
        """The linear system of accelerations and multipliers; a particle has no rotation."""
        live, count = self.live, len(bias)
        size = int(live.sum())
        whole = numpy.zeros((size + count, size + count))
        whole[:size, :size] = numpy.diag(self.masses[live])
        whole[:size, size:] = -gradient[:, live].T
        whole[size:, :size] = gradient[:, live]
        try:
            found = numpy.linalg.solve(whole, numpy.concatenate([load[live], -bias]))
        except numpy.linalg.LinAlgError:
            raise NotApplicable("the multipliers of the simulation are not determined at the start") from None
        result = numpy.zeros(len(live))
        result[live] = found[:size]
        return result, dict(zip((kept.multiplier for kept in self.conditions), found[size:], strict=True))

    def random_states(self) -> list[_State]:
        """Generic states: coordinates near the middle of their ranges, speeds of both signs."""
        source, found = numpy.random.default_rng(20201), []
        for _ in range(RANDOM_STATES):
            names = dict(self.base)
            for name in self.system.independent:
                names[name] += 0.2 * source.uniform(-1, 1)
                names[f"{name}_dot"] = source.uniform(-1.5, 1.5)
            found.append(self.state(names))
        return found

    def trajectory(self) -> list[_State]:
        """States along the motion from the start."""
        from scipy.integrate import solve_ivp

        size, start = len(self.start.where), self.start

        def rate(time, both):
            return numpy.concatenate([both[size:], self.accelerations(both[:size], both[size:])[0]])

        times = numpy.linspace(0.0, DURATION, STATES + 1)[1:]
        found = solve_ivp(rate, (0.0, DURATION), numpy.concatenate([start.where, start.speed]), method="DOP853",
                          t_eval=times, rtol=RTOL, atol=ATOL)
        if not found.success:
            raise NotApplicable("the simulation did not reach its end: " + str(found.message))
        states, last = [], start
        for both in found.y.T:
            last = self.coordinates(both[:size], both[size:], last)
            states.append(last)
        return states

    def coordinates(self, where, speed, near: _State) -> _State:
        """The coordinates and speeds that belong to a state in maximal coordinates, by Newton's method."""
        names, where, speed = dict(near.names), numpy.asarray(where), numpy.asarray(speed)
        for _ in range(30):
            here = self.state(names)
            gap = where - here.where
            if numpy.abs(gap).max() < 1e-13:
                break
            step = numpy.linalg.lstsq(self._slopes(names), gap, rcond=None)[0]
            names = {**here.names, **{n: here.names[n] + d for n, d in zip(self.system.independent, step, strict=True)}}
        speeds = numpy.linalg.lstsq(self._slopes(names), speed, rcond=None)[0]
        names |= {f"{n}_dot": u for n, u in zip(self.system.independent, speeds, strict=True)}
        return _State(self._tied(names), where, speed)

    def _slopes(self, names: dict[str, float]):
        """∂X/∂q = ∂V/∂q̇, column by column."""
        columns = []
        for name in self.system.independent:
            unit = {**names, **{f"{n}_dot": float(n == name) for n in self.system.independent}}
            columns.append(self.state(unit).speed)
        return numpy.array(columns).T

    def compare(self, state: _State, errors: _Errors) -> None:
        """Accelerations of all bodies and unknown forces at one state."""
        simulated, multipliers = self.accelerations(state.where, state.speed)
        known = Numbers({**state.names, **self._derived(state)})
        for k, value in enumerate(known.row(self.rates)):
            if self.live[k]:
                errors.note("angular accelerations" if k % 3 == 2 else "accelerations", value, simulated[k])
        for name, value in self.dynamics.reactions.items():
            errors.note("unknown forces", known.of(value), multipliers[name])

    def _derived(self, state: _State) -> dict[str, float]:
        """Values of q̈: by the formulas, or from M q̈ = f where there are none."""
        known, names = Numbers(state.names), self.system.accelerations
        if self.dynamics.accelerations is not None:
            return dict(zip(names, known.row(self.dynamics.accelerations[n] for n in names), strict=True))
        matrix = numpy.array([known.row(row) for row in self.dynamics.mass_matrix])
        found = numpy.linalg.solve(matrix, numpy.array(known.row(self.dynamics.forcing)))
        return dict(zip(names, found, strict=True))

    def compare_motion(self, state: _State, errors: _Errors, squares: Mapping[str, Scalar], along: Mapping[str, Scalar]) -> None:
        """Squares of speeds and forces as functions of position, on the way from the start."""
        known = self.known(state)
        for name, value in squares.items():
            errors.note(f"{name}_dot squared", known.of(value), state.names[f"{name}_dot"] ** 2)
        if along:
            _, multipliers = self.accelerations(state.where, state.speed)
            for name, value in along.items():
                errors.note("forces along the motion", known.of(value), multipliers[name])
