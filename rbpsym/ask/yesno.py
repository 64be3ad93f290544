"""Questions that are answered by yes or no, with the condition where it depends on the parameters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from rbpsym.ask.conditions import of_chapter, rest_at, wanted
from rbpsym.ask.extremes import Extreme, least
from rbpsym.ask.finding import Finding, checked, kept_said
from rbpsym.ask.seen import AskedPhase, moving, never_told, way_to
from rbpsym.ask.wanted import Wanted, arrives, free_place, lasting_premises, on_way, premises
from rbpsym.ask.zeros import sign_at_end, where_met
from rbpsym.chapters import contact, oscillations
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.verdict import undecided
from rbpsym.errors import StatementError, Undecided
from rbpsym.field import UNITY, Scalar, depends_on, is_zero
from rbpsym.mechanics.demands import Demand, possible, settle
from rbpsym.mechanics.events import Loss
from rbpsym.mechanics.pushing import begins
from rbpsym.proof.step import Step


def does(world: AskedPhase, text: str, *, opposite: bool = False, condition: Wanted | None = None) -> Finding:
    """Whether a condition is met on the motion: yes, no, or under which conditions on the parameters."""
    condition = condition or wanted(world, text)
    if condition.equal:
        raise StatementError(f"“{text}” is no condition of a whole motion", instead="ask “where …”, or “does … depend on …”.")
    if condition.along is None and moving(world, condition.values) and not _always(condition):
        condition = on_way(world, condition.values, text, None, None, condition.given)
    if opposite and not condition.comes:
        return Finding(undecided("whether the motion comes so far depends on the parameters"))
    try:
        parts = [*_least(condition, world.demands)]
        demands = [demand for *_, demand in parts]
        still = (Demand(value, ">=") for value in condition.beside if not moving(world, (value,)))
        asked = (*condition.asked, *still, *premises(world, condition))
        surely = possible(asked, world.motion.assumptions, never_told(text))
    except Undecided as error:
        return Finding(undecided(error.what))
    left = settle(demands, condition.given)
    if left is None and len(demands) > 1 and not any(settle([demand], condition.given) is None for demand in demands):
        return Finding(undecided("the conditions exclude each other, as it seems"))
    if left is None or not left:
        holds = (left is not None) != opposite
        said = _said(parts, condition, holds=left is not None, opposite=opposite)
        return Finding(**said, says="yes" if holds else "no", holds=holds, valid=surely)
    says = "no where this is met, else yes" if opposite else "yes where this is met, else no"
    if surely or settle(lasting_premises(world), world.motion.assumptions):  # beyond them is no motion of which something is else
        says = says.partition(",")[0]
    both = settle((*surely, *left), world.motion.assumptions)
    if both is None:
        return Finding(undecided("the conditions exclude each other, as it seems"))
    return Finding(**_said(parts, condition, holds=None, opposite=opposite), valid=both, says=says)


def _said(parts: Sequence[Part], condition: Wanted, *, holds: bool | None, opposite: bool) -> dict[str, Any]:
    """What is said of the least values on the way, checked."""
    told = tuple((value, low and low.place, value if low is None else low.value) for value, low, _ in parts)
    turns = {value: tuple(zero.place for zero in low.table.zeros.found) for value, low, _ in parts if low and low.table}
    given = where_met(condition.given, condition.asked)
    data = {"parts": told, "along": condition.along, "given": given, "holds": holds, "opposite": opposite, "turns": turns}
    return checked("least_on_way", **data)


def does_not(world: AskedPhase, text: str) -> Finding:
    """The same of what is the opposite of a condition: whether it slips, leaves, vanishes."""
    return does(world, text, opposite=True)


def vanishes(world: AskedPhase, force: str, until: str | None, text: str | None) -> Finding:
    """Whether a one-sided force vanishes on the motion, by what is known of the ends of contacts; before a place: by its
    least value on the way."""
    losses = [loss for loss in world.study.ended.found if loss.force == force and loss.at]
    if losses and (found := _by_loss(world, losses, until, text)) is not None:
        return found
    side = next((side for side in world.study.sides if side.force == force), None)
    if side is not None and side.state == "kept" and not side.until:
        return Finding(says="no", holds=False, steps=of_chapter(world, contact.write, f"holds.{force}"))
    rest = f" until {until} = {text}" if until else ""
    kept = f"{force} stays positive{rest}"
    return does(world, kept, opposite=True, condition=replace(wanted(world, kept), closed=False))


def _by_loss(world: AskedPhase, losses: Sequence[Loss], until: str | None, text: str | None) -> Finding | None:
    """Whether a force vanishes before a place, by where it is known to vanish; None if that does not say it."""
    [loss, *more], given, surely = losses, world.motion.assumptions, tuple[Demand, ...]()
    [(name, place)] = loss.at.items()
    way, _ = way_to(world, name, place, given)
    asked, is_all = [*loss.valid, *way.asked], bool(world.study.ended.complete and not more)
    if until is not None and text is not None:
        name_, end = free_place(world, until, text)
        if name_ != name:
            raise StatementError(f"“{loss.force}” is a function of {name}", instead=f"say until when: “… until {name} = VALUE”.")
        surely = possible(way_to(world, name, end, given)[0].asked, given, never_told(f"{until} = {text}"))
        before = Demand((end - place) * way.sense, ">=")
        if (left := settle([before], given)) is None:
            return None
        plain = [one.value for one in left]
        later = kept_said(plain, None, (), where_met(given, asked), holds=False)
        if is_all and plain and later["verdict"].is_proved:
            return Finding(**later, valid=surely, says="no", holds=False)
        asked.append(before)
    left = settle(asked, where_met(given, surely))
    if left is None:
        return None
    is_all = is_all and not surely and not begins(world.study)  # what begins otherwise has lost it at once
    says = "yes" if not left else "yes where this is met, else no" if is_all else "yes where this is met"
    steps = _told(of_chapter(world, contact.write, f"loss.{loss.force}"), open=bool(left))
    return Finding(valid=(*surely, *left), place=(name, place), says=says, holds=None if left else True, steps=steps)


def rests_stably(world: AskedPhase, name: str, text: str, opposite: str | None) -> Finding:
    """Whether a place of rest is stable: by the step that says so, else by what has to be positive there."""
    place, item = rest_at(world, name, text)
    if item.stable is None:
        return does(world, f"{name} = {text} is {opposite or ''}stable")
    steps, holds = of_chapter(world, oscillations.write, f"equilibrium.{place}"), item.stable != bool(opposite)
    steps = _told(steps, opposite=bool(opposite))
    return Finding(valid=item.valid, says="yes" if holds else "no", holds=holds, steps=steps)


def _told(steps: tuple[Step, ...], **more: bool) -> tuple[Step, ...]:
    """The steps, the last of which knows how it was asked for."""
    return (*steps[:-1], replace(steps[-1], data={**steps[-1].data, **more}))


Part = tuple[Scalar, Extreme | None, Demand]  # a value, one of its least ones, and what has to hold there


def least_values(condition: Wanted, demands: Sequence[Demand] = ()) -> Iterator[Demand]:
    """What has to hold of the parameters, where the demands are met: each least value on the way is positive."""
    return (demand for *_, demand in _least(condition, demands))


def _least(condition: Wanted, demands: Sequence[Demand]) -> Iterator[Part]:
    op = ">=" if condition.closed else ">"
    given = where_met(condition.given, (*condition.asked, *demands))
    for value in condition.values:
        if condition.along is None or not depends_on(value, condition.along):
            yield value, None, Demand(value, op)
            continue
        ends = [sign_at_end(value, condition.along, given, upper) for upper in (False, True)]
        if -1 in ends:
            limits = of_symbol(condition.along, given)
            yield value, Extreme((limits.lower, limits.upper)[ends.index(-1)], None), Demand(-UNITY)
            continue
        found = least(value, condition.along, given, lambda low: not low.asked)  # whatever the parameters are
        if found is None or not found[1]:
            raise Undecided("where it is least on the way is not decided")
        one, lows = found
        told = (">=" if value is not condition.values[-1] or arrives(condition, low.place) else ">" for low in lows)
        strict = condition.end is not None and op == ">="
        yield from ((one, low, _of_low(low, way if strict else op)) for low, way in zip(lows, told, strict=True))


def _always(condition: Wanted) -> bool:
    """Whether it is met in every state."""
    return settle([Demand(value, ">=" if condition.closed else ">") for value in condition.values], condition.given) == ()


def _of_low(low: Extreme, op: str) -> Demand:
    if low.value is None:
        return Demand(-UNITY)
    if low.where and is_zero(low.value) and low.beside:
        return Demand(UNITY * low.beside)
    return Demand(low.value, op)
