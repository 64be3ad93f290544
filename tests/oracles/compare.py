"""All that a derivation asserts of a motion, put to the simulation at one set of numbers after the other.

What is found is a table of relative differences by name ("first: force N", "rolling: place x"); what cannot be
compared is named with its reason. Told and yet not so counts as infinitely wrong.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from rbpsym.errors import NotApplicable
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import Scalar
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.numbers import Values, number
from rbpsym.mechanics.phases import Stage, known_stages
from rbpsym.mechanics.pushing import ways_taken
from rbpsym.mechanics.study import Study
from rbpsym.oracles import simulation_phases
from rbpsym.oracles.simulation import Bench, Derived, Errors, angular_momenta, known_works
from rbpsym.statement.model import Problem
from tests.oracles.motion import CLOSE, LONGEST, NEAR, Followed, Unfit, declared_start, follow, forces_at
from tests.oracles.sets import Numbers, bounds, drawn

LIMIT = 1e-6
MOST_DRAWS = 40  # for a set that fits
SAMPLES = 24
LOOKS = 48  # places of a range at which the force at rest is looked at
WRONG = math.inf


@dataclass
class Findings:
    """Over all sets of a problem: the worst differences, what cannot be compared, and the draws."""

    errors: dict[str, float] = field(default_factory=dict)
    witness: dict[str, Numbers] = field(default_factory=dict)
    missing: dict[str, str] = field(default_factory=dict)
    sets: int = 0
    redrawn: Counter[str] = field(default_factory=Counter)
    compared: Counter[str] = field(default_factory=Counter)

    def note(self, name: str, error: float, numbers: Numbers) -> None:
        """One difference; the worst is kept with its numbers."""
        self.compared[name] += 1
        error = error if error == error else WRONG
        if error > self.errors.get(name, -1.0):
            self.errors[name], self.witness[name] = error, numbers

    def wrong(self, limit: float = LIMIT) -> dict[str, tuple[float, Numbers]]:
        """What differs by more, with the parameters at which it does."""
        return {name: (error, self.witness[name]) for name, error in self.errors.items() if not error <= limit}


def _stages(study: Study) -> tuple[tuple[Stage, ...], str]:
    """The phases as far as they are known, and why they are not known further."""
    if not study.problem.phases:
        return (Stage(study.problem.name, study),), ""
    parts, reason = known_stages(study.problem)
    return parts, "" if reason is None else reason.what


def findings(study: Study, sets: int, longest: float = LONGEST, seed: int = 2011) -> Findings:
    """The comparison at that many sets that fit the statement, each motion followed for `longest` usual times at most."""
    found, draws, stages = Findings(), 0, _stages(study)
    for numbers in drawn(study, seed):
        if found.sets >= sets or draws >= MOST_DRAWS * sets:
            break
        draws += 1
        own = Findings()
        try:
            _at(study.problem, stages, numbers, own, longest)
        except Unfit as reason:
            found.redrawn[str(reason)] += 1
            continue
        for name, error in own.errors.items():
            found.note(name, error, numbers)
        found.missing |= own.missing
        found.sets += 1
    if found.sets < sets:
        found.missing["sets"] = f"only {found.sets} of {sets} sets fit in {draws} draws: {_most(found.redrawn)}"
    return found


def _most(reasons: Counter[str]) -> str:
    return "; ".join(reason for reason, _ in reasons.most_common(2))


def _at(problem: Problem, stages: tuple[tuple[Stage, ...], str], numbers: Numbers, found: Findings, longest: float) -> None:
    """All stages at one set."""
    parts, reason = stages
    if reason:
        found.missing["phases"] = reason
    for place, stage in enumerate(parts):
        label = "first" if place == 0 else stage.name
        ends = place + 1 < len(parts)
        phase = problem.phases[place] if place < len(problem.phases) else None
        try:
            time = _handed_over(phase, stage, parts[place + 1], numbers, found) if ends else None
            _one(stage.study, numbers, label, time, found, longest)
        except NotApplicable as error:
            raise Unfit(error.what) from None
        except np.linalg.LinAlgError as error:
            raise Unfit(str(error)) from None


# --- one phase


def _own(study: Study, numbers: Numbers) -> Numbers:
    """The numbers of a later phase: its coordinates begin elsewhere."""
    from rbpsym.mechanics.numbers import _middle, _speed

    found = dict(numbers)
    try:
        for coordinate in study.problem.coordinates:
            found[coordinate.name] = _middle(coordinate, found)
            found[f"{coordinate.name}_dot"] = _speed(coordinate, found)
    except (ValueError, ZeroDivisionError) as error:
        raise Unfit(f"the start of a phase has no number: {error}") from None
    return found


def _bench(study: Study, numbers: Numbers) -> Bench:
    along = study.reactions_along_motion or {}
    works = known_works(study.works)
    derived = Derived(
        study.system, study.dynamics, study.first_integral, study.squares, along, works, angular_momenta(study)
    )
    try:
        return Bench(derived, _own(study, numbers))
    except (ValueError, ZeroDivisionError) as error:
        raise Unfit(f"the bodies can't be placed: {error}") from None


def _one(study: Study, numbers: Numbers, label: str, time: float | None, found: Findings, longest: float) -> None:
    bench = _bench(study, numbers)
    _goes_as_told(study, bench.sample)
    own = Findings()
    _rests(bench, study, numbers, own)
    start = declared_start(bench)
    if start is None:
        own.missing["motion"] = "no start is declared in full"
        bench.errors = Errors()
        bench.compare_generic_states()
        for name, error in bench.errors.relative().items():
            own.note(name, error, numbers)
    elif time == 0.0:
        own.missing["motion"] = "the phase ends at once"
    else:
        start, worked = _moving_start(bench, study, start)
        seen = follow(bench, study, start, time, worked, longest)
        _motion(bench, study, start, seen, own, numbers)
        _losses(bench, study, start, seen, own, numbers)
        _grips(bench, study, seen, own, numbers)
    for name, error in own.errors.items():
        found.note(f"{label}: {name}", error, numbers)
    found.missing |= {f"{label}: {name}": reason for name, reason in own.missing.items()}


def _goes_as_told(study: Study, numbers: Numbers) -> None:
    """Strings run, and things touch, at the start on the side that the formulas are told for."""
    for element, value in ways_taken(study):
        if not number(value, numbers) > 0:
            raise Unfit(f"{element.name} runs, or touches, on another side at the start than is told")


def _moving_start(bench: Bench, study: Study, start):
    """The start and no works; half-way to where it goes, and the works until there, if it stays for ever where it starts."""
    at = bench.equations.at(start.where, start.speed)
    if max(np.abs(at.gained).max(initial=0.0), np.abs(start.speed).max(initial=0.0)) >= 1e-9 or len(study.squares) != 1:
        return start, {}
    [name] = study.squares
    low, high = bounds(study, name, bench.sample)
    goals = [here for loss in study.losses if (here := (_told_at(loss, bench.sample) or {}).get(name)) is not None]
    goals += [end for end in (high, low) if end is not None]
    begin = number(study.system.scope.start[name], bench.sample)
    goals = [goal for goal in goals if abs(goal - begin) > 1e-3 and math.isfinite(goal)]
    if not goals or study.first_integral is None or abs(number(study.squares[name], {**bench.sample, name: goals[0]})) < 1e-12:
        return start, {}
    half = simulation_phases._on_the_way(bench, study, {name: goals[0]})
    known = {**bench.sample, name: (begin + goals[0]) / 2}
    return half, {key: number(value, known) for key, value in bench.derived.works.items()}


def _motion(bench: Bench, study: Study, start, seen: Followed, found: Findings, numbers: Numbers) -> None:
    """Accelerations, forces, squares of speeds and works along the motion."""
    size, q = bench.equations.size, start.q
    states = seen.states[:: max(1, len(seen.states) // SAMPLES)]
    bench.errors = Errors()
    first, powers = None, Errors()
    for state in states:
        bench.placement.mechanism.clock = float(state[-1])
        q, known, forces = bench._compare(state[:size], state[size : 2 * size], q)
        try:
            bench._compare_positions(known, forces, state[2 * size : 2 * size + len(bench.account)])
        except (ValueError, ZeroDivisionError):
            found.note("a formula has no number along the motion", WRONG, numbers)
        _powers(bench, study, state, known, forces, powers)
        if study.first_integral is not None:
            value = known.of(study.first_integral)
            first = value if first is None else first
            scale = max(abs(value), abs(first), bench.equations.kinetic_energy(state[size : 2 * size]), 1e-3)
            found.note("energy", abs(value - first) / scale, numbers)
    for name, error in {**bench.errors.relative(), **powers.relative()}.items():
        found.note(name, error, numbers)
    if study.problem.constraints and study.reactions_along_motion is None:
        found.missing["forces along the motion"] = "no functions of position; compared as functions of the state"
    for item in study.works:
        for half, work in (("translational", item.translational), ("rotational", item.rotational)):
            if work.value is None:
                found.missing[f"work {item.force} on {item.on}, {half}"] = "its value has no closed form; the power is compared"


def _powers(bench: Bench, study: Study, state: np.ndarray, known, forces: Mapping[str, float], errors: Errors) -> None:
    """The integrand of each half of each work, with the simulated forces: F·V and τ ω."""
    size = bench.equations.size
    where, speed = state[:size], state[size : 2 * size]
    balance = bench.equations.at(where, speed)
    halves = [(w, turning, half) for w in study.works for turning, half in ((False, w.translational), (True, w.rotational))]
    account = {(w.force, w.on, turning): k for k, (w, turning, _) in enumerate(halves)}
    seen = bench.equations.powers(speed, balance, account)
    names = Values({**known.names, **forces})
    for (item, turning, half), power in zip(halves, seen, strict=True):
        told = sum(names.of(part) * (1.0 if q == "t" else known.names[f"{q}_dot"]) for q, part in half.parts.items())
        errors.note("power", f"{item.force} on {item.on}, {'rotational' if turning else 'translational'}", told, float(power))


def _coordinate(bench: Bench, state: np.ndarray, near) -> dict[str, float]:
    q = bench.placement.coordinates(state[: bench.equations.size].tolist(), near)
    return dict(zip(bench.placement.names, map(float, q), strict=True))


# --- what ends first


def holds(demands, numbers: Mapping[str, float]) -> bool:
    """Are the conditions met under which something is told?"""
    for demand in demands:
        try:
            value = number(demand.value, numbers)
        except (ValueError, ZeroDivisionError):
            return False
        if not {">": value > 0, ">=": value >= 0, "!=": value != 0, "<": value < 0, "<=": value <= 0}[demand.op]:
            return False
    return True


def _value(value: Scalar, numbers: Mapping[str, float]) -> float | None:
    try:
        return number(value, numbers)
    except (ValueError, ZeroDivisionError, OverflowError):
        return None


def _losses(bench: Bench, study: Study, start, seen: Followed, found: Findings, numbers: Numbers) -> None:
    """The first loss of contact is told where it comes, and none is told that does not come."""
    if not any(pushes(element) for element in study.problem.constraints):
        return
    if study.reactions_along_motion is None:
        found.missing["losses of contact"] = "the forces are no functions of position"
        return
    if study.system.implicit:
        found.missing["losses of contact"] = "coordinates stay tied by an equation"
        return
    for name, least in seen.least.items():
        ended = seen.event is not None and f"{seen.event.kind} {seen.event.of}" == name
        if name.startswith("lost") and not ended and least < NEAR:
            raise Unfit(f"a force comes next to nothing: {name}")
    q, visited = start.q, []
    for state in [*seen.states, *([seen.event.state] if seen.event else [])]:
        q = np.array(list(_coordinate(bench, state, q).values()))
        visited.append(dict(zip(bench.placement.names, map(float, q), strict=True)))
    known = {**bench.sample, **visited[-1]}
    event = seen.event if seen.event and seen.event.kind == "lost" else None
    told = [(loss, _told_at(loss, bench.sample)) for loss in study.losses]
    if event is not None:
        gap = _gap(event.of, told, known, visited)
        if gap == WRONG and event.of in {loss.force for loss in study.ended.open_}:
            found.missing["place of a loss"] = "it is told that it is not decided"
        elif gap == WRONG and study.ended.complete is not True and not study.ended.open_:  # what is named leaves the rest decided
            found.missing[f"loss of {event.of}"] = f"the list is not said to be complete: {study.ended.reason}"
        else:
            found.note(f"place where {event.of} is lost", gap, numbers)
    for loss, at in told:
        if at is None or (event is not None and loss.force in (event.of, *event.also) and _is_near(at, known, visited)):
            continue
        if not seen.is_whole and not all(_is_between(n, v, visited) for n, v in at.items()):
            found.missing["later losses"] = "the motion was not followed to its end"
            continue
        found.note(f"loss of {loss.force} that is told", WRONG, numbers)


def _told_at(loss, numbers: Mapping[str, float]) -> dict[str, float] | None:
    """Where the loss is told at these numbers; None if it is not told there."""
    if not loss.at or not holds(getattr(loss, "valid", ()), numbers):
        return None
    at = {name: _value(value, numbers) for name, value in loss.at.items()}
    return {name: WRONG if value is None else value for name, value in at.items()}


def _span(name: str, visited: list[dict[str, float]]) -> float:
    values = [place[name] for place in visited]
    return max(max(values) - min(values), CLOSE)


def _is_near(at: Mapping[str, float], known: Mapping[str, float], visited: list[dict[str, float]]) -> bool:
    return all(abs(value - known[name]) <= LIMIT * _span(name, visited) for name, value in at.items())


def _is_between(name: str, value: float, visited: list[dict[str, float]]) -> bool:
    values = [place[name] for place in visited]
    return min(values) <= value <= max(values)


def _gap(force: str, told: list, known: Mapping[str, float], visited: list[dict[str, float]]) -> float:
    """How far the told place (or the told equation) is from what was seen; infinite if nothing is told."""
    gaps = [WRONG]
    for loss, at in told:
        if loss.force == force and at is not None:
            gaps.append(max(abs(value - known[name]) / _span(name, visited) for name, value in at.items()))
        elif loss.force == force and not loss.at:
            values = [_value(loss.factor, {**known, **place}) for place in visited]
            size = max((abs(value) for value in values if value is not None), default=1.0)
            here = _value(loss.factor, known)
            gaps.append(WRONG if here is None else abs(here) / (size or 1.0))
    return min(gaps)


def _grips(bench: Bench, study: Study, seen: Followed, found: Findings, numbers: Numbers) -> None:
    """What static friction is said to need, and whether it is said to hold."""
    for need in study.friction_needs:
        if need.limit is None:
            continue
        slipped = seen.event is not None and seen.event.kind == "slips" and seen.event.of == need.constraint
        if need.holds is not None:
            found.note(f"grip of {need.constraint}", WRONG if slipped is need.holds else 0.0, numbers)


# --- rest


def _rests(bench: Bench, study: Study, numbers: Numbers, found: Findings) -> None:
    """At each equilibrium that is told nothing moves, no contact pulls, and it lies in the ranges."""
    sample = bench.sample
    for place, item in enumerate(study.equilibria):
        if not holds(getattr(item, "valid", ()), sample):
            continue
        at = {name: _value(value, sample) for name, value in item.at.items()}
        if None in at.values():
            found.note(f"equilibrium {place} exists", WRONG, numbers)
            continue
        found.note(f"equilibrium {place}", _unrest(bench, study, at), numbers)
    _others(bench, study, found, numbers)
    item = study.open_balance
    if item is not None:
        at = _balanced(item, study, sample)
        if at is None:
            found.missing["open balance"] = "no root between the ends of the range"
        else:
            found.note("open balance", _unrest(bench, study, {item.name: at}), numbers)


def _others(bench: Bench, study: Study, found: Findings, numbers: Numbers) -> None:
    """Where the list of equilibria is said to be complete, the only coordinate rests nowhere else in its range."""
    from scipy.optimize import brentq

    if study.rest.complete is not True or len(study.system.independent) != 1 or study.system.has_clock:
        return
    [name] = study.system.independent
    low, high = bounds(study, name, bench.sample)
    if None in (low, high) or not is_autonomous(study):
        return
    told = [_value(item.at[name], bench.sample) for item in study.equilibria if name in item.at]
    force = study.dynamics.forcing[0]
    still = {**bench.sample, f"{name}_dot": 0.0}

    def push(value: float) -> float:
        return number(force, {**still, name: value})

    places = [low + (high - low) * (k + 0.5) / LOOKS for k in range(LOOKS)]
    try:
        values = [push(place) for place in places]
    except (ValueError, ZeroDivisionError, KeyError):
        return
    size = max(map(abs, values)) or 1.0
    for a, b, x, y in zip(places, places[1:], values, values[1:], strict=False):
        if x * y < 0 and min(abs(x), abs(y)) > 1e-9 * size:
            root = brentq(push, a, b, xtol=1e-14, rtol=1e-14)
            if _unrest(bench, study, {name: root}) < LIMIT:
                near = min((abs(root - place) for place in told if place is not None), default=WRONG)
                found.note("an equilibrium that is not told", near, numbers)


def is_autonomous(study: Study) -> bool:
    """Does no force depend on the time, and do all coordinates follow from the one?"""
    return not study.system.implicit and all(study.dynamics.ideal.values())


def _balanced(item, study: Study, numbers: Mapping[str, float]) -> float | None:
    from scipy.optimize import brentq

    low, high = bounds(study, item.name, numbers)
    if None in (low, high):
        return None

    def force(value: float) -> float:
        return number(item.force, {**numbers, item.name: value})

    try:
        edge = 1e-9 * (high - low)
        return brentq(force, low + edge, high - edge, xtol=1e-14, rtol=1e-14)
    except (ValueError, ZeroDivisionError):
        return None


def _unrest(bench: Bench, study: Study, at: Mapping[str, float]) -> float:
    """The largest acceleration there (relative to what gravity or the forces give), infinite where rest is not possible."""
    for name, value in at.items():
        low, high = (
            None if node is None else number(scalar(node), bench.sample)
            for node in (study.problem.coordinate(name).lower, study.problem.coordinate(name).upper)
        )
        if (low is not None and value < low - CLOSE) or (high is not None and value > high + CLOSE):
            return WRONG
    still = dict.fromkeys(study.system.independent, 0.0)
    start = bench.start(at, still, at)
    state = np.concatenate([start.where, np.zeros(len(start.speed)), [0.0]])
    balance = bench.equations.at(start.where, np.zeros(len(start.speed)))
    forces = forces_at(bench, state)
    size = max([*map(abs, forces.values()), float(np.abs(bench.equations.masses[::3]).max()) * bench.sample.get("g", 1.0)])
    for element in study.problem.constraints:
        if any(forces[name] < -CLOSE * size for name in pushes(element)):
            return WRONG
        limit = element.values.get("limit")
        if limit is not None:
            most = bench.placement.mechanism.number(limit) * forces[element.name]
            if abs(forces[element["friction"]]) > most + CLOSE * size:
                return WRONG
    pushed = np.abs(balance.gained * bench.equations.masses)
    reach = np.tile([1.0, 1.0, 1 / bench.placement.mechanism.reach()], len(pushed) // 3)
    return float((pushed * reach).max(initial=0.0) / size)


# --- from one phase to the next


def _handed_over(phase, stage: Stage, after: Stage, numbers: Numbers, found: Findings) -> float:
    """The hand-over is that of the simulation; returns the time at which the phase ends."""
    errors = Errors()
    parameters = {name: value for name, value in numbers.items() if name not in _moving(stage.study.problem)}
    times: list[float] = []
    try:
        simulation_phases._compare(phase, stage.study, after, parameters, errors, times.append)
    except (ValueError, ZeroDivisionError) as error:
        raise Unfit(f"the end of a phase has no number: {error}") from None
    for name, error in errors.relative().items():
        found.note(f"{after.name}: {name}", error, numbers)
    return times[0]


def _moving(problem: Problem) -> set[str]:
    return {part for c in problem.coordinates for part in (c.name, f"{c.name}_dot")} | {"t"}


def each(found: Findings) -> Iterator[str]:
    """What is wrong, a line each."""
    for name, (error, numbers) in found.wrong().items():
        shown = ", ".join(f"{key} = {value:.6g}" for key, value in numbers.items() if not key.endswith("_dot"))
        yield f"{name}: {error:.1e} at {shown}"


Note = Callable[[str, float, Numbers], None]
