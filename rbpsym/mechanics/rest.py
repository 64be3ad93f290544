"""Where a system can rest: the forces balance there, and one-sided forces, friction, ranges and existence allow it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat, rooted
from rbpsym.decide.signs import sign
from rbpsym.errors import there
from rbpsym.field import NOTHING, PI, Scalar, depends_on, derivative, is_zero, short, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.demands import Demand, existence, settle, turned
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.elimination import Matrix, determinant
from rbpsym.mechanics.events import pushes, taken
from rbpsym.mechanics.friction import spare, stops
from rbpsym.mechanics.roots import At, common_zeros, factors_in
from rbpsym.mechanics.system import System

MOST_TURNS = 8
LONGEST = 400  # terms: signs of what is longer are not looked for


class Rest(Frozen):
    """Places, each with what is asked of the parameters there; whether these are all (None: not decided, with the
    reason); the factors of the forces that may vanish elsewhere too."""

    places: tuple[tuple[At, tuple[Demand, ...]], ...] = ()
    complete: bool | None = True
    reason: str = ""
    open_: tuple[Scalar, ...] = ()


def resting_forces(system: System, dynamics: Dynamics) -> tuple[Scalar, ...]:
    """Generalized forces with all speeds zero; none where one has no value at rest (that of a given power)."""
    still = dict.fromkeys(system.speeds, NOTHING)
    with suppress(ZeroDivisionError):
        return tuple(short(substitute(value, still)) for value in dynamics.forcing)
    return ()


def unfit(system: System, dynamics: Dynamics) -> str:
    """Why positions of rest are not looked for."""
    if system.implicit:
        return "coordinates stay tied to each other by an equation"
    if not all(dynamics.ideal.values()) or stops(system):
        return "kinetic friction acts, whose sense depends on the motion"
    if system.independent and not resting_forces(system, dynamics):
        return "a force has no value at rest"
    if any(depends_on(force, "t") for force in resting_forces(system, dynamics)):
        return "the forces depend on the time"
    return "there are more than four free coordinates" if len(system.independent) > 4 else ""


def rest(system: System, dynamics: Dynamics, given: Assumptions) -> Rest:
    """All positions of rest, as far as closed forms go."""
    if system.problem.unstated:
        return Rest(complete=None, reason="masses are not stated")
    reason = unfit(system, dynamics)
    forces = resting_forces(system, dynamics)
    if system.implicit and all(map(is_zero, forces)):
        return Rest((), *_everywhere(forces, given))
    if reason:
        tied = all(dynamics.ideal.values()) and system.implicit and not system.has_clock
        values = [*forces, *(condition.value for condition in system.implicit)]
        stated = [at for at in _stated(system, system.coordinates) if _balances(values, at, given)] if tied else []
        with suppress(ZeroDivisionError):  # a force has no value there: the list is open anyhow
            kept = [(at, valid) for at in stated if (valid := _demands(system, dynamics, at, given)) is not None]
            return Rest(tuple(place for place in kept if not _doubt(system, dynamics, place[0], given)), None, reason)
        return Rest((), None, reason)
    names = tuple(n for n in system.independent if any(depends_on(force, n) for force in forces))
    if not names:
        return Rest((), *_everywhere(forces, given))
    found = common_zeros(forces, names, spread=lambda *root: turns_within(given, *root), given=given)
    candidates = [*found.found, *(at for at in _stated(system, names) if _balances(forces, at, given))]
    places: list[tuple[At, tuple[Demand, ...]]] = []
    doubts: list[str] = []
    for at in candidates:
        try:
            valid = _demands(system, dynamics, at, given)
            if valid is None or any(_is_one_place(at, old, given) for old, _ in places):
                continue
            doubt = _doubt(system, dynamics, at, given)
        except ZeroDivisionError:
            doubt = "where the forces balance, something else has no value"
        places += [] if doubt or valid is None else [(at, valid)]
        doubts += [doubt] if doubt else []
    parts = (part for value in found.open_ for part in factors_in(value, *names))
    open_ = tuple(part for part in parts if _may_vanish(part, names, [at for at, _ in places], given))
    doubts += ["an equation was not solved in closed form"] if open_ else []
    return Rest(tuple(places), None if doubts else True, "; ".join(dict.fromkeys(doubts)), open_)


def _everywhere(forces: Sequence[Scalar], given: Assumptions) -> tuple[bool | None, str]:
    """Whether a list without places is whole, and why, where the forces are the same everywhere."""
    if not forces:
        return True, "nothing is free to move"
    if all(map(is_zero, forces)):
        return False, "every place is one of rest"
    if any(sign(force, given).is_nonzero for force in forces):
        return True, "the forces are the same everywhere"
    return None, "the forces are the same everywhere: where they vanish, every place is one of rest"


def _stated(system: System, names: Sequence[str]) -> Iterator[At]:
    """Where authors let things rest: at the origin of the coordinates, and at the stated start."""
    yield dict.fromkeys(names, NOTHING)
    start = {n: system.scope.start[n] for n in names if n in system.scope.start}
    if len(start) == len(names):
        yield start


def _balances(forces: Iterable[Scalar], at: At, given: Assumptions) -> bool:
    try:
        return all(is_zero(rooted(substitute(force, at), given)) for force in forces)
    except ZeroDivisionError:
        return False


def _doubt(system: System, dynamics: Dynamics, at: At, given: Assumptions) -> str:
    """Why the linear equations close to a place would not tell the motion there; "" if they do."""
    still = dict.fromkeys(system.speeds, NOTHING)

    def here(value: Scalar) -> Scalar:
        return rooted(substitute(substitute(value, still), at), given)

    for phase in system.problem.phases[:1]:
        reached = system.dependent.get(phase.subject, symbol(phase.subject)) if phase.event == "reaches" else None
        if reached is not None and is_zero(here(reached - scalar(there(phase.value)))):
            return "where the forces balance, the first phase ends"
    if any(is_zero(here(demand.value)) for force in dynamics.forcing for demand in existence(force)):
        return "where the forces balance, they have no slope"
    slope = here(derivative(dynamics.forcing[0], system.independent[0]))
    if len(system.independent) == 1 and sign(slope, given).kind == "positive":
        return ""  # it is driven away to both sides, and to one of them the contact pushes
    sided = [dynamics.reactions[name] for element in system.problem.constraints for name in pushes(element)]
    names = (*system.coordinates, *system.speeds)
    if any(is_zero(here(value)) and any(not is_zero(here(derivative(value, n))) for n in names) for value in sided):
        return "where the forces balance, a contact or a string is about to let go"
    return ""


def _is_one_place(first: At, second: At, given: Assumptions) -> bool:
    """Whether the first is the second, or one of a family of places."""
    gaps = (first[n] - substitute(second[n], first) for n in second if n in first)
    return second.keys() <= first.keys() and all(is_zero(rooted(gap, given)) for gap in gaps)


def _may_vanish(factor: Scalar, names: Sequence[str], known: list[At], given: Assumptions) -> bool:
    """Whether a factor may vanish in the range, elsewhere than in one known place that is the only one if it is monotone."""
    if len(factor.num) > LONGEST:
        return True
    if len(names) == 1 and sum(_balances([factor], at, given) for at in known) == 1:
        factor = short(derivative(factor, names[0]))
    return not sign(factor, given).is_nonzero


def turns_within(given: Assumptions, name: str, root: Scalar, period: Scalar | None) -> list[Scalar]:
    """The zeros that a periodic one stands for within the range (without a range: in (-π, π])."""
    if period is None:
        return [root]
    lower, upper = given.range_of(name)
    half = period / 2 if sign(period - PI * 2, given).kind == "positive" else PI
    if lower is None and upper is None:
        lower, upper, last = -half, half, ">="
    else:
        lower = there(upper) - half * 2 if lower is None else lower
        upper = lower + half * 2 if upper is None else upper
        last = _last(lower, upper)
    turns = turned(root, period, (lower, upper), given, MOST_TURNS)
    return [x for x in turns if settle((Demand(x - lower), Demand(upper - x, last)), given) is not None]


# --- what a place asks for


def _demands(system: System, dynamics: Dynamics, at: At, given: Assumptions) -> tuple[Demand, ...] | None:
    """What is asked of the parameters for the place to be one of rest; None if it is none.

    Raises ZeroDivisionError where a force has no value, though the place lies in the ranges.
    """
    asked = [*_of_place(at, given, system.scope.start), *_of_tied(system, at, given)]
    if settle(asked, given) is None or is_zero(determinant(_there(dynamics.mass_matrix, at))):
        return None  # outside, or not described with its neighbourhood by the coordinates, as r = 0 by polar ones
    return settle([*asked, *_of_forces(system, dynamics, at, given)], given)


def _there(matrix: Matrix, at: At) -> Matrix:
    return tuple(tuple(substitute(entry, at) for entry in row) for row in matrix)


def _of_place(at: Mapping[str, Scalar], given: Assumptions, start: Mapping[str, Scalar]) -> Iterator[Demand]:
    """It exists and lies within the ranges; a range has the stated start, be it one of its ends."""
    for name, value in at.items():
        yield from existence(value)
        if name in start and is_zero(value - start[name]):
            continue
        lower, upper = given.range_of(name)
        yield from () if lower is None else [Demand(value - lower)]
        yield from () if upper is None else [Demand(upper - value, _last(lower, upper))]


def _of_tied(system: System, at: Mapping[str, Scalar], given: Assumptions) -> Iterator[Demand]:
    """What is tied to the place lies within its ranges too."""
    for name in system.dependent.keys() & given.ranges.keys():
        value = neat(substitute(system.dependent[name], at), given)
        if not any(depends_on(value, other) for other in system.coordinates):
            begin = substitute(system.dependent[name], system.scope.start)
            yield from _of_place({name: value}, given, {name: begin})


def _last(lower: Scalar | None, upper: Scalar) -> str:
    """Ends do not belong to a range; only that of a whole turn has both ends in one place, which is none of its limits."""
    return ">=" if lower is not None and is_zero(upper - lower - PI * 2) else ">"


def _of_forces(system: System, dynamics: Dynamics, at: At, given: Assumptions) -> Iterator[Demand]:
    """Distances are positive, contacts push, strings pull, friction stays within its limit."""
    still = dict.fromkeys((*system.speeds, *system.accelerations), NOTHING)

    def here(name: str) -> Scalar:
        return neat(substitute(substitute(dynamics.reactions[name], still), at), given)

    for _, value in taken(system):
        there = neat(substitute(value, at), given)
        yield from () if any(depends_on(there, name) for name in system.coordinates) else [Demand(there)]
    for element in system.problem.constraints:
        for name in pushes(element):
            yield Demand(here(name), ">=")
        yield from (Demand(left, ">=") for left in spare(element, here))


OPPOSITE = {"positive": "negative", "negative": "positive"}


class AtRest(Frozen):
    """The one coordinate, the generalized `force` along it at rest and its derivative (the `slope`).

    `stable`: whether the slope is negative (positive: False) throughout the range, None if its sign
    is not known; `ends`: the force at the two ends of the range where its signs differ, else empty.
    `place` is the name of the coordinate's value there; `frequency_squared` of the small
    oscillation about it, in that name, if it is stable and nothing damps it; `decay`, where something does, the squares of the
    frequency without it and what the acceleration loses per speed.
    """

    name: str
    force: Scalar
    slope: Scalar
    stable: bool | None
    ends: tuple[Scalar, ...]
    place: str
    frequency_squared: Scalar | None
    decay: tuple[Scalar, Scalar] | None = None


def balance(system: System, dynamics: Dynamics, assumptions: Assumptions) -> AtRest | None:
    """The position of rest of a system with one coordinate whose equation has no solution in closed form."""
    if len(system.independent) != 1:
        return None
    [name], [force] = system.independent, resting_forces(system, dynamics)
    slope = short(derivative(force, name))
    stable = {"negative": True, "positive": False}.get(sign(slope, assumptions).kind or "")
    place = _free(f"{name}_e", system)
    there = {name: symbol(place)}
    mass, drag = substitute(dynamics.mass_matrix[0][0], there), _drag(system, dynamics, there)
    square = short(-(substitute(slope, there) / mass)) if stable else None
    ends = _ends(system, force, name, assumptions)
    if square is None or not drag:
        return AtRest(name, force, slope, stable, ends, place, square)
    decay = (square, short(-(drag / mass))) if sign(drag, assumptions).kind == "negative" else None
    return AtRest(name, force, slope, stable, ends, place, None, decay)


def _drag(system: System, dynamics: Dynamics, there: dict[str, Scalar]) -> Scalar:
    """What the force along the coordinate has per speed, close to the place."""
    [force], [speed] = dynamics.forcing, system.speeds
    return short(substitute(substitute(derivative(force, speed), {speed: NOTHING}), there))


def _free(name: str, system: System) -> str:
    taken = {q.name for q in system.problem.parameters} | {c.name for c in system.problem.coordinates}
    return f"{name}q" if name in taken else name


def _ends(system: System, force: Scalar, name: str, assumptions: Assumptions) -> tuple[Scalar, ...]:
    bounds = assumptions.range_of(name)
    if None in bounds:
        return ()
    try:
        found = tuple(short(substitute(force, {name: bound})) for bound in map(there, bounds))
    except ZeroDivisionError:
        return ()
    lower, upper = (sign(value, assumptions).kind for value in found)
    return found if lower in OPPOSITE and upper == OPPOSITE[lower] else ()
