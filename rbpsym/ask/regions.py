"""For which values of a parameter something holds: as a region between zeros, in one place or on a whole way."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rbpsym.ask.extremes import Extreme, least
from rbpsym.ask.finding import NO_SUCH, Finding, checked, kept_said, together
from rbpsym.ask.lasting import lasts_to_place
from rbpsym.ask.question import SUPERLATIVES
from rbpsym.ask.seen import AskedPhase, moving, never_told, parameter, way_to
from rbpsym.ask.wanted import Wanted, case_of, on_what
from rbpsym.ask.zeros import Crossing, Zero, settled_sign, sign_table, where_met
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat, rooted
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import undecided
from rbpsym.errors import StatementError, all_there
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, short, substitute
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.demands import Demand, possible, settle


class Region(Frozen):
    """lower < name < upper, where `asked` is met; None means that the range alone bounds it.

    otherwise: 1 or -1 where it holds everywhere or nowhere if what is asked is not met; loose: what of it is such that it
    holds everywhere if that is not met. is_empty: nowhere. crossing: the one
    bound, where it has no closed form. worst: the places on the way that decide. cases: instead, regions of which one holds.
    """

    lower: Scalar | None = None
    upper: Scalar | None = None
    asked: tuple[Demand, ...] = ()
    is_empty: bool = False
    crossing: Crossing | None = None
    worst: tuple[Scalar | None, ...] = ()
    otherwise: int = 0
    loose: tuple[Demand, ...] = ()
    cases: tuple[Region, ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether it holds in the whole range."""
        return not (self.is_empty or self.cases or self.crossing) and self.lower is self.upper is None


    def within(self, name: str, given: Assumptions) -> Assumptions:
        """What is known with the range of the name cut to this."""
        lower, upper = given.range_of(name)
        return given.with_range(name, lower if self.lower is None else self.lower, upper if self.upper is None else self.upper)


def region(value: Scalar, name: str, given: Assumptions) -> Region | None:
    """Where a value is positive (or vanishes identically); None if it is not decided, or if it is so on several parts of
    the range."""
    if not depends_on(value, name) or is_zero(value):
        known = settled_sign(value, given)
        return Region(asked=(Demand(value, ">="),), otherwise=-1) if known is None else Region(is_empty=known < 0)
    table = sign_table(value, name, given)
    if not table.is_whole or table.signs.count(1) > 1:
        return None
    if table.zeros.crossings:
        return Region(crossing=table.zeros.crossings[0])
    if 1 not in table.signs:
        return Region(asked=table.zeros.asked, is_empty=True)
    k = table.signs.index(1)
    places = [None, *(zero.place for zero in table.zeros.found), None]
    signs = {demand: _otherwise(value, name, demand, given) for demand in table.zeros.asked}
    [otherwise] = set(signs.values()) if len(set(signs.values())) == 1 else [0]
    loose = tuple(demand for demand, side in signs.items() if side == 1)
    return Region(places[k], places[k + 1], table.zeros.asked, otherwise=otherwise, loose=loose)


def _otherwise(value: Scalar, name: str, demand: Demand, given: Assumptions) -> int:
    """The sign in the whole range where the demand is not met; 0 if it is not known."""
    opposite = Demand(-demand.value, ">=" if demand.op == ">" else ">")
    table = sign_table(value, name, where_met(given, [opposite]))
    return (table.signs[0] or 0) if demand.op != "!=" and table.is_whole and len(table.signs) == 1 else 0


def region_on_way(value: Scalar, name: str, along: str, given: Assumptions) -> Region | None:
    """For which parameters a value is positive all along a way (the range of `along`); None if it is not decided.

    What vanishes at an end of the way is looked at beside it.
    """
    if sign(short(value), given).kind == "positive":
        return Region()
    if not depends_on(value, along):
        return region(value, name, given.without(along))
    def is_plain(low: Extreme) -> bool:
        return not any(depends_on(demand.value, name) for demand in low.asked)

    found = least(value, along, given, is_plain)
    found = found if found and found[1] else least(value, along, given, lambda low: True)
    return found and common([_of_low(low, name, along, given) for low in found[1]], given.without(along))


def _of_low(low: Extreme, name: str, along: str, given: Assumptions) -> Region | None:
    if low.value is None:
        return Region(is_empty=True, asked=low.asked)
    if low.where and is_zero(low.value) and low.beside:
        return Region(is_empty=low.beside < 0, asked=low.asked)
    found = region(low.value, name, where_met(given, low.asked).without(along))
    otherwise, loose = (0, ()) if found is None or low.asked else (found.otherwise, found.loose)
    return found and replace(found, asked=(*low.asked, *found.asked), worst=(low.place,), otherwise=otherwise, loose=loose)


def common(every: Sequence[Region | None], given: Assumptions) -> Region | None:
    """Where all hold; None if it is not decided."""
    if any(one is not None and one.is_empty and not one.asked for one in every):
        return Region(is_empty=True)
    regions = all_there(every)
    if regions is None or any(one.crossing or one.is_empty for one in regions):
        left = [one for one in every if one is None or not one.is_whole]
        return left[0] if len(left) == 1 else None
    asked = tuple(dict.fromkeys(demand for one in regions for demand in one.asked))
    bound = [one for one in regions if not one.is_whole]
    if settle(asked, given) is None:
        loose, firm = ([one for one in bound if bool(one.loose) == is_loose] for is_loose in (True, False))
        held = [demand for one in firm for demand in one.asked]
        kept = [one for one in loose if settle([*held, *one.asked], given) is not None]
        if len(kept) < len(loose):
            return common([*kept, *firm], given) if _are_whole([o for o in loose if o not in kept], held, given) else None
        if not all(_are_whole([other for other in loose if other is not one], one.asked, given) for one in loose):
            return None
        cases = all_there(common([one, *firm], given) for one in loose)  # one is whole where the other's demands are met
        is_told = cases is not None and len(cases) == 2 and not any(one.is_empty or one.cases for one in cases)
        return Region(cases=tuple(cases)) if cases and is_told else None
    given = where_met(given, asked)
    lower = _outermost([one for one in regions if one.lower is not None], "lower", 1, given)
    upper = _outermost([one for one in regions if one.upper is not None], "upper", -1, given)
    if lower is None or upper is None:
        return None
    low, high = lower.lower, upper.upper
    width = None if low is None or high is None else high - low
    room = 1 if width is None else settled_sign(width, given)
    is_empty, asked = room in (0, -1), (*asked, *([Demand(width)] if width is not None and room is None else []))
    otherwise = bound[0].otherwise if len(bound) == 1 and asked == bound[0].asked else 0
    return Region(low, high, asked, is_empty, None, (*lower.worst, *upper.worst), otherwise)


def _are_whole(regions: Sequence[Region], met: Sequence[Demand], given: Assumptions) -> bool:
    """Whether each holds everywhere under these demands, since one that it asks for is then not met."""
    return all(any(settle([*met, demand], given) is None for demand in one.loose) for one in regions)


def by_order(regions: Sequence[Region | None], beside: Sequence[Region | None], given: Assumptions, sense: int) -> Region | None:
    """Where all hold, those `beside` too: in cases, each with the condition that one of the regions' upper (1) or lower (-1)
    bounds comes first; None if that is not what decides."""
    every = all_there(one for one in (*regions, *beside) if one is None or not one.is_whole or one.asked)
    if every is None or any(one.crossing or one.is_empty or one.cases for one in every):
        return None
    shared = tuple(dict.fromkeys(demand for one in every for demand in one.asked))
    side = SIDES[sense]
    cases: list[Region] = []
    for one in {getattr(one, side): one for one in regions if one is not None}.values():
        if getattr(one, side) is not None:
            found = replace(one, lower=None) if sense > 0 else replace(one, upper=None)
            order = [demand for two in every if two is not one for demand in _behind(two, found, sense)]
            asked = settle((*shared, *order), given)
            otherwise = one.otherwise if asked == settle(one.asked, given) else 0
            cases += [] if asked is None else [replace(found, asked=asked, otherwise=otherwise)]
    return None if not cases else cases[0] if len(cases) == 1 else Region(cases=tuple(cases))


SIDES = {1: "upper", -1: "lower"}


def _behind(one: Region, found: Region, sense: int) -> list[Demand]:
    """What has to hold for a region to lie around the upper (1) or lower (-1) bound that was found."""
    bound = getattr(found, SIDES[sense])
    ends = ((getattr(one, SIDES[sense]), ">=", sense), (getattr(one, SIDES[-sense]), ">", -sense))
    return [Demand((end - bound) * way, op) for end, op, way in ends if end is not None]


def binding(
    values: Sequence[Scalar], regions: Sequence[Region | None], found: Region, given: Assumptions, sense: int
) -> tuple[Scalar, ...]:
    """The values that have no region, or one that lies around the bound without a printed condition for that."""
    pairs = [(value, one) for value, one in zip(values, regions, strict=True) if not (one and one.is_whole and one.asked)]
    if getattr(found, SIDES.get(sense, ""), None) is None:
        return tuple(value for value, _ in pairs)
    return tuple(value for value, one in pairs if one is None or settle(_behind(one, found, sense), given) == ())


def alone(found: Region, regions: Sequence[Region | None], given: Assumptions, sense: int) -> tuple[Demand, ...]:
    """What is asked for the upper (1) or lower (-1) bound alone, without the demands of what is no bound otherwise, and with
    what followed from those."""
    side = SIDES[sense]
    idle = [one for one in regions if one and one.otherwise == 1 and getattr(one, side) != getattr(found, side)]
    firm = dict.fromkeys(demand for one in regions if one and one not in idle for demand in one.asked)
    left = dict.fromkeys(demand for demand in found.asked if demand in firm or not any(demand in one.asked for one in idle))
    whole = settle({**left, **firm}, given)
    return tuple(left) if whole is None else whole


def _outermost(found: list[Region], side: str, sense: int, given: Assumptions) -> Region | None:
    """The one that binds; one without bounds if there is none."""
    def is_beyond(one: Region, other: Region) -> bool:
        return settled_sign((getattr(one, side) - getattr(other, side)) * sense, given) in (0, 1)

    best = [one for one in found if all(one is other or is_beyond(one, other) for other in found)]
    return best[0] if best else None if found else Region()


def equal_for(world: AskedPhase, superlative: str | None, name: str, condition: Wanted, text: str) -> Finding:
    """SYMBOL for which a value vanishes."""
    [value], given, asked = condition.values, condition.given, tuple[Demand, ...]()
    if name in world.coordinates:
        way, given = way_to(world, name, None, given)
        asked = possible(way.asked, world.motion.assumptions, never_told(text))
    elif name != "t":
        parameter(world, name)
    free = [other for other in moving(world, (value,)) if other != name]
    if free:
        raise StatementError(
            f"“{text}” still depends on {free[0]}", instead=f"say where: “… where {free[0]} = VALUE”, or “… at the start”."
        )
    if not depends_on(value, name) or is_zero(derivative(value, name)):
        return _without(world, name, value, given, text)
    given = where_met(given, [demand for demand in world.demands if demand.op == ">"])  # ends that may be reached stay within
    table = sign_table(value, name, given)
    zeros = [zero for zero in table.zeros.found if not zero.is_pole]
    zeros = [replace(zero, asked=left) for zero in zeros if (left := _met(world, name, zero, given)) is not None]
    if table.zeros.open_:
        why = undecided("no closed form was found for where it vanishes, nor was it seen to be monotone")
        return Finding(why, name, equation=table.zeros.open_[0])
    if table.zeros.crossings:
        return _crossing(name, table.zeros.crossings, given, is_only=not zeros)
    every = [zero.place for zero in table.zeros.found if not zero.is_pole]
    if not zeros:
        nowhere = Finding(**checked("vanishes_for", value=value, name=name, places=tuple(every), given=given))
        away = [[one.value for one in _there((*world.demands, *world.standing), name, place)] for place in every]
        others = (Finding(**kept_said(one, None, (), given, holds=False)) for one in away)  # there it is another motion
        says = f"{NO_SUCH} {name}: “{text}” holds for none in its range"
        return Finding(symbol=name, says=says, valid=(*asked, *case_of(world)), **together(nowhere, *others))
    if superlative is not None and len(zeros) > 1:
        zeros = [zeros[0 if SUPERLATIVES[superlative] < 0 else -1]]
    places = tuple(neat(zero.place, given) for zero in zeros)
    shared = tuple(d for d in zeros[0].asked if all(d in zero.asked for zero in zeros))
    under = where_met(given, [*table.zeros.asked, *(d for zero in zeros for d in zero.asked)])
    own = tuple(tuple(d for d in zero.asked if d not in shared) for zero in zeros)
    found = checked("vanishes_for", value=value, name=name, places=every, given=under)
    strict = [d for d in world.demands if d.op == ">" and not depends_on(d.value, name)]
    firm = possible(strict, world.motion.assumptions, never_told(text))
    return Finding(symbol=name, values=places, valid=tuple(dict.fromkeys((*shared, *asked, *firm))), asked=own, met=True, **found)


def _crossing(name: str, crossings: Sequence[Crossing], given: Assumptions, *, is_only: bool) -> Finding:
    """A value without a closed form, by the equation that it solves."""
    [crossing, *more] = crossings
    said = checked("one_zero", equation=crossing.equation, name=name, given=given, value=None)
    if more or not is_only:
        said = {"verdict": undecided("there are several such values, and no closed form was found for one of them")}
    return Finding(**said, symbol=name, equation=crossing.equation, says=f"{name} is the only zero of this in its range")


def _met(world: AskedPhase, name: str, zero: Zero, given: Assumptions) -> tuple[Demand, ...] | None:
    """What a zero asks for, so that the moments come about at which the quantities are taken; None if they never do."""
    limits = (replace(demand, op=">=") for demand in world.standing if demand.op == ">")  # where it just begins no more
    wanted = [*world.demands, *(demand for demand in world.standing if demand.op != ">"), *limits]
    lasts: tuple[Demand, ...] = ()
    if name in world.coordinates:
        wanted = [demand for demand in wanted if not depends_on(demand.value, name)]
        try:
            lasts, doubts = lasts_to_place(world.study, name, zero.place)
        except StatementError:
            return None
        world.doubts.extend(doubts)
    moments = [replace(d, value=rooted(d.value, given)) for d in _there(wanted, name, zero.place)]
    return settle([*zero.asked, *moments, *lasts], given)


def _there(demands: Iterable[Demand], name: str, place: Scalar) -> list[Demand]:
    """The demands at a place. Raises StatementError where one has no value."""
    try:
        return [replace(demand, value=substitute(demand.value, {name: place})) for demand in demands]
    except ZeroDivisionError:
        what = f"where {name} has that value the motion is not the one that is stated: a ratio of forces has none there"
        raise StatementError(what) from None


def _without(world: AskedPhase, name: str, value: Scalar, given: Assumptions, text: str) -> Finding:
    """What does not depend on the symbol."""
    if is_zero(value):
        said = checked("no_change", value=value, names=(name,), best=NOTHING, given=given)
        return Finding(**said, symbol=name, says=f"“{text}” holds for every {name}", valid=case_of(world))
    raise StatementError(f"“{text}” does not depend on {name}", instead=on_what(world, value))
