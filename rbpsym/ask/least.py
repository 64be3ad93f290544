"""What is asked for a value not to become negative on a way: by the one speed, by the time, by a coordinate."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.signs import sign
from rbpsym.errors import NotApplicable, RbpsymError, Undecided
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, names_in, short, substitute, symbol
from rbpsym.mechanics.coupled import courses_of
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.endings import uniform_motion
from rbpsym.mechanics.events import Way
from rbpsym.mechanics.led import sense_to
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.solutions import InTime
from rbpsym.mechanics.study import Study
from rbpsym.quantity.problem import ProblemWorld


def by_speed(study: Study, demand: Demand) -> list[Demand] | None:
    """What is asked for a function of the one speed not to become negative, where the acceleration is one too: between the first
    speed and that at which it vanishes. None for another value; raises Undecided."""
    from rbpsym.ask.wanted import Wanted
    from rbpsym.ask.yesno import least_values

    [name, *more], given = study.system.independent or ("",), study.assumptions
    speed, gain = f"{name}_dot", (study.dynamics.accelerations or {}).get(f"{name}_ddot", NOTHING)
    moving, begun = {*study.system.coordinates, *study.system.speeds, "t"}, study.system.scope.start.get(speed, NOTHING)
    if more or not gain or names_in(gain) & moving != {speed} or names_in(demand.value) & moving != {speed}:
        return None
    way = sign(substitute(gain, {speed: begun}), given).sense
    ends = [place for place in zeros(gain, speed, given) if sign((place - begun) * way, given).kind == "positive"]
    if not way or len(ends) > 1:
        return None
    try:
        end = ends[0] if ends else None
        within = given.with_range(speed, *((begun, end) if way > 0 else (end, begun)))
        return [*least_values(Wanted((demand.value,), within, speed))]
    except RbpsymError as error:
        raise Undecided(error.what) from None


def least_until(study: Study, demand: Demand, time: Scalar | None, courses: Mapping[str, InTime]) -> list[Demand]:
    """What is asked for a value not to become negative up to a time (None: ever), as the courses tell it. Raises Undecided."""
    from rbpsym.ask.seen import one_period
    from rbpsym.ask.wanted import Wanted
    from rbpsym.ask.yesno import least_values

    if time is None:
        with suppress(NotApplicable):
            courses = courses_of(study)
    at = {name: one.whole for name, one in courses.items()} | {f"{name}_dot": one.speed for name, one in courses.items()}
    told, given = short(substitute(demand.value, at)), study.assumptions
    if names_in(told) & {*study.system.coordinates, *study.system.speeds} or not depends_on(told, "t"):
        raise Undecided("their forces are not known on the way")
    if time == symbol("t"):
        return [Demand(told, demand.op)]
    given = one_period(told, given) if time is None else given.with_range("t", NOTHING, time)
    try:
        return [] if sign(told, given).is_nonnegative else [*least_values(Wanted((told,), given, "t"))]
    except RbpsymError as error:
        raise Undecided(error.what) from None


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
    from rbpsym.ask.wanted import Wanted
    from rbpsym.ask.yesno import least_values

    world, given = ProblemWorld(study), study.assumptions
    try:
        led = None if name in study.squares else driven(study, name, places)
        ways = [led] if led else _ways(world, name, places[name]) if places else to_and_fro(world, name, given)
        found = [Demand(way.ahead(places[name])) for way, _ in ways[-1:] if places and places[name] != way.start]
        for way, within in ways:
            found += least_values(Wanted((demand.value,), within, name, asked=way.asked))
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
