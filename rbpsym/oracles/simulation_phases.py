"""The phases followed in numbers: events located on the simulated motion, impulses in maximal coordinates.

Each phase is simulated from its start until its end is seen (slip gone, normal force or grip used up, a
coordinate at its value); time, places and speeds there must be those that were derived. Then the
impulses are solved for all bodies at once, M (V' - V) = Gᵀ Ĵ + given ones with G V' = 0 and
n·(v₂' - v₁') = -e n·(v₂ - v₁), and speeds, impulses and the loss of energy are compared.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

import numpy as np

from rbpsym.elements.events import EVENTS
from rbpsym.elements.impulses import IMPULSES
from rbpsym.elements.kinds import KindParts
from rbpsym.errors import NotApplicable, there
from rbpsym.field import Scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.numbers import floating, number, samples
from rbpsym.mechanics.phases import Stage, followable, known_stages
from rbpsym.mechanics.study import Study
from rbpsym.numeric import integration
from rbpsym.oracles.simulation import Bench, Derived, Errors, SimulationReport, simulate_study, told
from rbpsym.oracles.simulation_bodies import Mechanism, placed
from rbpsym.oracles.simulation_contacts import ROWS
from rbpsym.oracles.simulation_joints import Kept
from rbpsym.oracles.simulation_placement import Start
from rbpsym.statement.model import Element, Phase, PointRef, Problem

LONGEST = 200.0  # lengths of the usual motion in which an event must have come
Watch = Callable[[float, np.ndarray, np.ndarray], float]


def simulate_problem(study: Study) -> SimulationReport:
    """The report on a problem and all its phases. Raises NotApplicable as `simulate`."""
    first = simulate_study(study)
    if not study.problem.phases:
        return first
    parts, _ = known_stages(study.problem)
    numbers = _parameters(study.problem, parts)
    reports = [simulate_study(stage.study, numbers) for stage in parts[1:]]
    errors = dict(first.errors)
    for stage, report in zip(parts[1:], reports, strict=True):
        errors |= {f"{stage.name}: {name}": error for name, error in report.errors.items()}
    errors |= followed(study.problem, parts)
    worst = max([first.max_relative_error, *errors.values(), *(r.max_relative_error for r in reports)])
    return replace(first, max_relative_error=float(worst), errors=errors)


def _parameters(problem: Problem, parts: tuple[Stage, ...]) -> dict[str, float]:
    """Numbers at which the motion comes to all phases."""
    asked = [demand.value for demand in followable(parts)]
    fitting = (found for found in samples(problem) if all(floating(value, found) > 0 for value in asked))
    numbers = next(fitting, None)
    if numbers is None:
        raise NotApplicable("at none of the sample numbers does the motion come to all phases")
    return {q.name: numbers[q.name] for q in problem.parameters}


def followed(problem: Problem, parts: tuple[Stage, ...]) -> dict[str, float]:
    """Relative differences between derived and simulated events and impulses, by phase and quantity."""
    numbers, found = _parameters(problem, parts), dict[str, float]()
    for phase, before, after in zip(problem.phases, parts, parts[1:], strict=False):
        errors = Errors()
        _compare(phase, before.study, after, numbers, errors)
        found |= {f"{phase.name}: {name}": error for name, error in errors.relative().items()}
    return found


def _bench(study: Study, numbers: Mapping[str, float]) -> Bench:
    return Bench(Derived(study.system, told(study), squares=study.squares), numbers)


def _compare(
    phase: Phase,
    study: Study,
    after: Stage,
    numbers: Mapping[str, float],
    errors: Errors,
    ended: Callable[[float], object] = lambda time: None,
) -> None:
    """`ended` is told how long the phase before has lasted."""
    bench, next_bench, began = _bench(study, numbers), _bench(after.study, numbers), there(after.began)
    derived = {name: number(value, numbers) for name, value in began.before.places.items()}
    time = None if began.before.time is None else number(began.before.time, numbers)
    end = _end(bench, phase, study, derived, time or 0.0)
    ended(end.time)
    if time is not None:
        errors.note("time", "until the phase", time, end.time)
    guess = [derived[name] for name in bench.placement.names]
    q, rates = bench.placement.state(end.where.tolist(), end.speed.tolist(), guess)
    speed, impulses = struck(bench, next_bench, end, phase.impulses)
    after_rates = next_bench.placement.speeds(q, end.where.tolist(), speed.tolist())
    _note(errors, "place", bench, began.before.places, numbers, q)
    _note(errors, "speed before", bench, began.before.speeds, numbers, rates)
    _note(errors, "speed after", bench, began.speeds, numbers, after_rates)
    for name, value in began.impulses.items():
        errors.note("impulse", name, number(value, numbers), impulses[name])
    lost = bench.equations.kinetic_energy(end.speed) - bench.equations.kinetic_energy(speed)
    errors.note("energy", "lost", number(began.energy_lost, numbers), lost)


def _note(
    errors: Errors, kind: str, bench: Bench, derived: Mapping[str, Scalar], numbers: Mapping[str, float], seen: np.ndarray
) -> None:
    for name, value in zip(bench.placement.names, seen, strict=True):
        errors.note(kind, name, number(derived[name], numbers), float(value))


# --- the event


def _end(bench: Bench, phase: Phase, study: Study, derived: Mapping[str, float], time: float) -> End:
    """The simulated state at the event. Raises NotApplicable if it does not come."""
    bench.placement.mechanism.clock = 0.0
    start = bench.declared_start()
    if start is None:
        raise NotApplicable("the phases need a start and a start speed of every coordinate")
    if phase.event == "at once":
        return End(0.0, start.where, start.speed)
    if study.squares and _is_idle(bench, start):  # what is pushed by the time alone moves off
        start = _on_the_way(bench, study, derived)
    return _seen(bench, start, WATCHES[phase.event](bench, phase, start), time)


def _is_idle(bench: Bench, start: Start) -> bool:
    """At rest where nothing moves it: on top of a sphere, say, which it leaves in no finite time."""
    gained = bench.equations.at(start.where, start.speed).gained
    return float(max(np.abs(gained).max(), np.abs(start.speed).max())) < 1e-9


def _on_the_way(bench: Bench, study: Study, derived: Mapping[str, float]) -> Start:
    """Half-way to the event, with the speed from the first integral."""
    [name] = study.squares
    known = {**bench.sample, **derived}
    begin = number(study.system.scope.start[name], known)
    here = (begin + derived[name]) / 2
    rate = number(study.squares[name], {**known, name: here}) ** 0.5
    return bench.start({name: here}, {name: rate if derived[name] > begin else -rate}, (name,))


def _seen(bench: Bench, start: Start, watch: Watch, time: float) -> End:
    """The first change of sign along the motion; it is looked for longer than it is said to take."""
    size, step = bench.equations.size, bench.usual_time(start)

    def left(time: float, state: np.ndarray) -> float:
        bench.placement.mechanism.clock = float(state[-1])
        return watch(time, state[:size], state[size : 2 * size])

    event = integration.Event(left)
    first = np.concatenate([start.where, start.speed, [0.0]])
    path = integration.followed(bench.rate(), first, max(LONGEST * step, 2 * time), events=(event,), longest=step / 10)
    if not path.seen[0]:
        raise NotApplicable("the event that begins a phase is not seen in the simulated motion")
    [time] = path.seen[0]
    state = path.at(time)
    return End(time, state[:size], state[size : 2 * size])


WATCHES: Mapping[str, Callable[[Bench, Phase, Start], Watch]] = KindParts(EVENTS, "row", "watch")


def stated_element(bench: Bench, name: str) -> Element:
    """A constraint of the problem that is simulated, by its name."""
    return next(e for e in bench.placement.mechanism.problem.constraints if e.name == name)


# --- impulses in maximal coordinates: the speeds after, and what each kind of impulse adds to their equations
# The `struck` of a kind, in the module `row` of its folder, gives its known impulse and its unknown ones, each with the
# condition under which it parts.


class End(Frozen):
    """The simulated state at an event: time since the start of the phase, X, V."""

    time: float
    where: np.ndarray
    speed: np.ndarray


class Parting(Frozen):
    """An unknown impulse of size 1 as a generalized impulse, with what comes in proportion to it; after it the speed along
    the line is `wanted`."""

    name: str
    line: np.ndarray
    drag: np.ndarray
    wanted: float


Strikes = tuple[np.ndarray | float, list[Parting]]
STRUCK: KindParts[Callable[[Element, Bench, End], Strikes]] = KindParts(IMPULSES, "row", "struck")


def struck(
    before: Bench, after: Bench, end: End, impulses: tuple[Element, ...]
) -> tuple[np.ndarray, dict[str, float]]:
    """V after, and the impulses by the name of their force."""
    where, speed, size = end.where.tolist(), end.speed.tolist(), before.equations.size
    rows = [parting(kept, end, -kept.at(where, speed).drift) for kept in after.equations.kept]
    momentum = before.equations.masses * end.speed
    for element in impulses:
        given, own = STRUCK[element.kind](element, before, end)
        momentum, rows = momentum + given, [*rows, *own]
    g = np.array([row.line for row in rows]).reshape(len(rows), size)
    pushes = g + np.array([row.drag for row in rows]).reshape(len(rows), size)
    full = np.block([[np.diag(before.equations.masses), -pushes.T], [g, np.zeros((len(g), len(g)))]])
    found = np.linalg.lstsq(full, np.concatenate([momentum, [row.wanted for row in rows]]), rcond=None)[0]
    return found[:size], dict(zip((row.name for row in rows), found[size:].tolist(), strict=True))


def parting(kept: Kept, end: End, wanted: float) -> Parting:
    """The impulse of what keeps a condition; friction comes in proportion to its multiplier."""
    where, size = end.where.tolist(), end.speed.size
    drag = [entry for drag in kept.drags if drag.strikes for entry in drag.at(where, [])]
    return Parting(kept.multiplier, dense(kept.at(where, end.speed.tolist()).entries, size), dense(drag, size), wanted)


def met(element: Element, mechanism: Mechanism, start: list[float]) -> list[Kept]:
    """The conditions of a bounce, or of a constraint that begins, as those of a constraint that lasts."""
    values = element.values
    way = "string" if "path" in values else "rolling" if values.get("slip") == "none" else "contact"
    return ROWS[way if element.kind in IMPULSES else element.kind](element, mechanism, start)


def dense(entries: Iterable[tuple[int, float]], size: int) -> np.ndarray:
    """A row with all its zeros."""
    row = np.zeros(size)
    for column, entry in entries:
        row[column] += entry
    return row


def along(bench: Bench, end: End, *ends: tuple[PointRef, tuple[float, float]]) -> np.ndarray:
    """The generalized impulse of impulses at points."""
    size, where = bench.equations.size, end.where.tolist()
    spots = ((placed(bench.placement.mechanism.spot(ref), where, [0.0] * size), way) for ref, way in ends)
    return sum((dense(spot.along(*way), size) for spot, way in spots), np.zeros(size))
