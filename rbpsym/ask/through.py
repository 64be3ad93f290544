"""The greatest or least value of a quantity on the whole motion: that of the phase in which it is greater than in all others."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from rbpsym.ask import optima
from rbpsym.ask.finding import Finding, checked, together
from rbpsym.ask.question import SUPERLATIVES, read_question
from rbpsym.ask.seen import AskedPhase, moving, never_told, place_in, scene, seen
from rbpsym.ask.zeros import precedes, settled_sign, where_met
from rbpsym.decide.verdict import undecided
from rbpsym.errors import NotApplicable, RbpsymError, StatementError
from rbpsym.field import is_zero
from rbpsym.mechanics.demands import possible
from rbpsym.present.forms import present
from rbpsym.typeset.machine import to_machine


def extremum(
    world: AskedPhase, superlative: str, phrase: str, over: str | None, low: str | None, high: str | None, *,
    by_place: bool = False, until: str | None = None,
) -> Finding:
    """The same as `optima.extremum`, through all phases from the first that does not end at once, if none is named (`until` a
    phase: before that one)."""
    asked = world.asked
    last = len(asked.names) if until is None else asked.named(until)
    world = scene(asked, world.number) if until is not None and world.number + 1 == last else world
    if world.is_named or low is not None or over not in (None, *world.coordinates) or world.number + 1 == last:
        found = optima.extremum(world, superlative, phrase, over, low, high, by_place=by_place)
        is_told = over or low is not None or by_place or not _is_open(found)
        return found if is_told else _over_time(world, superlative, phrase, found)
    parts, every = list[AskedPhase](), list[Finding]()
    for place in _known(world, phrase, last):
        try:
            parts.append(scene(asked, place))
            every.append(_in_phase(parts[-1], superlative, phrase, over))
        except (NotApplicable, StatementError) as error:
            name = asked.names[place]
            what = f"how “{phrase}” goes on in the phase “{name}” is not known: {error.what}" if every else error.what
            instead = f"ask for it in one phase: “… in phase {asked.names[world.number] if world.number else 'first'}”."
            raise StatementError(what, instead=instead if every else error.instead) from None
    without = next((k for k, one in enumerate(every) if len(one.values) != 1), None)
    best = without if without is not None else _beyond_all(world, every, SUPERLATIVES[superlative])
    if best is None:
        return Finding(undecided("in which phase it is depends on the parameters, or is not decided"))
    told = optima.extremum(parts[best], superlative, phrase, over, None, None, by_place=True) if by_place else every[best]
    if without is None:
        one, known = every[best], world.motion.assumptions
        beside = tuple((o.values[0], where_met(known, [*one.valid, *o.valid])) for o in every if o is not one)
        beyond = Finding(**checked("greatest_of", best=one.values[0], others=beside, sense=SUPERLATIVES[superlative]))
        told = replace(told, **together(*((told, beyond) if by_place else (beyond, told))))
    for part in parts:
        world.used.extend(part.used)
    world.lasting.extend(parts[best].lasting)
    world.doubts.extend(parts[best].doubts)
    begun = (d for place in range(world.number + 1, parts[best].number + 1) for d in asked.began(place).before.valid)
    valid = possible((*told.valid, *begun), world.motion.assumptions, never_told(phrase))
    others = (one for k, one in enumerate(every) if k != best)
    return replace(told, **together(told, *others), valid=valid)


def _is_open(found: Finding) -> bool:
    return found.verdict is not None and not found.verdict.is_proved


def _over_time(world: AskedPhase, superlative: str, phrase: str, known: Finding) -> Finding:
    """The same by the motion as a function of the time, if that proves it; else what is known."""
    other = world.afresh()
    with suppress(RbpsymError):
        found = optima.extremum(other, superlative, phrase, "t", None, None)
        if found.values and not _is_open(found):
            world.used[:], world.lasting[:], world.doubts[:] = other.used, other.lasting, other.doubts
            return found
    return known


def until(world: AskedPhase, superlative: str, phrase: str, name: str, text: str) -> Finding:
    """The same on the way from the start to a place, to which the motion comes."""
    end, begin = place_in(world, name, text), world.study.system.scope.start.get(name)
    if begin is None:
        raise StatementError(f"it is not said where “{name}” starts", instead=f"say between which values of {name}.")
    if is_zero(end - begin):
        raise StatementError(f"“{name}” starts there", instead="name a place to which it comes.")
    seen(world, f"{name} where {name} = {text}")
    low, high = (to_machine(present(value)) for value in (begin, end))
    ends = (low, high) if precedes(begin, end, world.motion.assumptions) else (high, low)
    return optima.extremum(world, superlative, phrase, name, *ends)


def extreme_for(world: AskedPhase, name: str | None, phrase: str, superlative: str) -> Finding:
    """SYMBOL for which a quantity is least or greatest."""
    return extremum(world, superlative, phrase, name, None, None, by_place=True)


def _known(world: AskedPhase, phrase: str, last: int) -> list[int]:
    """The phases in which the quantity means something, as a force does where it acts; all of them if it does in none."""
    places, quantity = range(world.number, last), read_question(phrase).quantity
    found = []
    for place in places:
        with suppress(RbpsymError):
            world.asked.world(place).bound(quantity)
            found.append(place)
    return found or [*places]


def _in_phase(part: AskedPhase, superlative: str, phrase: str, over: str | None) -> Finding:
    phrase, value = optima.sized(part, phrase)
    if not moving(part, (value,)) and read_question(phrase).when is None:  # at one moment there is none
        names, given = tuple(part.motion.scope.rates), part.motion.assumptions
        valid = possible(part.standing, given, never_told(phrase))
        return Finding(values=(value,), valid=valid, **checked("no_change", value=value, names=names, best=value, given=given))
    part.used.clear()
    return optima.extremum(part, superlative, phrase, over, None, None)


def _beyond_all(world: AskedPhase, found: list[Finding], sense: int) -> int | None:
    """The first phase whose value no other one exceeds."""
    for k, one in enumerate(found):
        pairs = ((one, other, where_met(world.motion.assumptions, [*one.valid, *other.valid])) for other in found)
        if all(settled_sign((one.values[0] - other.values[0]) * sense, given) in (0, 1) for one, other, given in pairs):
            return k
    return None
