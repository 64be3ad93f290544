"""Moments of a motion that is known as a function of the time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

from rbpsym.ask.asked import Asked, Moment
from rbpsym.ask.lasting import clear
from rbpsym.ask.question import When
from rbpsym.chapters import course, oscillations
from rbpsym.decide.dimensions import require_dimension
from rbpsym.decide.signs import sign
from rbpsym.errors import NotApplicable, StatementError, there
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, Scalar, derivative, is_zero, names_in, short, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics import solutions, solved
from rbpsym.mechanics.arrivals import ArrivalState, of_coordinate
from rbpsym.mechanics.coupled import courses_of
from rbpsym.mechanics.demands import Demand, possible
from rbpsym.mechanics.endings import uniform_motion
from rbpsym.mechanics.forms import AccelerationForm
from rbpsym.mechanics.orbit import quarters_to, swing_of
from rbpsym.mechanics.solutions import InTime
from rbpsym.mechanics.solved import time_to, without_logarithms
from rbpsym.mechanics.study import Study
from rbpsym.proof.draft import Draft
from rbpsym.quantities import TIME
from rbpsym.quantity.problem import ProblemWorld


def by_time(asked: Asked, when: When, place: int | None, manner: str = "") -> Moment | None:
    """The moment by the motion as a function of the time, where that is known."""
    world = asked.world(asked.meant(place))
    name = when.words[0] if when.words else next(iter(world.study.system.independent), "")
    with suppress(NotApplicable):
        if name == "t":
            return at_time(asked, asked.meant(place), instant(world, when.words[1]), manner)
        if name.removesuffix("_dot") not in {*world.coordinates, *world.study.system.unknowns}:
            return None
        value = NOTHING if when.kind in ("rests", "vanishes") else scalar(read_infix(when.words[1], world.names))
        found = reached(asked, asked.meant(place), f"{name}_dot" if when.kind == "rests" else name, value, manner)
        return replace(found, state=clear(world.study, found.state))
    return None


def instant(world: ProblemWorld, text: str) -> Scalar:
    """A time that is written. Raises DimensionError."""
    node = read_infix(text, world.names)
    require_dimension(node, world.dimensions, TIME, "the time")
    return scalar(node)


def at_time(asked: Asked, place: int, time: Scalar, manner: str = "", *, is_solved: bool = False) -> Moment:
    """The state at a time after the start of a phase. Raises NotApplicable where that has no closed form."""
    study = asked.study(place)
    if not manner and not is_solved:
        with suppress(NotApplicable):
            moved = uniform_motion(study, time)
            with suppress(NotApplicable):
                moved = replace(moved, valid=_valid(courses_of(study), time))
            return Moment(place, replace(moved, valid=(*moved.valid, *_within(study, moved.places))), "time")
    found = courses_of(study, manner)
    at = {"t": time}
    places = {name: without_logarithms(substitute(one.whole, at)) for name, one in found.items()}
    speeds = {name: without_logarithms(substitute(one.speed, at)) for name, one in found.items()}
    is_small = solutions.SMALL in manner  # near a place of rest, which lies in the range
    state = ArrivalState(time, places, speeds, (*_valid(found, time), *(() if is_small else _within(study, places))))
    return Moment(place, state, "time", courses=found, is_small=is_small)


def _within(study: Study, places: Mapping[str, Scalar]) -> Iterator[Demand]:
    """The places lie in the ranges that are declared of the coordinates."""
    for name, place in places.items():
        for end, side in zip(study.assumptions.range_of(name), (1, -1), strict=True):
            if end is not None:
                yield Demand(short((place - end) * side), ">=")


def _valid(found: Mapping[str, InTime], time: Scalar) -> tuple[Demand, ...]:
    """What the solutions ask at a time."""
    demands = dict.fromkeys(demand for one in found.values() for demand in one.valid)
    return tuple(Demand(short(substitute(demand.value, {"t": time})), demand.op) for demand in demands)


def reached(asked: Asked, place: int, subject: str, value: Scalar, manner: str = "") -> Moment:
    """The first moment at which a coordinate, a speed x_dot or an unknown force has a value. Raises NotApplicable where no
    formula gives it."""
    study = asked.study(place)
    name = subject.removesuffix("_dot")
    try:
        found = courses_of(study, manner)
    except NotApplicable:
        if (moment := _by_speed(study, place, name, value)) is None or manner or name == subject:
            raise
        return moment
    time, asked_for = first_time(study, subject, value, found)
    made = at_time(asked, place, substitute(time, _letters(found)), manner, is_solved=True)
    at = {*found, *(f"{n}_dot" for n in found)}
    is_given = name not in (subject, *study.system.unknowns) and not names_in(value) & at
    there = {**made.state.speeds, **({name: value} if is_given else {})}  # by its own meaning, not by a long formula
    return replace(made, state=replace(made.state, speeds=there, valid=asked_for), watched=(subject, value, time))


def _by_speed(study: Study, place: int, name: str, value: Scalar) -> Moment | None:
    """The moment at which the one coordinate that moves has a speed, by the acceleration as a function of that alone; None where
    it is none. Raises StatementError where the speed is never come to."""
    known, letter = solutions.given(study, name), study.letters.free("u")
    found = solved.by_speed(known, letter) if known and study.system.independent == (name,) else None
    if known is None or found is None or found[2] is None or is_zero(value):
        return None
    gained, place_ = (short(substitute(one, {letter: value})) for one in (found[0], found[2]))
    time = None if found[1] is None else short(substitute(found[1], {letter: value}))
    begun = substitute(Scalar(found[0].num), {letter: known.speed})
    asked_for = Demand(short((value - known.speed) * gained)), Demand(short(begun / gained)), Demand(value * known.speed, ">=")
    never = StatementError(f"“{name}_dot” does not come to this value in this motion")
    valid = possible(asked_for, study.assumptions, never)
    state = ArrivalState(time, {name: place_}, {name: value}, valid)
    return Moment(place, state, "time", watched=(f"{name}_dot", value, time))


def _letters(found: Mapping[str, InTime]) -> dict[str, Scalar]:
    return {letter: value for one in found.values() for letter, value in one.letters.items()}


def first_time(study: Study, subject: str, value: Scalar, found: Mapping[str, InTime]) -> tuple[Scalar, tuple[Demand, ...]]:
    """When, in the letters of the courses, a coordinate, a speed or an unknown force first has a value, and where it does.
    Raises NotApplicable where no formula gives it, StatementError where it never does."""
    name = subject.removesuffix("_dot")
    is_force = subject in study.system.unknowns
    moving = study.on_motion(symbol(subject)) if is_force else of_coordinate(study, name)[subject != name]
    at = {n: one.place for n, one in found.items()} | {f"{n}_dot": derivative(one.place, "t") for n, one in found.items()}
    letters = _letters(found)
    gap = short(substitute(moving - substitute(value, study.system.dependent), at))
    known = solutions.Given(AccelerationForm(NOTHING), NOTHING, NOTHING, study, "")  # signs are all that is asked of it
    # the end of a declared range may be where the motion is to come
    if sign(substitute(gap, letters), study.assumptions.without(*study.system.coordinates)).is_nonzero:
        raise StatementError(f"“{subject}” never has this value in this motion, though it may come ever closer to it")
    first = None if names_in(gap) & (study.system.scope.rates.keys() - {"t"}) else time_to(gap, known, letters)
    if first is None:
        raise NotApplicable(f"no closed form was found for the time at which “{subject}” has this value")
    time, valid = first
    never = StatementError(f"“{subject}” does not come to this value in this motion")
    return time, possible((*_valid(found, substitute(time, letters)), *valid), study.assumptions, never)


def time_of_swing(asked: Asked, moment: Moment) -> tuple[Scalar, str] | None:
    """The time of a quarter or a half of a swing of any size in the first phase, and what tells it; None where it is none."""
    study, names = asked.first, asked.first.system.independent
    if len(names) != 1 or moment.place or moment.state.time is not None:
        return None
    [name] = names
    with suppress(StatementError):
        quarters = quarters_to(study, name, moment.state.places[name])
        return None if quarters is None else (swing_of(study, name).time(study, quarters), f"swing {name} {quarters}")
    return None


def write(draft: Draft, moment: Moment) -> tuple[str, ...]:
    """The ids of the steps that say the motion as a function of the time, after those on which they rest."""
    laws = oscillations.laws(draft) if moment.is_small else {}
    draft.chapter = "course"
    told = tuple(course.told(draft, name, one, laws.get(name) or "", moment.courses) for name, one in moment.courses.items())
    if moment.watched is None:
        return told
    if not moment.courses:
        return (course.by_speed(draft, *moment.watched[:2], moment.state),)
    return (*told, course.reached(draft, *moment.watched[:2], there(moment.watched[2]), moment.state, _letters(moment.courses)))
