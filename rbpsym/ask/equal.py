"""For which value of a symbol something vanishes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from rbpsym.ask.finding import NO_SUCH, Finding, checked, kept_said, together
from rbpsym.ask.lasting import lasts_to_place
from rbpsym.ask.question import SUPERLATIVES
from rbpsym.ask.seen import AskedPhase, moving, never_told, parameter, way_to
from rbpsym.ask.wanted import Wanted, case_of, on_what
from rbpsym.ask.zeros import Crossing, Zero, sign_table, where_met
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import neat, rooted
from rbpsym.decide.verdict import undecided
from rbpsym.errors import StatementError
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, substitute
from rbpsym.mechanics.demands import Demand, possible, settle


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
