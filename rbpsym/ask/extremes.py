"""The greatest or least value of a function of one quantity on its range, from the signs of its slope."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress

from rbpsym.ask.limits import leading
from rbpsym.ask.zeros import Crossing, SignTable, settled_sign, sign_table, where_met
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.rooted import neat, over_growth
from rbpsym.decide.signs import sign
from rbpsym.errors import NotApplicable, RbpsymError, Undecided, all_there
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, names_in, short, substitute, symbol
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.coupled import courses_of
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.endings import uniform_motion
from rbpsym.mechanics.events import Way
from rbpsym.mechanics.led import sense_to
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.solutions import InTime
from rbpsym.mechanics.study import Study
from rbpsym.quantity.problem import ProblemWorld

ENDS = ("at the lower end", "at the upper end")


class Extreme(Frozen):
    """A greatest (least) value, where `asked` is met; of the whole range, or of a neighbourhood.

    place: where, None at infinity. value: None if the function has no bound there. where: "" for a place inside the range,
    else the end that is approached. beside: the sign there of what vanishes at an end. table: the signs of the
    slope (None: it is constant). crossing: instead of a place in closed form.
    """

    place: Scalar | None
    value: Scalar | None
    where: str = ""
    asked: tuple[Demand, ...] = ()
    table: SignTable | None = None
    beside: int = 0
    crossing: Crossing | None = None


def extreme(value: Scalar, name: str, given: Assumptions, sense: int, way: Way | None = None) -> Extreme | None:
    """The greatest value (`sense` 1) or the least one (-1) on the range; None if it is not decided. Of several places that
    have it, that to which a way comes first.

    Ends of the range are looked at as limits; whether they belong to it is for the caller to say.
    """
    found = extremes(value, name, given, sense)
    if found is None:
        return None
    given = where_met(given, found[0].asked) if found else given
    without = next((item for item in found if item.value is None), None)
    best = [item for item in found if all(_is_beyond(item, other, given, sense) for other in found)]
    far = [(way.ahead(item.place), item) for item in best if way and item.place is not None]
    ahead = [(distance, item) for distance, item in far if settled_sign(distance, given) in (0, 1)]
    first = (item for distance, item in ahead if all(settled_sign(other - distance, given) in (0, 1) for other, _ in ahead))
    return without or next(first, best[0] if best else None)


def _is_beyond(item: Extreme, other: Extreme, given: Assumptions, sense: int) -> bool:
    if item is other or item.value is None or other.value is None:
        return item is other
    return settled_sign((item.value - other.value) * sense, given) in (0, 1)


def extremes(value: Scalar, name: str, given: Assumptions, sense: int) -> list[Extreme] | None:
    """Where the slope goes from the sense to its opposite, and the ends towards which the function goes on."""
    slope = derivative(value, name)
    if is_zero(slope):
        return [Extreme(None, value, "everywhere")]
    table = sign_table(slope, name, given)
    if not table.is_whole:
        return None
    limits, given = of_symbol(name, given), where_met(given, table.zeros.asked)
    found = [
        _near(value, name, (zero.place, 0), "", given, table)
        for zero, before, after in zip(table.zeros.found, table.signs, table.signs[1:], strict=False)
        if before == sense and after == -sense
    ]
    if table.zeros.crossings and table.signs[0] == sense:
        found.append(Extreme(None, None, "", table.zeros.asked, table, 0, table.zeros.crossings[0]))
    for end, is_open, side, where in (
        (limits.lower, table.signs[0] == -sense, 1, ENDS[0]),
        (limits.upper, table.signs[-1] == sense, -1, ENDS[1]),
    ):
        if is_open:
            found.append(_near(value, name, (end, side if end is not None else -side), where, given, table))
    return all_there(found)


def least(value: Scalar, along: str, given: Assumptions, fits: Callable[[Extreme], bool]) -> tuple[Scalar, list[Extreme]] | None:
    """A value, or another one of the same sign, and where it is least on a way; None where none of them `fits`."""
    other = over_growth(value, along)  # in which the slope of an exponential is none: with it the value is told as it is
    for each in (value, *([] if other is None else [other]), *_by_linear(value, along, given)):
        found = extremes(each, along, given, -1)
        if found is not None and all(low.crossing is None and fits(low) for low in found):
            own = (low.place is not None and low.value and short(substitute(value, {along: low.place})) for low in found)
            lows = [replace(low, value=one) if one else low for low, one in zip(found, own, strict=True)]
            return (value, lows) if each is other else (each, found)
    return None


def _by_linear(value: Scalar, along: str, given: Assumptions) -> Iterator[Scalar]:
    """p + b/a for a p + b with a positive a: it has the sign of the value, and is least in a place that p does not move."""
    for name in sorted(names_in(value) - {along}):
        slope = derivative(value, name)
        if not depends_on(slope, name) and sign(slope, given).kind == "positive":
            yield value / slope


def _near(
    value: Scalar, name: str, at: tuple[Scalar | None, int], where: str, given: Assumptions, table: SignTable
) -> Extreme | None:
    place, side = at
    if place is not None:
        with suppress(ZeroDivisionError):
            there = neat(substitute(value, {name: place}), given)
            if not where or not is_zero(there):
                return Extreme(place, there, where, table.zeros.asked, table)
    near = leading(value, name, place, given, side or 1)
    if near is None:
        return None
    size = near.limit if near.limit is None else neat(near.limit, given)
    return Extreme(place, size, where, table.zeros.asked, table, settled_sign(near.coefficient, given) or 0)


def by_speed(study: Study, demand: Demand) -> list[Demand] | None:
    """What is asked for a function of the one speed not to become negative, where the acceleration is one too: between the first
    speed and that at which it vanishes. None for another value; raises Undecided."""
    [name, *more], given = study.system.independent or ("",), study.assumptions
    speed, gain = f"{name}_dot", (study.dynamics.accelerations or {}).get(f"{name}_ddot", NOTHING)
    moving, begun = {*study.system.coordinates, *study.system.speeds, "t"}, study.system.scope.start.get(speed, NOTHING)
    if more or not gain or names_in(gain) & moving != {speed} or names_in(demand.value) & moving != {speed}:
        return None
    way = sign(substitute(gain, {speed: begun}), given).sense
    ends = [place for place in zeros(gain, speed, given) if sign((place - begun) * way, given).kind == "positive"]
    if not way or len(ends) > 1:
        return None
    end = ends[0] if ends else None
    return _lows(demand.value, given.with_range(speed, *((begun, end) if way > 0 else (end, begun))), speed)


def _lows(value: Scalar, given: Assumptions, along: str, asked: Iterable[Demand] = ()) -> list[Demand]:
    """What is asked for the least values of a function not to be negative. Raises Undecided."""
    from rbpsym.ask.wanted import Wanted
    from rbpsym.ask.yesno import least_values

    try:
        return [*least_values(Wanted((value,), given, along, asked=tuple(asked)))]
    except RbpsymError as error:
        raise Undecided(error.what) from None


def least_until(
    study: Study, demand: Demand, time: Scalar | None, courses: Mapping[str, InTime], asked: Iterable[Demand] = ()
) -> list[Demand]:
    """What is asked for a value not to become negative up to a time (None: ever) that comes under conditions, as the courses
    tell it. Raises Undecided."""
    from rbpsym.ask.seen import one_period

    if time is None or not courses:
        with suppress(NotApplicable):
            courses = courses_of(study)
    at = {name: one.whole for name, one in courses.items()} | {f"{name}_dot": one.speed for name, one in courses.items()}
    told, given = short(substitute(demand.value, at)), assuming(study.assumptions, asked)
    if names_in(told) & {*study.system.coordinates, *study.system.speeds} or not depends_on(told, "t"):
        raise Undecided("their forces are not known on the way")
    if time == symbol("t"):
        return [Demand(told, demand.op)]
    given = one_period(told, given) if time is None else given.with_range("t", NOTHING, time)
    return [] if sign(told, given).is_nonnegative else _lows(told, given, "t")


def until(study: Study, value: Scalar, time: Scalar | None) -> Demand | None:
    """That a string has not run out at a time of a uniform motion: what goes one way, or is bent downwards, and is not negative
    at the start and then is not so between; None where that does not tell it."""
    with suppress(NotApplicable):
        course = substitute(value, uniform_motion(study, symbol("t")).places)
        rate = derivative(course, "t")
        bend = derivative(rate, "t")
        is_one_way = is_zero(substitute(rate, {"t": NOTHING})) and not depends_on(bend, "t")  # from rest, at a steady gain
        if time is not None and (is_one_way or sign(-bend, study.assumptions).is_nonnegative):
            return Demand(short(substitute(course, {"t": time})), ">=")
    return None


def driven(study: Study, name: str, places: Mapping[str, Scalar] | None) -> tuple[Way, Assumptions] | None:
    """The way of a coordinate that the time alone ties, to a place; None where that is not known."""
    begin = study.system.scope.start.get(name)
    if begin is None or not places or name not in places:
        return None
    way = Way(name, begin, sense_to(study, name, (begin, places[name])), NOTHING)
    return (way, way.until(places[name], study.assumptions)) if way.sense else None


def least_of(study: Study, demand: Demand, name: str, *, places: Mapping[str, Scalar] | None) -> list[Demand]:
    """The least values of a function of a coordinate on its way to some places (None: on the whole motion). Raises Undecided."""
    from rbpsym.ask.seen import to_and_fro

    world, given = ProblemWorld(study), study.assumptions
    try:
        led = None if name in study.squares else driven(study, name, places)
        ways = [led] if led else _ways(world, name, places[name]) if places else to_and_fro(world, name, given)
        found = [Demand(way.ahead(places[name])) for way, _ in ways[-1:] if places and places[name] != way.start]
        for way, within in ways:
            found += _lows(demand.value, within, name, way.asked)
    except RbpsymError as error:
        raise Undecided(error.what) from None
    return found


def _ways(world: ProblemWorld, name: str, place: Scalar) -> list[tuple[Way, Assumptions]]:
    """The way of a coordinate to a place; to one at or behind its start the way there and back, from where it turns round."""
    from rbpsym.ask.seen import NeverThere, to_and_fro, way_to

    begin, given = world.study.system.scope.start.get(name, NOTHING), world.study.assumptions
    with suppress(NeverThere):
        if not is_zero(place - begin):
            return [way_to(world, name, place, given)]
    there, *back = to_and_fro(world, name, given)
    if not back:
        raise Undecided(f"whether “{name}” comes back is not known")
    return [there] if is_zero(place - begin) else [there, *((way, way.until(place, within)) for way, within in back)]
