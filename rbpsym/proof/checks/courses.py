"""A motion as a function of the time, integrated anew from the start: what the checks of moments put them into.

A coordinate that an equation with the time ties is checked by this equation itself.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any

from rbpsym.decide.equal import scalars_equal
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import PROVED, Verdict
from rbpsym.elements.events import EVENTS
from rbpsym.elements.kinds import KindParts
from rbpsym.errors import Undecided
from rbpsym.field import NOTHING, PI, Scalar, depends_on, derivative, is_zero, names_in, substitute, symbol, time_derivative
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import angles_apart
from rbpsym.frozen import Frozen
from rbpsym.mechanics.contacts import meeting
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.system import System
from rbpsym.proof.checks.of_steps import weakest
from rbpsym.proof.checks.places import UNSEEN, own_place
from rbpsym.proof.context import Context
from rbpsym.proof.mass import primitive
from rbpsym.statement.model import Element, Phase


def course_of(context: Context, value: Scalar) -> tuple[Scalar, Scalar]:
    """A value whose acceleration is a function of the time t, and its rate, as such functions. Raises Undecided for others."""
    scope = context.study.system.scope
    if not names_in(value) & scope.rates.keys() - {"t"}:  # it is driven
        return value, time_derivative(value, scope)
    rate = time_derivative(value, scope)
    gain = substitute(context.on_motion(time_derivative(rate, scope)), _still(context))
    if names_in(gain) & {*scope.rates, *context.study.system.speeds} - {"t"}:
        raise Undecided("its acceleration is no function of the time")
    speed = _gained(gain) + context.start(rate)
    return _gained(speed) + context.start(value), speed


def _still(context: Context) -> dict[str, Scalar]:
    """Coordinates with their starts, and their speeds, that begin at rest and have no acceleration there, wherever the others
    are: they stay."""
    system = context.study.system
    wanted: dict[str, Scalar] = {}
    for name in context.study.resting:
        if name in system.coordinates and is_zero(context.start(symbol(f"{name}_dot"))):
            wanted |= {name: context.start(symbol(name)), f"{name}_dot": NOTHING}
    gains = (substitute(context.on_motion(symbol(f"{name}_ddot")), wanted) for name in wanted if name in system.coordinates)
    return wanted if all(map(is_zero, gains)) else {}


def moved_to(context: Context, value: Scalar, time: Scalar) -> tuple[Scalar, Scalar]:
    """The value and its rate at a time: as its course says, or as they follow from the coordinates that have one."""
    with suppress(Undecided):
        place, speed = course_of(context, value)
        return at_time(time, place), at_time(time, speed)
    rates = context.study.system.scope.rates
    rate = time_derivative(value, context.study.system.scope)
    known = {name: moved_to(context, symbol(name), time) for name in names_in(value) & rates.keys() if value != symbol(name)}
    if not known:
        raise Undecided("its acceleration is no function of the time")
    places, speeds = ({f"{name}{mark}": pair[k] for name, pair in known.items()} for k, mark in ((0, ""), (1, "_dot")))
    return substitute(value, places), substitute(substitute(rate, speeds), places)


def _gained(rate: Scalar) -> Scalar:
    """What a rate adds up to since t = 0."""
    found = primitive(rate, "t")
    return found - at_time(NOTHING, found)


def at_time(time: Scalar, value: Scalar) -> Scalar:
    """The value of a function of the time then."""
    return substitute(value, {"t": time})


def _unseen(context: Context, phase: Phase) -> Scalar:
    raise Undecided(f"that “{phase.event}” holds is not seen on a second road")


class EventCheck(Frozen):
    """What vanishes at an event: as a function of the time on the motion from the start, and of the place along it."""

    then: Callable[[Context, Phase], Scalar] = _unseen
    there: Callable[[Context, Phase], Scalar] = _unseen


CHECKS: Mapping[str, EventCheck] = KindParts(EVENTS, "check", "CHECK")


def force_there(context: Context, name: str) -> Scalar:
    """An unknown force as a function of the place."""
    return (context.study.reactions_along_motion or {})[name]


def force_then(context: Context, name: str) -> Scalar:
    """An unknown force as a function of the time."""
    return moved_to(context, context.on_motion(symbol(name)), symbol("t"))[0]


def closing(system: System, element: Element) -> Scalar:
    """How far what meets is apart; half the difference of the squares for the ends of a string of a length, and circles."""
    geometry = geometry_of(system)
    if "path" not in element.values:
        return meeting(element, geometry).gap
    first, second = (geometry.where(turn.center) for turn in element["path"])
    return ((second - first).dot(second - first) - scalar(element["length"]) ** 2) / 2


def led_then(context: Context, ending: Any, what: str, name: str, stated: Scalar) -> Verdict:
    """Where drives alone tell all places: these meet all equations at that time, each in its range, in which its equation has no
    other zero; the speed is the rate that they have there."""
    there, value = {**ending.state.places, "t": ending.state.time}, own_place(context, name)
    said = value if what == "place" else time_derivative(value, context.study.system.scope)
    verdicts, open_ = [_same(context, substitute(said, there), stated)], {*context.study.system.coordinates}
    for tie in sorted(context.study.ties, key=lambda tie: len(names_in(tie.value) & open_)):
        new = names_in(tie.value) & open_
        rest = substitute(tie.value, {n: place for n, place in there.items() if n not in new})
        verdicts += [_same(context, substitute(tie.value, there), NOTHING)]
        if not names_in(tie.value) & {*context.study.system.coordinates} - new and _comes_there(context, tie.value, there, *new):
            verdicts += [Verdict(PROVED)]
        else:
            verdicts += [UNSEEN] if len(new) > 1 else [_only_there(context, rest, n, there[n]) for n in new]
        open_ -= new
    return weakest(verdicts)


def _same(context: Context, first: Scalar, second: Scalar) -> Verdict:
    return scalars_equal(first, second, context.assumptions)


def _comes_there(context: Context, tie: Scalar, there: Mapping[str, Scalar], name: str, *more: str) -> bool:
    """Whether a coordinate goes one way from its start to the place: up to that time the tie changes strictly with each of both,
    in senses that take it there."""
    begin, given = context.start(symbol(name)), context.assumptions
    way = sign(there[name] - begin, given).sense
    if more or not way or not is_zero(substitute(tie, {name: begin, "t": NOTHING})):
        return False
    between = given.with_range(name, *((begin, there[name]) if way > 0 else (there[name], begin)))
    between = between.with_range("t", NOTHING, there["t"])
    return -sign(derivative(tie, name), between).sense * sign(derivative(tie, "t"), between).sense == way


def _only_there(context: Context, value: Scalar, name: str, place: Scalar) -> Verdict:
    """The place lies in the declared range; a cos q + b sin q, if it does not vanish throughout, has no other zero within half a
    turn, nor has what is monotone."""
    low, high = context.assumptions.range_of(name)
    slope = derivative(value, name)
    if low is None or high is None:
        return Verdict(PROVED) if (low, high) == (None, None) and not depends_on(slope, name) else UNSEEN
    given, half = context.assumptions, sign(low + PI - high, context.assumptions)
    room = [sign(gap, given) for gap in (place - low, high - place)]
    is_inside = all(gap.is_nonnegative for gap in room)
    is_wave = is_zero(derivative(slope, name) + value) and sign(substitute(angles_apart(slope), {name: place}), given).is_nonzero
    is_alone = half.kind == "positive" or (half.kind == "zero" and all(gap.kind == "positive" for gap in room))
    return Verdict(PROVED) if is_inside and ((is_wave and is_alone) or sign(slope, given).is_nonzero) else UNSEEN
