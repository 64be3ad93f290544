"""The greatest and least values of quantities, where they lie, and values of a parameter that give the same."""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import replace

from rbpsym.ask.answer import on_way_back
from rbpsym.ask.extremes import ENDS, Extreme, extreme
from rbpsym.ask.finding import Finding, checked, together
from rbpsym.ask.lasting import lasts_to_place
from rbpsym.ask.limits import leading
from rbpsym.ask.question import SUPERLATIVES
from rbpsym.ask.regions import equal_for, region
from rbpsym.ask.seen import (
    AskedPhase,
    comes_back,
    fits,
    moving,
    never_told,
    one_period,
    parameter,
    parts_seen,
    place_in,
    seen,
    told,
    whole_ways,
)
from rbpsym.ask.special import limit_said
from rbpsym.ask.wanted import Wanted, on_what
from rbpsym.ask.zeros import precedes, settled_sign, sign_table, where_met
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import undecided
from rbpsym.errors import RbpsymError, StatementError, all_there, there
from rbpsym.field import Scalar, depends_on, derivative, is_zero, substitute, symbol
from rbpsym.mechanics.demands import Demand, possible, settle
from rbpsym.mechanics.events import Way
from rbpsym.mechanics.roots import period


def extremum(
    world: AskedPhase,
    superlative: str,
    phrase: str,
    over: str | None,
    low: str | None,
    high: str | None,
    *,
    by_place: bool = False,
) -> Finding:
    """The greatest or least value of a quantity over a coordinate (on its way), a parameter, or the time; of a speed, its
    magnitude is meant; over a parameter, of what changes on the way, its greatest or least value there."""
    if over is not None and over not in (*world.coordinates, "t"):
        parameter(world, over)
    phrase, value, inner = _subject(world, superlative, phrase, over, is_whole=low is None, by_place=by_place)
    name, sense = over or next(iter(moving(world, (value,))), ""), SUPERLATIVES[superlative]
    given = _ranges(world, name, value)
    back = _on_way_back(world, name, value, given)
    is_turned = sense > 0 and not back and not HIGH.match(phrase) and sign(value, given).kind in ("negative", "nonpositive")
    value = -value if is_turned else value
    ways = _ways(world, name, value, given, (low, high), is_over=over is not None)
    if ways is None:
        return Finding(undecided("whether the motion goes on as it is stated through a whole period is not decided"))
    closed = name in (*world.coordinates, "t") or low is not None
    found = []
    for _, range_, way in ways:
        both = (value, *back)
        parts = [of_extreme(one, name, range_, sense, phrase, closed=closed, by_place=by_place, way=way) for one in both]
        found.append(_lasting(world, name, _best(parts, sense, range_, by_place=by_place)))
    if is_turned:
        says = f"“{phrase}” is negative: its magnitude is meant"
        positive = ("least_on_way", {"parts": ((value, None, value),), "along": None, "given": given, "holds": True})
        found = [replace(one, says=f"{says}; {one.says}" if one.says else says) for one in found]
        found = [replace(one, grounds=(*one.grounds, positive)) for one in found]
    if any(len(one.values) != 1 for one in found) and len(found) > 1:
        return Finding(undecided("it depends on the sense in which the motion sets out"))
    if any(not is_zero(one.values[0] - found[0].values[0]) for one in found[1:]):
        values, each = tuple(one.values[0] for one in found), tuple(demands for demands, *_ in ways)
        return replace(found[0], **together(*found), values=values, asked=each, place=None)
    common = [demand for demand in ways[0][0] if all(demand in demands for demands, *_ in ways)]
    asked = (*common, *inner.valid)
    valid = possible((*found[0].valid, *asked), world.motion.assumptions, never_told(phrase)) if asked else found[0].valid
    if phrase.endswith(f" as a function of {name}") and not fits(world, valid):
        return Finding(undecided("where it lies depends on the parameters: it is known for others than those of the example"))
    return replace(found[0], **together(*found, *([inner] if inner.grounds else [])), valid=valid)


def _subject(
    world: AskedPhase, superlative: str, phrase: str, over: str | None, *, is_whole: bool, by_place: bool
) -> tuple[str, Scalar, Finding]:
    """The quantity with its value, which depends on one name at most, or on that over which it is asked; and what found the
    greatest or least value of another one, which it is. Raises StatementError for what has no extremum of one name."""
    if nested := NESTED.fullmatch(phrase):
        inner = extremum(world, nested[1], nested[2], None, None, None)
    phrase, value = (phrase, _only(inner, phrase)) if nested else sized(world, phrase)
    free = moving(world, (value,))
    is_nested = over is not None and over not in ("t", *world.coordinates) and depends_on(value, over)
    if is_nested and free and is_whole and not by_place:
        inner = extremum(world, superlative, phrase, None, None, None)
        return phrase, _only(inner, phrase), inner
    is_open = over == "t" or len(free) > 1 or {*free} - {*world.motion.squares, "t"}
    last = world.number + 1 == len(world.asked.names)
    for other in (*(world.motion.squares if over is None else ()), *(("t",) if last else ())):  # by what else it can be told
        if over in (None, "t") and is_whole and is_open and free != [other]:
            with suppress(RbpsymError):
                phrase, value = sized(world, f"{phrase} as a function of {other}")
                free = moving(world, (value,))
                break
    name = over or (free[0] if len(free) == 1 else None)
    if name is None:
        what = f"depends on {', '.join(free)}" if free else "is constant on the motion"
        instead = "say over what: “… over NAME”, or “… over NAME between VALUE and VALUE”."
        raise StatementError(f"“{phrase}” {what}", instead=instead)
    if name in world.motion.speeds or name in world.motion.unsettled:
        what = f"“{phrase}” is not known as a function of the position alone"
        raise StatementError(what, instead=f"ask for its magnitude, or give {name.removesuffix('_dot')} a start.")
    if any(other != name for other in free) and not by_place:
        raise StatementError(f"“{phrase}” depends on {next(o for o in free if o != name)} too")
    if not depends_on(value, name):
        raise StatementError(f"“{phrase}” does not depend on {name}", instead=on_what(world, value))
    return phrase, value, inner if nested else Finding()


NESTED = re.compile(rf"({'|'.join(SUPERLATIVES)}) ((?!frequency |period ).+)")


def _only(found: Finding, phrase: str) -> Scalar:
    if len(found.values) != 1 or found.relation != "=":
        raise StatementError(f"the greatest or least value of “{phrase}” is not known as one formula")
    return found.values[0]


def _ranges(world: AskedPhase, name: str, value: Scalar) -> Assumptions:
    """What is known where the quantity has that value: of a parameter, also in which range its conditions are met."""
    given = where_met(world.motion.assumptions, [demand for demand in world.demands if not depends_on(demand.value, name)])
    if name in world.coordinates or _turns(name, value):
        return given
    for demand in (*world.demands, *world.standing):
        where = region(demand.value, name, given) if depends_on(demand.value, name) else None
        if where and not (where.asked or where.crossing or where.is_empty):
            given = where.within(name, given)
    return given


def _turns(name: str, value: Scalar) -> bool:
    return name == "t" and period(value, "t") is not None


Ways = list[tuple[tuple[Demand, ...], Assumptions, Way | None]]


def _ways(
    world: AskedPhase, name: str, value: Scalar, given: Assumptions, between: tuple[str | None, str | None], *, is_over: bool
) -> Ways | None:
    """The ranges in which it is looked for, each with what it asks for and the way through it; None where that is not decided."""
    low, high = between
    if low is not None and high is not None:
        ends = place_in(world, name, low), place_in(world, name, high)
        if not precedes(*ends, given):
            raise StatementError(f"“{low}” is not surely less than “{high}”", instead="write the lower end first.")
        return [((), given.with_range(name, *ends), None)]
    if name in world.motion.squares and name in world.motion.scope.start:
        whole = whole_ways(world, name, given)
        return [(way.asked, one_period(value, range_, name, way.start, way.sense), way) for way, range_ in whole]
    if name == "t":
        within = one_period(value, given)
        asked = _all_along(world, within) if _turns(name, value) else []
        return None if asked is None else [(tuple(asked), within, None)]
    if not is_over and name in world.coordinates:
        what = f"how far {name} goes in this motion is not known as a function of the position"
        raise StatementError(what, instead=f"say between which values: “… over {name} between VALUE and VALUE”.")
    return [((), given, None)]


def _all_along(world: AskedPhase, given: Assumptions) -> list[Demand] | None:
    """What is asked of the whole time, where it is least; None where something is not known to have a least value."""
    lows = ((d, extreme(d.value, "t", given, -1)) for d in (*world.demands, *world.standing) if depends_on(d.value, "t"))
    return all_there(None if low is None or low.value is None else Demand(low.value, d.op) for d, low in lows)


def _on_way_back(world: AskedPhase, name: str, value: Scalar, given: Assumptions) -> tuple[Scalar, ...]:
    """What it is where the coordinate passes its places again in the opposite sense, if that is something else."""
    found = world.used[-1][1]
    if not found.ways or name not in world.motion.squares or found.of != "position":
        return ()
    [other] = on_way_back(world, found)
    other = neat(other, given)
    if is_zero(other - value):
        return ()
    try:
        return (other,) if comes_back(world, name, given) else ()
    except StatementError:  # it is not known how far it goes
        world.doubts.append("whether it comes back, where this is another one, is not decided")
        return ()


def _best(parts: list[Finding], sense: int, given: Assumptions, *, by_place: bool) -> Finding:
    """The finding that no other one exceeds, of several about the same quantity."""
    if len(parts) == 1:
        return parts[0]
    if not by_place and all(len(one.values) == 1 for one in parts):
        for one, other in (parts, parts[::-1]):
            under = where_met(given, (*one.valid, *other.valid))
            if settled_sign((one.values[0] - other.values[0]) * sense, under) in (0, 1):
                beyond = checked("greatest_of", best=one.values[0], others=((other.values[0], under),), sense=sense)
                return replace(one, **together(one, Finding(**beyond), other))
    return Finding(undecided("on the way back it is another one, and which one is beyond the other is not decided"))


HIGH = re.compile("height of ")


def sized(world: AskedPhase, phrase: str) -> tuple[str, Scalar]:
    """A quantity with its value; of a vector, and of a speed, its magnitude."""
    phrase = re.sub(r"^(?=(?:speed|velocity) of )", "magnitude of ", phrase)
    count = len(world.used)
    if len(values := parts_seen(world, phrase)) == 1:
        return phrase, values[0]
    del world.used[count:]
    return f"magnitude of {phrase}", seen(world, f"magnitude of {phrase}")


def _lasting(world: AskedPhase, name: str, found: Finding) -> Finding:
    """With what contacts, friction and slips ask for on the way to the place where it lies, or for that value."""
    if found.place is None or found.place[1] is None:
        return found
    if name not in world.coordinates:
        at = {name: found.place[1]}
        met = (Demand(neat(substitute(d.value, at), world.motion.assumptions), d.op) for d in (*world.demands, *world.standing))
        left = settle((*found.valid, *met), world.motion.assumptions)
        return Finding(undecided(BEYOND), found.symbol) if left is None else replace(found, valid=left, met=True)
    lasts, doubts = lasts_to_place(world.study, name, found.place[1])
    never = StatementError(f"the motion that is stated ends before it comes to where this is, {name} = {told(found.place[1])}")
    world.doubts.extend(doubts)
    return replace(found, valid=possible((*found.valid, *lasts), world.motion.assumptions, never))


BEYOND = "where it would be, the motion is not the one that is stated"


def of_extreme(
    value: Scalar, name: str, given: Assumptions, sense: int, phrase: str, *, closed: bool, by_place: bool, way: Way | None = None
) -> Finding:
    """The greatest (least) value on a range, or where it lies; `closed`: its ends belong to it."""
    found = extreme(value, name, given, sense, way)
    word = "largest" if sense > 0 else "least"
    if found is None:
        return Finding(undecided("the signs of the slope on the range are not decided"), name if by_place else "")
    if found.where == "everywhere":
        said = checked("no_change", value=value, names=(name,), best=found.value, given=given)
        return Finding(**said, values=(there(found.value),), says=f"“{phrase}” is the same for every {name}")
    if found.crossing is not None:
        said = checked("one_zero", equation=found.crossing.equation, name=name, given=given, value=value)
        return Finding(**said, symbol=name, equation=found.crossing.equation, place=(name, None))
    if found.value is None:
        says = f"there is none: “{phrase}” has no bound as {name} goes to {_end(found)}"
        side = 1 if found.where == ENDS[0] else -1
        near = there(leading(value, name, found.place, given, side if found.place is not None else -side))
        return Finding(**limit_said(near, name, given), symbol=name if by_place else "", says=says)
    under = where_met(given, found.asked)
    data = {"value": value, "name": name, "place": found.place, "best": found.value, "sense": sense}
    said = checked("extreme", **data, given=under, at_end=bool(found.where))
    if found.where and (not closed or found.place is None):
        says = f"no {word} value is reached: {told(found.value)} is approached as {name} goes to {_end(found)}"
        values = () if by_place else (found.value,)
        symbol_ = name if by_place else ""
        return Finding(symbol=symbol_, **said, values=values, relation="approaches", valid=found.asked, says=says)
    place = (name, found.place)
    if by_place:
        return Finding(symbol=name, **said, values=(there(found.place),), valid=found.asked, place=place)
    return Finding(**said, values=(found.value,), valid=found.asked, place=place)


def _end(found: Extreme) -> str:
    infinite = "minus infinity" if found.where == ENDS[0] else "infinity"
    return infinite if found.place is None else told(found.place)


# --- equal values


PLURALS = {"periods": "period", "frequencies": "frequency"}


def with_equal(world: AskedPhase, first: str, second: str, phrase: str) -> Finding:
    """Two different values of one parameter with the same value of a quantity: the second as a function of the first."""
    parameter(world, first)
    phrase = PLURALS.get(phrase, phrase)
    value, given = seen(world, phrase), world.motion.assumptions
    known = {quantity.name for quantity in world.study.problem.parameters}
    if not depends_on(value, first):
        raise StatementError(f"“{phrase}” does not depend on {first}", instead=on_what(world, value))
    if second in known and depends_on(value, second):
        raise StatementError(f"“{phrase}” depends on both {first} and {second}", instead=f"name the other value of {first} anew.")
    given = _like(given, first, second)
    other = substitute(value, {first: symbol(second)})
    table = sign_table(other - value, second, given.with_range(second, *given.range_of(second)))
    zeros = [z for z in table.zeros.found if not z.is_pole and not is_zero(z.place - symbol(first))]
    if not zeros and not table.zeros.open_ and not table.zeros.crossings:
        said = checked("vanishes_for", value=other - value, name=second, places=(symbol(first),), given=given)
        return Finding(**said, symbol=second, says=f"only {second} = {first} has the same")
    if not zeros or table.zeros.open_:
        return Finding(undecided("no closed form was found for it"), second, equation=(table.zeros.open_ or (other - value,))[0])
    gap = neat(other * other - value * value, given)  # both are positive, or zero together
    same = sign(value, given).is_nonnegative
    every = [*(zero.place for zero in zeros), symbol(first)]
    asked = where_met(given, [demand for zero in zeros for demand in zero.asked])
    said = checked("vanishes_for", value=gap if same else other - value, name=second, places=every, given=asked)
    places = tuple(neat(zero.place, given) for zero in zeros)
    return Finding(**said, symbol=second, values=places, asked=tuple(z.asked for z in zeros))


def without_effect(world: AskedPhase, name: str, phrase: str, other: str) -> Finding:
    """SYMBOL for which a quantity does not depend on another one: its rate vanishes for all values of that."""
    text, rate = f"{phrase} does not depend on {other}", derivative(seen(world, phrase), parameter(world, other))
    found = equal_for(world, None, name, Wanted((rate,), world.motion.assumptions, equal=True), text)
    if any(depends_on(value, other) for value in found.values):
        raise StatementError(f"there is no one {name} for which “{text}”, whatever {other} is")
    return found


def _like(given: Assumptions, first: str, second: str) -> Assumptions:
    """The assumptions with a second name of which the same is declared."""
    given = given.with_signs({second: given.sign_of(first)})
    return given.with_range(second, *given.range_of(first)) if first in given.ranges else given
