"""The motion from the declared start in maximal coordinates, watched: contacts that must not pull, grips, slips, ranges.

It is followed until the first of them ends (an event), or the coordinate has turned twice, or for a long time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from rbpsym.errors import NotApplicable
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import Scalar
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.pushing import ways_kept
from rbpsym.mechanics.study import Study
from rbpsym.oracles.simulation import Bench
from rbpsym.oracles.simulation_contacts import slipping, spot_at
from rbpsym.oracles.simulation_placement import dotted
from rbpsym.statement.paths import runs

USED_UP = 1e-2  # of a straight run of a string: it ends there
LATE = 1e-6  # of the time of a phase: what ends then, ends it
LONGEST = 60  # of the usual times
BARE = 4  # the same where nothing can end
STEPS = 6  # within a usual time
CLOSE = 1e-7  # of the largest force: what counts as no force
SAME = 1e-6  # of the usual time
STUCK = 1e-7  # of the usual time: a step that small gets nowhere
NEAR = 1e-3  # of the largest force: a set at which a force comes so near to nothing without changing its sign is redrawn


class Unfit(Exception):
    """A set of numbers at which the system is not in the regime that is stated (with the reason)."""


@dataclass(frozen=True)
class Event:
    """What ended first: kind ("lost", "slips", "no slip", "range"), of what, and the state (X, V, works ..., t);
    `also` are forces that vanish at that very moment (both feet of what is symmetrical)."""

    kind: str
    of: str
    state: np.ndarray
    also: tuple[str, ...] = ()


@dataclass(frozen=True)
class Followed:
    """States along the motion up to its event (None: none came), and what was watched at the start."""

    states: list[np.ndarray]
    event: Event | None
    is_whole: bool
    least: Mapping[str, float]


Watch = Callable[[np.ndarray], float]


def watches(bench: Bench, study: Study) -> dict[tuple[str, str], Watch]:
    """What stays positive as long as the stated regime holds."""
    found: dict[tuple[str, str], Watch] = {}
    size, mechanism = bench.equations.size, bench.placement.mechanism

    def force(name: str) -> Watch:
        return lambda state: forces_at(bench, state)[name]

    for element in study.problem.constraints:
        for name in pushes(element):
            found["lost", name] = force(name)
        if element.values.get("limit") is not None:
            found["slips", element.name] = _grip(bench, element, mechanism.number(element["limit"]))
        if element.values.get("coefficient") is not None:
            found["no slip", element.name] = _slip(bench, element, size)
        if element.kind == "string":
            found |= _runs(bench, element)
    for element, value in ways_kept(study):
        if element.kind == "spring":
            found["string", element.name] = _reach(bench, value)
    return found


def _reach(bench: Bench, value: Scalar) -> Watch:
    """A spring on a straight line does not shrink to nothing: its ends would pass through each other."""

    def left(state: np.ndarray) -> float:
        q = bench.placement.coordinates(state[: bench.equations.size].tolist(), bench.generic.q)
        return number(value, {**bench.sample, **dict(zip(bench.placement.names, map(float, q), strict=True))})

    return left


def _runs(bench: Bench, element) -> dict[tuple[str, str], Watch]:
    """The straight runs of a string do not shrink to nothing (a block that comes to the pulley)."""
    mechanism, found = bench.placement.mechanism, {}
    for place, run in enumerate(runs(element["path"])):
        for first, second in zip(run, run[1:], strict=False):
            ends = [mechanism.spot(turn.center) for turn in (first, second)]
            offset = second.sense * mechanism.number(second.radius) - first.sense * mechanism.number(first.radius)
            _check_way(bench, ends, offset, element.name)
            found["string", f"{element.name} {place} {first.center.label}"] = _left_of(bench, ends, offset)
    return found


def _left_of(bench: Bench, ends: list, offset: float) -> Watch:
    """How much is left of a run, counted along the way in which it went just before: it may turn round."""
    ways: list[tuple[float, np.ndarray]] = []

    def left(state: np.ndarray) -> float:
        time, run = float(state[-1]), _straight(bench, ends, offset, state)
        before = [way for at, way in ways if at <= time] or [run]
        along = float(run @ before[-1]) / max(float(np.hypot(*before[-1])), 1e-30)
        if along > float(np.hypot(*run)) / 2 and not (ways and time <= ways[-1][0]):
            ways.append((time, run))
        return along - USED_UP * float(np.hypot(*before[0]))

    return left


def _straight(bench: Bench, ends: list, offset: float, state: np.ndarray) -> np.ndarray:
    """The straight run from where it leaves the first round thing to where it meets the second."""
    where = list(map(complex, state[: bench.equations.size]))
    (ax, ay), (bx, by) = (spot_at(spot, where) for spot in ends)
    dx, dy = (bx - ax).real, (by - ay).real
    square = dx * dx + dy * dy - offset * offset
    if square <= 0:
        return np.zeros(2)
    length, whole = square**0.5, dx * dx + dy * dy
    return np.array([(dx * length + dy * offset) / whole, (dy * length - dx * offset) / whole]) * length


def _check_way(bench: Bench, ends: list, offset: float, name: str) -> None:
    """A run goes the way that it has at the sample numbers: formulas of pulleys are those of one side."""
    usual = Bench(replace(bench.derived, works={}, momenta={}))
    mechanism = usual.placement.mechanism
    ways = [_straight(bench, ends, offset, bench.generic.where)]
    for element in bench.derived.system.problem.constraints:
        for run in runs(element["path"]) if element.kind == "string" and element.name == name else ():
            for first, second in zip(run, run[1:], strict=False):
                own = [mechanism.spot(turn.center) for turn in (first, second)]
                if [spot.body for spot in own] == [spot.body for spot in ends]:
                    offset = second.sense * mechanism.number(second.radius) - first.sense * mechanism.number(first.radius)
                    ways.append(_straight(usual, own, offset, usual.generic.where))
    if all(ways[0] @ way <= 0 for way in ways[1:]):
        raise Unfit(f"the string {name} runs another way")


def forces_at(bench: Bench, state: np.ndarray) -> dict[str, float]:
    """The unknown forces at a state of the motion."""
    size = bench.equations.size
    bench.placement.mechanism.clock = float(state[-1])
    return bench.multipliers(state[:size], state[size : 2 * size])


def _grip(bench: Bench, element, limit: float) -> Watch:
    normals = [name for name in (element.name, element.values.get("beside")) if name]

    def left(state: np.ndarray) -> float:
        forces = forces_at(bench, state)
        return limit * sum(forces[name] for name in normals) - abs(forces[element["friction"]])

    return left


def _slip(bench: Bench, element, size: int) -> Watch:
    mechanism = bench.placement.mechanism
    sense = mechanism.slips[element.name]
    row = slipping(element, mechanism, bench.generic.where.tolist())

    def rate(state: np.ndarray) -> float:
        where, speed = state[:size].tolist(), state[size : 2 * size].tolist()
        return sense * dotted(row.at(where, speed).entries, speed)

    return rate


def _ranges(bench: Bench, study: Study) -> Callable[[np.ndarray, list], dict[tuple[str, str], float]]:
    """How far each coordinate is from the ends of its range (`near` holds the last coordinates)."""
    ends = []
    for place, name in enumerate(bench.placement.names):
        coordinate = study.problem.coordinate(name)
        for bound, side in ((coordinate.lower, 1), (coordinate.upper, -1)):
            if bound is not None:
                ends.append((place, name, side, number(scalar(bound), bench.sample)))

    def room(state: np.ndarray, near: list) -> dict[tuple[str, str], float]:
        if not ends:
            return {}
        near[0] = bench.placement.coordinates(state[: bench.equations.size].tolist(), near[0])
        return {("range", f"{name} {side:+d}"): side * (float(near[0][k]) - end) for k, name, side, end in ends}

    return room


def follow(
    bench: Bench,
    study: Study,
    start,
    time: float | None = None,
    worked: Mapping = MappingProxyType({}),
    longest: float = LONGEST,
) -> Followed:
    """The motion from a start, up to a time if one is given; `worked` are the works done until then.

    Raises Unfit if the regime does not hold at the start, ends before that time, or nearly ends on the way.
    """
    from scipy.integrate import DOP853
    from scipy.optimize import brentq

    size, watched = bench.equations.size, watches(bench, study)
    account = bench.account
    done = [worked.get(key, 0.0) for key in account]
    first = np.concatenate([start.where, start.speed, done, np.zeros(len(bench.levers)), [0.0]])
    scale = _scale(bench, first)
    step = bench.usual_time(start)
    room, near = _ranges(bench, study), [start.q]
    open_ = _at_first(watched, first, scale, start)
    least = {f"{k} {of}": abs(watched[k, of](first)) / scale[k] for k, of in open_}
    if not _moves(bench, start):
        return Followed([first], None, True, least)
    until = (longest if watched else BARE) * step if time is None else time * (1 + 1e-3)
    solver = DOP853(bench.rate(account), 0.0, first, until, rtol=1e-11, atol=1e-13, max_step=step / STEPS)
    states = [first]
    turns, last_speed, begun = 0, start.rates, {}
    mover = [bench.placement.names.index(name) for name in study.system.independent]
    while solver.status == "running":
        try:
            with np.errstate(over="raise"):
                solver.step()
        except (OverflowError, FloatingPointError, NotApplicable):  # a singularity: what is well before it is kept
            return Followed([s for s in states if s[-1] <= solver.t / 2], None, False, least)
        if solver.status == "failed" or solver.step_size < STUCK * step:  # bars that come to lie in one line
            return Followed([s for s in states if s[-1] <= solver.t / 2], None, False, least)
        dense, state = solver.dense_output(), _put_back(bench, solver.y)
        solver.y = state
        if time is not None and solver.t > time * (1 - LATE) and not _ends_now(open_, watched, state):
            return Followed([*states, dense(time)], None, True, least)
        ended = [key for key in open_ if watched[key](state) < 0]
        ends = [key for key, left in room(state, near).items() if left < 0 and begun.get(key, 0) > 0]
        begun |= room(state, near)
        if ended or ends:
            found = []
            for key in ended:
                value = watched[key]
                time = brentq(lambda t, v=value, d=dense: v(d(t)), solver.t_old, solver.t, xtol=1e-13, rtol=1e-13)
                found.append((time, *key))
            for key in ends:
                time = brentq(lambda t, k=key, d=dense: room(d(t), [near[0]])[k], solver.t_old, solver.t, xtol=1e-13)
                found.append((time, *key))
            found.sort()
            moment, kind, of = found[0]
            close = [item for item in found[1:] if item[0] - moment < NEAR * step and kind != "range"]
            if any(item[0] - moment > SAME * step or item[1] != kind for item in close):
                raise Unfit("two things end at almost the same moment")
            if time is not None and moment < time * (1 - LATE):
                raise Unfit(f"{kind} {of} comes before the end of the phase")
            return Followed(states, Event(kind, of, dense(moment), tuple(item[2] for item in close)), True, least)
        for key in watched.keys() - open_:
            here = watched[key](state)
            if here < -CLOSE * scale[key[0]]:
                raise Unfit(f"{key[1]}: the stated regime ({key[0]}) ends at once")
            if here > CLOSE * scale[key[0]]:
                open_.add(key)
        for kind, of in open_:
            name = f"{kind} {of}"
            least[name] = min(least.get(name, np.inf), abs(watched[kind, of](state)) / scale[kind])
        states.append(state.copy())
        q, speed = bench.placement.state(state[:size].tolist(), state[size : 2 * size].tolist(), states_q(near))
        near[0] = q
        turns += sum(speed[k] * last_speed[k] < 0 for k in mover) if len(mover) == 1 else 0
        last_speed = speed
        if turns >= 2:
            break
    return Followed(states, None, turns >= 2, least)


def _put_back(bench: Bench, state: np.ndarray) -> np.ndarray:
    """The state with places and speeds as the conditions ask for: what rounding adds up in a long motion does no work."""
    size = bench.equations.size
    where, speed, *rest = np.split(state, [size, 2 * size])
    bench.placement.mechanism.clock = float(state[-1])
    rows = [item.at(where.tolist(), speed.tolist()) for item in bench.equations.kept]
    slopes = np.zeros((len(rows), size))
    for slope, row in zip(slopes, rows, strict=True):
        for column, entry in row.entries:
            slope[column] += entry
    gaps = [[row.value, slope @ speed + row.drift] for slope, row in zip(slopes, rows, strict=True)]
    back = np.linalg.lstsq(slopes, np.array(gaps).reshape(-1, 2), rcond=None)[0]
    return np.concatenate([where - back[:, 0], speed - back[:, 1], *rest])


def _moves(bench: Bench, start) -> bool:
    """Not where it is at rest and nothing drives it."""
    if any(item.kind.startswith("prescribed") or item.kind == "pivot" for item in bench.derived.system.problem.constraints):
        return True
    gained = bench.equations.at(start.where, start.speed).gained
    return max(np.abs(gained).max(initial=0.0), np.abs(start.speed).max(initial=0.0)) > 1e-10


def _ends_now(open_: set, watched: Mapping, state: np.ndarray) -> bool:
    return any(watched[key](state) < 0 for key in open_)


def states_q(near: list) -> np.ndarray:
    """The coordinates found last."""
    return near[0]


def _scale(bench: Bench, state: np.ndarray) -> dict[str, float]:
    """Sizes to compare forces and speeds with."""
    forces = [abs(value) for value in forces_at(bench, state).values()]
    weights = max((abs(m) for m in bench.equations.masses), default=1.0) * abs(bench.sample.get("g", 1.0))
    force = max([*forces, weights])
    speed = max([float(np.abs(state[bench.equations.size : 2 * bench.equations.size]).max(initial=0.0)), 1e-3])
    return {"lost": force, "slips": force, "no slip": speed, "string": bench.placement.mechanism.reach()}


def _at_first(watched: Mapping, state: np.ndarray, scale: Mapping[str, float], start) -> set:
    """What holds at the start. Raises Unfit if something has the wrong sign there; what is nothing is looked at later."""
    found = set()
    for key, value in watched.items():
        here = value(state)
        if here < -CLOSE * scale[key[0]]:
            raise Unfit(f"{key[1]}: the stated regime ({key[0]}) does not hold at the start")
        if here > CLOSE * scale[key[0]]:
            found.add(key)
    return found


def declared_start(bench: Bench):
    """The declared start; None if it is not declared in full. Raises Unfit where the bodies can't be placed."""
    bench.placement.mechanism.clock = 0.0
    try:
        return bench.declared_start()
    except NotApplicable as error:
        raise Unfit(error.what) from None
