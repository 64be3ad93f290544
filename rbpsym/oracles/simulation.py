"""The simulation oracle: the statement integrated in maximal coordinates, with multipliers.

Every body has its own x, y and φ; each constraint is a condition on accelerations with its
unknown force as multiplier; all of it is built from the statement, nothing of the symbolic
solution is used in it. The derived accelerations, unknown forces, squares of speeds, works and
the first integral are then compared with it: at generic states, along a motion from a generic
state, and along the motion from the declared start.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np

from rbpsym.errors import NoNumber, NotApplicable, there
from rbpsym.field import NOTHING, Scalar, Vector
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics import energy
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.friction import senses
from rbpsym.mechanics.instant import Instant
from rbpsym.mechanics.motion import ForceWork
from rbpsym.mechanics.numbers import Values, number, sample
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.numeric.integration import Rate
from rbpsym.oracles.simulation_bodies import Mechanism, State, laws
from rbpsym.oracles.simulation_contacts import conditions
from rbpsym.oracles.simulation_joints import with_shares
from rbpsym.oracles.simulation_motion import Equations, duration, trajectory
from rbpsym.oracles.simulation_placement import Conditions, Placement, Start, idle_angles, start_state

GENERIC_STATES = 8
GENERIC_TIME = 0.3
FAINT = 1e-2  # of the largest value of its kind: what a small quantity is compared with at least
NOISE = 1e-3  # the same where all of a kind vanish (a body that stays at rest); sample numbers are near 1


class SimulationReport(Frozen):
    """Largest relative differences; `errors` by quantity, `drift` of the first integral (None: none).

    `momentum_drift`: how far the derived angular momentum about the origins strays from its start
    value and the torque impulse since (None: not asked for); `gap`: how far the conditions on the
    positions, which are integrated as conditions on accelerations, drift from zero.

    A difference is relative to the largest value of the quantity along the motion (or to a
    hundredth of the largest of its kind, or to 0.001 where all vanish). `freedom` is the number of degrees of
    freedom that the numerical conditions leave.
    """

    max_relative_error: float
    errors: Mapping[str, float] = field(default_factory=dict)
    drift: float | None = None
    states: int = 0
    freedom: int = 0
    momentum_drift: float | None = None
    gap: float = 0.0


class Derived(Frozen):
    """The symbolic results that are put to the test; `momenta`: fixed points with the angular momentum about them."""

    system: System
    dynamics: Dynamics
    integral: Scalar | None = None
    squares: Mapping[str, Scalar] = field(default_factory=dict)
    along: Mapping[str, Scalar] = field(default_factory=dict)
    works: Mapping[tuple[str, str, bool], Scalar] = field(default_factory=dict)
    momenta: Mapping[str, tuple[Vector, Scalar]] = field(default_factory=dict)


class Errors:
    """Largest differences and largest values of quantities, by kind and name."""

    def __init__(self) -> None:
        self.difference: dict[tuple[str, str], float] = {}
        self.scale: dict[tuple[str, str], float] = {}

    def note(self, kind: str, name: str, derived: float, simulated: float) -> None:
        """One comparison (a value that is no number counts as infinitely wrong)."""
        key, gap = (kind, name), abs(derived - simulated)
        self.difference[key] = max(self.difference.get(key, 0.0), gap if gap == gap else np.inf)
        self.scale[key] = max(self.scale.get(key, 0.0), abs(simulated))

    def relative(self) -> dict[str, float]:
        """Relative difference by quantity."""
        largest: dict[str, float] = {}
        for (kind, _), scale in self.scale.items():
            largest[kind] = max(largest.get(kind, 0.0), scale)
        return {
            f"{kind} {name}": float(gap / max(self.scale[kind, name], FAINT * largest[kind], NOISE))
            for (kind, name), gap in self.difference.items()
        }


class Bench:
    """A mechanism, states to try it at, and the comparison with what was derived."""

    def __init__(self, derived: Derived, numbers: Mapping[str, float] | None = None) -> None:
        self.derived, self.errors, self.drifts, self.states = derived, Errors(), list[float](), 0
        self.momentum_drifts, self.gap = list[float](), 0.0
        problem = derived.system.problem
        self.sample = {**sample(problem), **(numbers or {})}
        mechanism = Mechanism(problem, self.sample, senses(derived.system))
        self.placement, idle = Placement(mechanism), idle_angles(mechanism)
        guess = self._coordinates({})
        kept = conditions(mechanism, self._poses(guess).tolist())
        self.conditions = Conditions(self.placement, kept, idle)
        mechanism.clock = GENERIC_TIME
        self.generic = self.start({}, {name: 0.7 * (-0.8) ** k for k, name in enumerate(derived.system.independent)})
        reader = self.placement.reader(self.generic.q)
        self.equations = Equations(mechanism, laws(mechanism, reader), with_shares(kept, mechanism, reader), idle)
        self.account = {key: k for k, key in enumerate(derived.works)}
        places = (origin for origin, _ in derived.momenta.values())
        known = Values(self.sample)
        self.levers = [(known.of(o.x), known.of(o.y)) for o in places]

    # --- states

    def _coordinates(self, changed: Mapping[str, float]) -> dict[str, float]:
        """Values for the coordinates; dependent ones as the system has them (a first guess)."""
        names = {**self.sample, "t": self.placement.mechanism.clock, **changed}
        names |= {n: number(v, names) for n, v in self.derived.system.dependent.items() if n not in changed}
        return names

    def _poses(self, names: Mapping[str, float]) -> np.ndarray:
        """A first guess of the places of the bodies; the conditions then correct it."""
        known, bodies = Values(names), self.derived.system.bodies.values()
        return np.array(known.row(v for b in bodies for v in (b.center.x, b.center.y, b.pose.angle)))

    def start(self, changed: Mapping[str, float], rates: Mapping[str, float], held: Iterable[str] = ()) -> Start:
        """The state near these coordinates and speeds that satisfies every condition."""
        names = self._coordinates(changed)
        return start_state(self.conditions, names, rates, self._poses(names), tuple(held))

    def declared_start(self, sought: Collection[str] = ()) -> Start | None:
        """The state from which the author lets it start, None if it is not declared in full; without the speeds `sought`."""
        known, system = self.derived.system.scope.start, self.derived.system
        if not all(name in known and f"{name}_dot" in known for name in system.independent):
            return None
        places = {name: number(known[name], self.sample) for name in system.coordinates if name in known}
        told = (name for name in system.independent if f"{name}_dot" not in sought)
        rates = {name: number(known[f"{name}_dot"], self.sample) for name in told}
        return self.start(places, rates, places)

    def compare_generic_states(self) -> None:
        """Accelerations and unknown forces at states all over the place."""
        source, system = np.random.default_rng(20201), self.derived.system
        for _ in range(GENERIC_STATES):
            shift = {n: self.sample[n] + 0.2 * source.uniform(-1, 1) for n in system.independent}
            self.compare_start(self.start(shift, {n: source.uniform(-1.5, 1.5) for n in system.independent}))

    def compare_start(self, start: Start) -> None:
        """Accelerations and unknown forces at a state."""
        self._compare(start.where, start.speed, start.q)

    def usual_time(self, start: Start) -> float:
        """How long a motion from there is followed."""
        gained = self.equations.at(start.where, start.speed).gained
        return duration(start.speed, gained, self.placement.mechanism.reach())

    def multipliers(self, where: np.ndarray, speed: np.ndarray) -> dict[str, float]:
        """The unknown forces at a state."""
        names = (item.multiplier for item in self.equations.kept)
        return dict(zip(names, self.equations.at(where, speed).multipliers.tolist(), strict=True))

    # --- comparison

    def compare_motion(self, start: Start, *, from_start: bool) -> None:
        """Along the motion from a state; from the declared start also what depends on position alone."""
        time = self.usual_time(start)
        account = self.account if from_start else {}
        mechanism, began = self.placement.mechanism, self.placement.mechanism.clock
        first = np.concatenate([start.where, start.speed, np.zeros(len(account) + len(self.levers)), [began]])
        done = trajectory(self.rate(account), first, time)
        q, energies, momenta, size = start.q, [], [], self.equations.size
        for state in done:
            mechanism.clock = float(state[-1])
            q, known, values = self._compare(state[:size], state[size : 2 * size], q)
            turned = state[2 * size + len(account) : -1]
            momenta.append([known.of(value) for _, value in self.derived.momenta.values()] - turned)
            kinetic = self.equations.kinetic_energy(state[size : 2 * size])
            if self.derived.integral is not None:
                energies.append((known.of(self.derived.integral), kinetic))
            if from_start:
                self._compare_positions(known, values, state[2 * size : 2 * size + len(account)])
        self.drifts.append(_drift(energies))
        self.momentum_drifts.append(_spread(np.array(momenta), self.equations.momentum(start.speed)))
        mechanism.clock = began

    def rate(self, account: Mapping[tuple[str, str, bool], int] | None = None) -> Rate:
        """d/dt of (X, V, works, torque impulses, t); without an account of (X, V, t)."""
        size, equations = self.equations.size, self.equations

        def rate(time: float, state: np.ndarray) -> np.ndarray:
            where, speed = state[:size], state[size : 2 * size]
            equations.mechanism.clock = float(state[-1])
            balance = equations.at(where, speed)
            if account is None:
                return np.concatenate([speed, balance.gained, [1.0]])
            powers, torques = equations.powers(speed, balance, account), equations.torques(balance, self.levers)
            return np.concatenate([speed, balance.gained, powers, torques, [1.0]])

        return rate

    def _compare(self, where: np.ndarray, speed: np.ndarray, near: State) -> tuple[np.ndarray, Values, dict[str, float]]:
        """q̈ and the unknown forces at one state; returns (q, derived numbers, simulated forces)."""
        balance, placement = self.equations.at(where, speed), self.placement
        x, v = where.tolist(), speed.tolist()
        self.gap = max(self.gap, *(abs(row.value) for row in balance.rows), 0.0)
        q, rates = placement.state(x, v, near)
        gained = dict(zip(placement.names, placement.accelerations(q, rates, x, v, balance.gained), strict=True))
        known = self._derived_numbers(placement.numbers(q, rates))
        for name in self.derived.system.independent:
            self.errors.note("acceleration", name, known.names[f"{name}_ddot"], gained[name])
        forces = dict(zip((item.multiplier for item in self.equations.kept), balance.multipliers, strict=True))
        for name, value in self.derived.dynamics.reactions.items():
            self.errors.note("force", name, known.of(value), forces[name])
        self.states += 1
        return q, known, forces

    def _derived_numbers(self, names: dict[str, float]) -> Values:
        """Coordinates, speeds and the derived accelerations, from M q̈ = f where there are no formulas."""
        known, dynamics = Values(names), self.derived.dynamics
        wanted = self.derived.system.accelerations
        if dynamics.accelerations is not None:
            try:
                found = [number(dynamics.accelerations[name], names) for name in wanted]
            except NoNumber:  # a string that would run through its pulley
                raise NotApplicable("the accelerations have no value at a state at which they are tried") from None
        else:
            matrix = np.array([known.row(row) for row in dynamics.mass_matrix])
            found = np.linalg.solve(matrix, np.array(known.row(dynamics.forcing))).tolist()
        return Values({**names, **dict(zip(wanted, found, strict=True))})

    def _compare_positions(self, known: Values, forces: Mapping[str, float], works: np.ndarray) -> None:
        """Squares of speeds, unknown forces and works as functions of position."""
        for name, value in self.derived.squares.items():
            self.errors.note("square of speed", name, known.of(value), known.names[f"{name}_dot"] ** 2)
        for name, value in self.derived.along.items():
            self.errors.note("force along the motion", name, known.of(value), forces[name])
        for key, done in zip(self.account, works, strict=True):
            name, body, turning = key
            half = "rotational" if turning else "translational"
            self.errors.note("work", f"{name} on {body}, {half}", known.of(self.derived.works[key]), float(done))

    def report(self) -> SimulationReport:
        """All of it. A number of degrees of freedom other than the derived one counts as infinitely wrong."""
        found = self.errors.relative()
        if self.generic.freedom != len(self.derived.system.independent):
            found["degrees of freedom"] = np.inf
        drift = max(self.drifts, default=0.0) if self.derived.integral is not None else None
        turned = max(self.momentum_drifts, default=0.0) if self.derived.momenta else None
        worst = float(max([*found.values(), drift or 0.0, turned or 0.0], default=0.0))
        return SimulationReport(worst, found, drift, self.states, self.generic.freedom, turned, float(self.gap))


def _drift(energies: Sequence[tuple[float, float]]) -> float:
    """How much the first integral varies, relative to its size or to the kinetic energy."""
    values = [value for value, _ in energies]
    scale = max((max(abs(value), kinetic) for value, kinetic in energies), default=0.0) or 1.0
    return float((max(values) - min(values)) / scale) if values else 0.0


def _spread(values: np.ndarray, least: float) -> float:
    """How much each column varies, relative to its largest value or to the momentum at the start."""
    if not values.size:
        return 0.0
    scale = np.maximum(np.abs(values).max(axis=0), max(least, NOISE))
    return float(((values.max(axis=0) - values.min(axis=0)) / scale).max())


def simulate(derived: Derived, numbers: Mapping[str, float] | None = None) -> SimulationReport:
    """Runs the simulation and compares. `numbers`: for parameters, instead of sample numbers. Raises NotApplicable, with
    a sentence, for a kind of constraint or interaction that the simulation does not know, or a start that can't be found."""
    bench = Bench(derived, numbers)
    bench.compare_generic_states()
    bench.compare_motion(bench.generic, from_start=False)
    bench.placement.mechanism.clock = 0.0
    declared = bench.declared_start()
    if declared is not None:
        bench.compare_motion(declared, from_start=True)
    return bench.report()


def simulate_study(study: Study, numbers: Mapping[str, float] | None = None) -> SimulationReport:
    """Everything that a study derives, put to the test. Raises as `simulate`."""
    if study.instant is not None:
        return simulate_start(study, study.instant, numbers)
    along, momenta = study.reactions_along_motion or {}, angular_momenta(study)
    derived = Derived(study.system, study.dynamics, study.first_integral, study.squares, along, momenta=momenta)
    return simulate(derived, numbers)


def told(study: Study) -> Dynamics:
    """The dynamics; where only the start is told, what the accelerations and unknown forces are there."""
    found = study.instant
    return study.dynamics if found is None else Dynamics((), (), found.accelerations, found.reactions, {}, {})


def simulate_start(study: Study, found: Instant, numbers: Mapping[str, float] | None = None) -> SimulationReport:
    """Speeds that follow, accelerations and unknown forces at the start, put to the test. Raises as `simulate`."""
    bench = Bench(Derived(study.system, told(study)), numbers)
    bench.placement.mechanism.clock = 0.0
    start = there(bench.declared_start(found.sought))
    bench.compare_start(start)
    for name, value in found.speeds.items():
        rate = start.rates[bench.placement.names.index(name)]
        bench.errors.note("speed", name, number(value, bench.sample), float(rate))
    errors = bench.errors.relative()
    if start.freedom != found.freedom:
        errors["degrees of freedom"] = np.inf
    return SimulationReport(max(errors.values()), errors, None, bench.states, start.freedom)


def angular_momenta(study: Study) -> dict[str, tuple[Vector, Scalar]]:
    """By origin: where it is, and the derived angular momentum of the whole system about it."""
    states = study.system.bodies.values()
    return {
        name: (origin, sum((energy.orbital_momentum(s, origin) + energy.spin_momentum(s) for s in states), NOTHING))
        for name, origin in study.origins.items()
    }


def known_works(works: Iterable[ForceWork]) -> dict[tuple[str, str, bool], Scalar]:
    """Values of works that are known, by (force, body, whether rotational)."""
    halves = [
        ((item.force, item.on, turning), half.value)
        for item in works
        for turning, half in ((False, item.translational), (True, item.rotational))
    ]
    return {key: value for key, value in halves if value is not None}
