"""For which values of a parameter something holds, is least, is greatest or is equal: questions and their answers."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import Scalar, symbol
from rbpsym.ask.extremes import extreme
from rbpsym.ask.finding import Finding, checked, verdict_of
from rbpsym.ask.neat import neat
from rbpsym.ask.regions import Region, alone, common, region_on_way
from rbpsym.ask.seen import Scene, moving, one_period, parameter, place_in, seen, told, way_to, whole_ways
from rbpsym.ask.wanted import Wanted, arrives, wanted
from rbpsym.ask.zeros import Zero, sign_table, where_met
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.signs import sign
from rbpsym.equality.verdict import all_of, proved, undecided
from rbpsym.errors import StatementError
from rbpsym.mechanics.demands import Demand, settle
from rbpsym.mechanics.rest import rooted
from rbpsym.mechanics.stability import essential

LEAST = {"smallest": -1, "least": -1, "lowest": -1, "minimum": -1, "minimal": -1, "shortest": -1, "slowest": -1}
GREATEST = {"largest": 1, "greatest": 1, "highest": 1, "maximum": 1, "maximal": 1, "longest": 1, "fastest": 1}
SUPERLATIVES = LEAST | GREATEST


def which(world: Scene, superlative: str | None, name: str, text: str) -> Finding:
    """SYMBOL for which a condition is met; the smallest or largest of them."""
    condition = wanted(world, text, name)
    if not condition.equal and superlative is None and name not in world.coordinates:
        return _region(world, name, condition, text, 0)
    if condition.equal:
        return _values(world, superlative, name, condition, text)
    return _region(world, name, condition, text, SUPERLATIVES[superlative])


# --- equalities


def _values(world: Scene, superlative: str | None, name: str, condition: Wanted, text: str) -> Finding:
    [value], given = condition.values, condition.given
    if name in world.coordinates:
        _, given = way_to(world, name, None, given)
    else:
        parameter(world, name)
    free = [other for other in moving(world, (value,)) if other != name]
    if free:
        raise StatementError(
            f"“{text}” still depends on {free[0]}", instead=f"say where: “… where {free[0]} = VALUE”, or “… at the start”."
        )
    if not depends_on(value, name) or is_zero(derivative(value, name)):
        return _without(world, name, value, given, text)
    table = sign_table(value, name, given)
    zeros = [zero for zero in table.zeros.found if not zero.is_pole]
    zeros = [replace(zero, asked=left) for zero in zeros if (left := _met(world, name, zero, given)) is not None]
    if table.zeros.open_:
        return Finding(
            undecided("where it vanishes has no closed form, and it is not monotone"), name, equation=table.zeros.open_[0]
        )
    if table.zeros.crossings:
        [crossing, *more] = table.zeros.crossings
        verdict = proved("it is monotone, and its signs at the ends of the range differ")
        if more or zeros:
            verdict = undecided("there are several such values, and one of them has no closed form")
        return Finding(verdict, name, equation=crossing.equation, says=f"{name} is the only zero of this in its range")
    if not zeros:
        found = checked("vanishes_for", value=value, name=name, places=(), given=given)
        return Finding(symbol=name, says=f"there is no such {name}: “{text}” holds for none in its range", **found)
    if superlative is not None and len(zeros) > 1:
        zeros = [zeros[0 if SUPERLATIVES[superlative] < 0 else -1]]
    places = tuple(neat(zero.place, given) for zero in zeros)
    shared = tuple(d for d in zeros[0].asked if all(d in zero.asked for zero in zeros))
    under = where_met(given, [*table.zeros.asked, *(d for zero in zeros for d in zero.asked)])
    every = [zero.place for zero in table.zeros.found if not zero.is_pole]
    own = tuple(tuple(d for d in zero.asked if d not in shared) for zero in zeros)
    found = checked("vanishes_for", value=value, name=name, places=every, given=under)
    return Finding(symbol=name, values=places, valid=shared, asked=own, **found)


def _met(world: Scene, name: str, zero: Zero, given: Assumptions) -> tuple[Demand, ...] | None:
    """What a zero asks for, so that the moments come about at which the quantities are taken; None if they never do."""
    moments = (Demand(rooted(substitute(d.value, {name: zero.place}), given), d.op) for d in world.demands)
    return settle([*zero.asked, *moments], given)


def _without(world: Scene, name: str, value: Scalar, given: Assumptions, text: str) -> Finding:
    """What does not depend on the symbol."""
    if is_zero(value):
        return Finding(proved("it is an identity"), name, says=f"“{text}” holds for every {name}")
    raise StatementError(f"“{text}” does not depend on {name}", instead=_instead(world, value))


def _instead(world: Scene, value: Scalar) -> str:
    known = [q.name for q in world.study.problem.parameters if depends_on(value, q.name)]
    return f"it depends on {', '.join(known)}." if known else ""


# --- regions


def _region(world: Scene, name: str, condition: Wanted, text: str, sense: int) -> Finding:
    moments = [demand for demand in world.demands if demand.op != "!="]
    given = where_met(condition.given, [*condition.asked, *(d for d in moments if not depends_on(d.value, name))])
    values = (*condition.values, *(d.value for d in moments if depends_on(d.value, name)))
    along = condition.along
    if name in world.coordinates or not any(depends_on(value, name) for value in (*values, *_ends_of(given, along))):
        parameter(world, name)
    free = [other for other in moving(world, values) if other != along]
    if free:
        raise StatementError(f"“{text}” depends on {free[0]} too", instead="say where or until when: “… until theta = VALUE”.")
    cores = [essential(value, given) for value in values]
    if not any(depends_on(value, name) for value in (*cores, *_ends_of(given, along))):
        known = common([region_on_way(value, name, along or "", given) for value in values], given)
        if known is not None and not known.asked:
            says = "for no values" if known.is_empty else "for all values"
            says = f"“{text}” holds {says} of the parameters in their declared ranges"
            return Finding(proved("the sign is the same for all parameters"), name, says=says)
        raise StatementError(f"“{text}” does not depend on {name}", instead=_instead(world, cores[0]))
    regions = [region_on_way(value, name, along or "", given) for value in values]
    found = common(regions, given)
    if found is None:
        return Finding(undecided("for which values it holds is not decided: a sign on the way is open"), name)
    if found.cases:
        return _in_cases(name, found, values, given, along, sense)
    if not found.is_empty and (sense or None in (found.lower, found.upper)):
        found = replace(found, asked=alone(found, regions, sense or (-1 if found.upper is None else 1)))
    return _told(name, found, replace(condition, given=given), text, sense, _said(values, name, found, given, along, sense))


def _ends_of(given: Assumptions, along: str | None) -> list[Scalar]:
    return [end for end in (given.range_of(along) if along else ()) if end is not None]


def _said(values, name: str, found: Region, given: Assumptions, along: str | None, sense: int = 0) -> dict[str, Any]:
    given = where_met(given, found.asked)
    if found.is_empty or found.is_whole or found.crossing:
        return {"verdict": proved("its sign is the same everywhere" if not found.crossing else "it is monotone")}
    sense = 0 if (found.lower if sense < 0 else found.upper) is None else sense
    ends, way = {1: found.lower, -1: found.upper}, (along, found.worst)
    return checked("holds_for", values=tuple(values), name=name, ends=ends, way=way, given=given, sense=sense)


def _in_cases(name: str, found: Region, values, given: Assumptions, along: str | None, sense: int) -> Finding:
    """The bounds, each under its condition."""
    bounds = [case.lower if case.upper is None else case.upper for case in found.cases]
    lower = [case.upper is None for case in found.cases]
    if None in bounds or len(set(lower)) > 1 or (sense and lower[0] != (sense < 0)):
        return Finding(undecided("the bounds depend on the parameters in more than one way"), name)
    verdict = all_of(_said(values, name, case, given, along)["verdict"] for case in found.cases)
    relation = "=" if sense else ">=" if lower[0] else "<="
    return Finding(verdict, name, tuple(bounds), relation, asked=tuple(case.asked for case in found.cases))


def _told(name: str, found: Region, condition: Wanted, text: str, sense: int, said: dict[str, Any]) -> Finding:
    if found.is_empty:
        says = f"there is no such {name}: “{text}” holds for none in its range"
        return Finding(symbol=name, **said, valid=found.asked, says=says)
    if found.is_whole:
        return Finding(symbol=name, **said, valid=found.asked, says=f"“{text}” holds for every {name} in its range")
    if found.crossing is not None:
        relation = ">" if found.crossing.sense > 0 else "<"
        return Finding(symbol=name, **said, relation=relation, equation=found.crossing.equation)
    closed, says = _closed(condition, found, name)
    says = says or OTHERWISE[found.otherwise].format(text=text, name=name)
    ends = (found.lower, found.upper)
    if sense:
        bound = found.lower if sense < 0 else found.upper
        if bound is None:
            other, word = (found.upper, "smaller") if sense < 0 else (found.lower, "larger")
            says = f"every {word} {name} does: it holds for {name} {'<' if sense < 0 else '>'} {told(other)}"
            return Finding(symbol=name, **said, values=(other,), relation="<" if sense < 0 else ">", valid=found.asked, says=says)
        return Finding(symbol=name, **said, values=(bound,), valid=found.asked, says=says)
    if None not in ends:
        return Finding(symbol=name, **said, values=ends, relation="between", valid=found.asked, says=says)
    relation = (">" if found.upper is None else "<") + ("=" if closed else "")
    bound = found.lower if found.upper is None else found.upper
    return Finding(symbol=name, **said, values=(bound,), relation=relation, valid=found.asked, says=says)


def _closed(condition: Wanted, found: Region, name: str) -> tuple[bool, str]:
    """Whether it still holds at the bound; the sentence where it does not."""
    if not condition.closed:
        return False, f"at this {name} itself it does not hold"
    if condition.end is None or None in (condition.along, *found.worst) or not found.worst:
        return True, ""
    bound = found.lower if found.upper is None else found.upper
    [place, *_], along = found.worst, condition.along
    square = substitute(condition.values[-1], {name: bound, along: place})
    if arrives(condition, place, {name: bound}) or not is_zero(rooted(square, condition.given)):
        return True, ""
    return False, f"with this {name} itself, {along} = {told(place)} is approached and never reached"


OTHERWISE = {0: "", 1: "else “{text}” holds for every {name}", -1: "else there is no such {name}"}


# --- extrema


def extremum(world: Scene, superlative: str, phrase: str, over: str | None, low: str | None, high: str | None) -> Finding:
    """The greatest or least value of a quantity over a coordinate or parameter."""
    if over is not None and over not in (*world.coordinates, "t"):
        parameter(world, over)
    value, given = seen(world, phrase), world.motion.assumptions
    free = moving(world, (value,))
    name = over or (free[0] if len(free) == 1 else None)
    if name is None:
        what = f"depends on {', '.join(free)}" if free else "is constant on the motion"
        instead = "say over what: “… over NAME”, or “… over NAME between VALUE and VALUE”."
        raise StatementError(f"“{phrase}” {what}", instead=instead)
    if any(other != name for other in free):
        raise StatementError(f"“{phrase}” depends on {next(o for o in free if o != name)} too")
    if not depends_on(value, name):
        raise StatementError(f"“{phrase}” does not depend on {name}", instead=_instead(world, value))
    closed = low is not None
    if low is not None:
        given = given.with_range(name, place_in(world, name, low), place_in(world, name, high))
    elif name in world.motion.squares and name in world.motion.scope.start:
        each = [
            _of_extreme(value, name, range_, SUPERLATIVES[superlative], phrase, closed=True, by_place=False)
            for _, range_ in whole_ways(world, name, given)
        ]
        if any(len(one.values) != 1 or not is_zero(one.values[0] - each[0].values[0]) for one in each[1:]):
            return Finding(undecided("it depends on the sense in which the motion sets out"))
        return replace(each[0], verdict=all_of(one.verdict for one in each))
    elif name == "t":
        closed, given = True, one_period(value, given)
    return _of_extreme(value, name, given, SUPERLATIVES[superlative], phrase, closed=closed, by_place=False)


def extreme_for(world: Scene, name: str, phrase: str, superlative: str) -> Finding:
    """SYMBOL for which a quantity is least or greatest."""
    value, given = seen(world, phrase), world.motion.assumptions
    if name not in world.coordinates:
        parameter(world, name)
    if not depends_on(value, name):
        raise StatementError(f"“{phrase}” does not depend on {name}", instead=_instead(world, value))
    return _of_extreme(value, name, given, SUPERLATIVES[superlative], phrase, closed=False, by_place=True)


def _of_extreme(
    value: Scalar, name: str, given: Assumptions, sense: int, phrase: str, *, closed: bool, by_place: bool
) -> Finding:
    found = extreme(value, name, given, sense)
    word = "largest" if sense > 0 else "least"
    if found is None:
        return Finding(undecided("the signs of the slope on the range are not decided"), name if by_place else "")
    if found.where == "everywhere":
        return Finding(proved("its slope vanishes"), values=(found.value,), says=f"“{phrase}” is the same for every {name}")
    if found.crossing is not None:
        return Finding(
            proved("the slope is monotone and changes its sign"), name, equation=found.crossing.equation, place=(name, None)
        )
    if found.value is None:
        says = f"there is none: “{phrase}” has no bound as {name} goes to {_end(found.place)}"
        return Finding(proved("the leading term at the end of the range"), name if by_place else "", says=says)
    under = where_met(given, found.asked)
    data = {"value": value, "name": name, "place": found.place, "best": found.value, "sense": sense}
    said = checked("extreme", **data, given=under, at_end=bool(found.where))
    if found.where and not closed:
        says = f"no {word} value is reached: {told(found.value)} is approached as {name} goes to {_end(found.place)}"
        values = () if by_place else (found.value,)
        symbol_ = name if by_place else ""
        return Finding(symbol=symbol_, **said, values=values, relation="approaches", valid=found.asked, says=says)
    place = (name, found.place)
    if by_place:
        return Finding(symbol=name, **said, values=(found.place,), valid=found.asked, place=place)
    return Finding(**said, values=(found.value,), valid=found.asked, place=place)


def _end(place: Scalar | None) -> str:
    return "infinity" if place is None else told(place)


# --- equal values


def with_equal(world: Scene, first: str, second: str, phrase: str) -> Finding:
    """Two different values of one parameter with the same value of a quantity: the second as a function of the first."""
    parameter(world, first)
    value, given = seen(world, phrase), world.motion.assumptions
    known = {quantity.name for quantity in world.study.problem.parameters}
    if not depends_on(value, first):
        raise StatementError(f"“{phrase}” does not depend on {first}", instead=_instead(world, value))
    if second in known and depends_on(value, second):
        raise StatementError(f"“{phrase}” depends on both {first} and {second}", instead=f"name the other value of {first} anew.")
    given = _like(given, first, second)
    other = substitute(value, {first: symbol(second)})
    table = sign_table(other - value, second, given.with_range(second, *given.range_of(second)))
    zeros = [z for z in table.zeros.found if not z.is_pole and not is_zero(z.place - symbol(first))]
    if not zeros and not table.zeros.open_ and not table.zeros.crossings:
        return Finding(proved("no other value of it gives the same"), second, says=f"only {second} = {first} has the same")
    if not zeros or table.zeros.open_:
        return Finding(undecided("it has no closed form"), second, equation=(table.zeros.open_ or (other - value,))[0])
    gap = neat(other * other - value * value, given)  # both are positive, or zero together
    same = sign(value, given).is_nonnegative
    places = [*(zero.place for zero in zeros), symbol(first)]
    asked = where_met(given, [demand for zero in zeros for demand in zero.asked])
    verdict = verdict_of("vanishes_for", value=gap if same else other - value, name=second, places=places, given=asked)
    return Finding(verdict, second, tuple(neat(z.place, given) for z in zeros), asked=tuple(z.asked for z in zeros))


def _like(given: Assumptions, first: str, second: str) -> Assumptions:
    """The assumptions with a second name of which the same is declared."""
    given = given.with_signs({second: given.sign_of(first)})
    return given.with_range(second, *given.range_of(first)) if first in given.ranges else given
