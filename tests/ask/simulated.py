"""Answers put to the simulation in maximal coordinates: where phases begin and end, where contacts are lost, on the way."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.ask.found import Answer
from rbpsym.ask.numbers import value_at
from rbpsym.errors import NotApplicable, RbpsymError, StatementError
from rbpsym.field.calculus import names_in
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.pushing import begins as supposed
from rbpsym.oracles.simulation import Bench
from tests.oracles.compare import _bench
from tests.oracles.motion import Unfit, declared_start, follow, forces_at
from tests.oracles.sets import drawn

MOST_DRAWS, LATE = 40, 0.4
LIMIT = 1e-6
Seen = dict[str, tuple[float, ...]]


@dataclass
class Compared:
    """How many answers were compared, which were refused, and which differ (question, told, seen, numbers)."""

    sets: int = 0
    compared: int = 0
    refused: dict[str, str] = field(default_factory=dict)
    wrong: list[tuple] = field(default_factory=list)


def compared(asked: Asked, sets: int, seed: int = 2027) -> Compared:
    """The answers to generic questions at that many sets of parameters, and what the simulation shows there."""
    found, known = Compared(), {}
    for draws, numbers in enumerate(drawn(asked.first, seed)):
        if found.sets >= sets or draws >= MOST_DRAWS * sets:
            return found
        try:
            rows = list(_shown(asked, numbers))
        except (Unfit, NotApplicable, np.linalg.LinAlgError):
            continue
        found.sets += 1
        for question, when, places, seen in rows:
            _compare(asked, f"{question}{when}", places, seen, numbers, known, found)
    return found


def _compare(asked: Asked, question: str, places: Mapping[str, float], seen, numbers, known: dict, found: Compared) -> None:
    if question not in known:
        try:
            known[question] = answered(asked, question)
        except RbpsymError as error:
            known[question] = None
            found.refused[question] = error.what
    answer = known[question]
    told = None if answer is None else _told(answer, {**numbers, **places})
    if told is not None:
        found.compared += 1
        scale = max(*map(abs, seen), *map(abs, told), 1e-3)
        if not all(abs(a - b) <= LIMIT * scale for a, b in zip(told, seen, strict=True)):
            found.wrong.append((question, told, seen, {n: numbers[n] for n in names_in(answer.values[0]) if n in numbers}))


def _told(answer: Answer, numbers: Mapping[str, float]) -> tuple[float, ...] | None:
    """The values at these numbers; None where the answer does not claim to hold."""
    try:
        return tuple(value_at(answer.study, answer.values, answer.valid, numbers))
    except StatementError:
        return None


def _shown(asked: Asked, numbers) -> Iterator[tuple[str, str, Mapping[str, float], tuple[float, ...]]]:
    """(question, when, the place, what the simulation shows): at the start and the end of each phase, and on the way."""
    path: list[np.ndarray] = []
    for place, name in enumerate(asked.names):
        study = asked.study(place)
        bench = _bench(study, numbers)
        start = declared_start(bench)
        if start is None:
            return
        if not place and any(number(one.value, numbers) <= 0 for one in supposed(study) if one.op == ">"):
            raise Unfit("what is supposed of the start does not hold")
        begins = " at the start" if place == 0 else f" when {name} begins"
        first = np.concatenate([start.where, start.speed, np.zeros(len(bench.account) + len(bench.levers)), [0.0]])
        parameters = {n: v for n, v in numbers.items() if n not in bench.placement.names}
        yield from ((q, begins, {}, seen) for q, seen in _measured(bench, first, start.q).items())
        if place + 1 < len(asked.names):
            before = asked.stage(place + 1).began.before
            time = None if before.time is None else number(before.time, parameters)
            if time is None or time <= 0:
                return
            done = follow(bench, study, start, time)
            yield from _gone(asked, place, bench, path, done.states, _clock(asked, place, parameters))
            last, ends = done.event.state if done.event else done.states[-1], f" just before {asked.names[place + 1]}"
            yield from ((q, ends, {}, seen) for q, seen in _measured(bench, last, start.q).items())
            yield f"time until {asked.names[place + 1]}", "", {}, (float(last[-1]) + _clock(asked, place, parameters),)
            continue
        done = follow(bench, study, start, longest=8.0)
        yield from _gone(asked, place, bench, path, done.states, _clock(asked, place, parameters))
        if place == 0:
            yield from _on_the_way(bench, study, done, start.q)
        if done.event is not None and done.event.kind == "lost" and not done.event.also:
            seen = _measured(bench, done.event.state, start.q)
            yield from ((q, f" where {done.event.of} vanishes", {}, value) for q, value in seen.items() if q != done.event.of)


def _gone(
    asked: Asked, place: int, bench: Bench, path: list[np.ndarray], states, clock: float
) -> Iterator[tuple[str, str, Mapping[str, float], tuple[float, ...]]]:
    """Speeds after a body has fallen, moved along a line, or turned so far since the very start, or in its phase, at a state of
    that phase; what was passed before (`path`) grows by the phase."""
    size, problem = bench.equations.size, bench.derived.system.problem
    letter = asked.study(place).letters.free("d_1")
    chosen = states[: max(2, 2 * len(states) // 3)]
    own, before = [state[:size] for state in chosen], [*path]
    path.extend(state[:size] for state in states)
    speeds, time = chosen[-1][size : 2 * size], clock + float(chosen[-1][-1])
    named = f" in phase {asked.names[place]}"
    for passed, phase in ((np.array([*before, *own]), ""), (np.array(own), named))[: 1 + bool(place)]:
        for k, body in enumerate(problem.body_names):
            x, y, turn = (passed[:, 3 * k + j] - passed[0, 3 * k + j] for j in range(3))
            vx, vy, w = (float(one) for one in speeds[3 * k : 3 * k + 3])
            far, spins = np.hypot(x, y), problem.body(body).shape.kind != "particle"
            steps = float(np.hypot(np.diff(x), np.diff(y)).sum())
            is_straight = steps <= far[-1] * (1 + 1e-9) and np.ptp(x * y[-1] - y * x[-1]) < 1e-9
            for words, way in (("fallen", -y), ("moved", far if is_straight else 0 * far), ("turned through", np.abs(turn))):
                if way[-1] <= 1e-3 or way[-1] <= way[:-1].max(initial=0.0) + 1e-6:
                    continue
                there, value = f"{body} has {words} {letter}", {letter: float(way[-1])}
                yield f"speed of {body}.cm{phase}", f" where {there}", value, (float(np.hypot(vx, vy)),)
                if not phase:
                    yield "time", f" until {there}", value, (time,)
                if spins and words != "moved":
                    yield f"magnitude of angular velocity of {body}{phase}", f" where {there}", value, (abs(w),)


def _clock(asked: Asked, place: int, numbers: Mapping[str, float]) -> float:
    clock = asked.stage(place).clock if place else None
    return 0.0 if clock is None else number(clock, numbers)


def _on_the_way(bench: Bench, study, done, near) -> Iterator[tuple[str, str, Mapping[str, float], tuple[float, ...]]]:
    """Quantities as functions of the position, at a state before the motion turns round."""
    states = done.states[1 : max(2, int(len(done.states) * LATE))]
    if not states or len(study.system.independent) != 1 or study.system.has_clock:
        return
    state, [name] = states[-1], study.system.independent
    place = bench.placement.names.index(name)
    rates = [float(_rates(bench, each, near)[1][place]) for each in states]
    if any(a * b <= 0 for a, b in zip(rates, rates[1:], strict=False)) or not rates[0]:
        return
    q, speeds = _rates(bench, state, near)
    places = dict(zip(bench.placement.names, map(float, q), strict=True))
    places |= {f"{n}_dot": float(v) for n, v in zip(bench.placement.names, speeds, strict=True)}
    yield from ((question, "", places, seen) for question, seen in _measured(bench, state, near).items())
    totals: dict[str, float] = {}
    for k, (force, _, _) in enumerate(bench.account):
        totals[force] = totals.get(force, 0.0) + float(state[2 * bench.equations.size + k])
    whole = {item.force for item in study.works if None not in (item.translational.value, item.rotational.value)}
    yield from ((f"work of {force}", "", places, (work,)) for force, work in totals.items() if force in whole)


def _rates(bench: Bench, state: np.ndarray, near):
    size = bench.equations.size
    return bench.placement.state(state[:size].tolist(), state[size : 2 * size].tolist(), near)


def _measured(bench: Bench, state: np.ndarray, near) -> Seen:
    """What the simulation shows in a state, by the question that asks for it."""
    size, problem = bench.equations.size, bench.derived.system.problem
    where, speed = state[:size], state[size : 2 * size]
    forces = forces_at(bench, state)
    balance, masses = bench.equations.at(where, speed), bench.equations.masses
    found: Seen = {name: (float(forces[name]),) for name in bench.derived.system.unknowns}
    q, rates = _rates(bench, state, near)
    gained = bench.placement.accelerations(q, rates, where.tolist(), speed.tolist(), balance.gained)
    for name, rate, gain in zip(bench.placement.names, rates, gained, strict=True):
        if name in bench.derived.system.independent:
            found |= {f"speed of {name}": (float(rate),), f"acceleration of {name}": (float(gain),)}
    for k, body in enumerate(problem.body_names):
        (x, y, _), (vx, vy, w), (ax, ay, _) = (part[3 * k : 3 * k + 3] for part in (where, speed, balance.gained))
        found |= {f"velocity of {body}.cm": (vx, vy), f"acceleration of {body}.cm": (ax, ay)}
        if problem.body(body).shape.kind != "particle":
            spin = masses[3 * k + 2] * w
            found |= {f"angular velocity of {body}": (w,)}
            found |= {f"angular momentum of {body} about O": (masses[3 * k] * (x * vy - y * vx) + spin,)}
    heavy = [k for k in range(size) if k % 3 < 2 or problem.bodies[k // 3].shape.kind != "particle"]
    found["kinetic energy"] = (0.5 * float(sum(masses[k] * speed[k] ** 2 for k in heavy)),)
    return found
