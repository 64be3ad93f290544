"""Limits that a parameter of the statement comes to: which of two of them comes first as it grows, and how great a quantity gets
before one. The question does not name that parameter."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace

from rbpsym.ask import critical, optima, yesno
from rbpsym.ask.conditions import wanted
from rbpsym.ask.critical import KEPT, region_of
from rbpsym.ask.finding import Finding, checked, together
from rbpsym.ask.question import SUPERLATIVES, read_question
from rbpsym.ask.seen import AskedPhase, moving, never_told, parameter, parts_seen, place_in, scene, seen
from rbpsym.ask.wanted import Wanted, of_contact
from rbpsym.ask.zeros import precedes, settled_sign, where_met
from rbpsym.decide.verdict import undecided
from rbpsym.errors import NotApplicable, RbpsymError, StatementError
from rbpsym.expr.tree import names as symbols
from rbpsym.field import Scalar, depends_on, is_zero
from rbpsym.mechanics.demands import possible
from rbpsym.mechanics.stability import essential
from rbpsym.present.forms import present
from rbpsym.quantities import FORCE, LENGTH
from rbpsym.typeset.machine import to_machine

EVENT = r"(?:begin to |start to |begins to |starts to )?(slip|tip)s?(?: over)?"
ORDER = re.compile(rf"\w+ {EVENT} before \w+ {EVENT}(?: as (\w+) (?:grows|increases))?")


NO_EFFECT = re.compile(r"(.+) (?:does not depend on|is independent of) (\w+)")


def which(world: AskedPhase, superlative: str | None, name: str, text: str) -> Finding:
    """SYMBOL for which a condition is met (see `critical.which`), or one limit comes before another."""
    if same := NO_EFFECT.fullmatch(text):
        return optima.without_effect(world, name, *same.groups())
    if superlative and name not in {*_free(world), *world.coordinates} and _is_quantity(world, name):
        return bounded(world, superlative, name, text)
    first = _first_of_two(world, name, text)
    if first is None:
        return critical.which(world, superlative, name, text)
    return _resting(world, region_of(world, name, first[0], text, SUPERLATIVES.get(superlative or "", 0)), first[1], text)


def _is_quantity(world: AskedPhase, name: str) -> bool:
    with suppress(RbpsymError):
        return bool(parts_seen(world.afresh(), name))
    return False


def comes_first(world: AskedPhase, text: str) -> Finding:
    """Whether one limit comes before another."""
    first = _first_of_two(world, "", text)
    if first is None:
        raise StatementError(f"“{text}” names no two limits", instead="write “it tips before it slips”.")
    return _resting(world, yesno.does(world, text, condition=first[0]), first[1], text)


def _resting(world: AskedPhase, found: Finding, limits: Finding, text: str) -> Finding:
    valid = possible((*found.valid, *limits.valid), world.motion.assumptions, never_told(text))
    says = "; ".join(filter(None, (found.says, limits.says)))
    return replace(found, **together(found, limits), valid=valid, says=says)


def _first_of_two(world: AskedPhase, name: str, text: str) -> tuple[Wanted, Finding] | None:
    """That one limit comes before the other as a load grows, with what finds the two; None for another condition.

    Raises StatementError where no parameter takes it to both, or it depends on which one does.
    """
    said = ORDER.fullmatch(text)
    if said is None or said[1] == said[2]:
        return None
    given, found = world.motion.assumptions, {}
    for load in [said[3]] if said[3] else _free(world, name):
        with suppress(RbpsymError):
            (first, one), (second, other) = (_limit(world, load, f"it {KEPT[kind]}", name) for kind in said.group(1, 2))
            limits = Finding(**together(one, other), valid=(*one.valid, *other.valid))
            found[load] = Wanted((second - first,), given, closed=False), limits
    gaps = {essential(condition.values[0], given) for condition, _ in found.values()}
    if len(gaps) > 1 and (load := _load(world, found)):
        condition, limits = found[load]
        return condition, replace(limits, says=f"as {load} grows")
    if len(gaps) == 1:
        return next(iter(found.values()))
    both = f"no parameter is known whose growth makes it both {said[1]} and {said[2]}"
    what = f"which of both comes first depends on which of {', '.join(found)} grows" if gaps else both
    raise StatementError(what, instead=f"say which: “… {said[1]}s before it {said[2]}s as {next(iter(found), 'P')} grows”.")


def _free(world: AskedPhase, name: str = "") -> list[str]:
    return [quantity.name for quantity in world.study.problem.parameters if quantity.name != name]


def _load(world: AskedPhase, names: Iterable[str]) -> str | None:
    """The only one of them that is an applied force or couple: a book that names none lets that grow."""
    applied = (element for element in world.study.problem.interactions if element.kind in ("couple", "force", "pull"))
    acting = {name for element in applied for node in element.nodes for name in symbols(node)}
    loads = [name for name in names if name in acting and world.dimensions[name] in (FORCE, FORCE * LENGTH)]
    return loads[0] if len(loads) == 1 else None


def _limit(world: AskedPhase, load: str, text: str, name: str = "") -> tuple[Scalar, Finding]:
    """The greatest value of a parameter for which a condition holds, whatever else happens before. Raises StatementError."""
    alone = world.afresh()
    found = region_of(alone, parameter(world, load), replace(wanted(alone, text, name), beside=()), text, 1)
    if len(found.values) != 1 or found.relation != "=":
        raise StatementError(f"there is no largest {load} of that kind")
    return found.values[0], found


def bounded(world: AskedPhase, superlative: str, phrase: str, text: str) -> Finding:
    """The greatest (least) value of a quantity for which a condition holds, where that is the same whichever parameter takes it
    there. Raises StatementError where it depends on that, or none does."""
    found = [*_bounds(world, superlative, phrase, of_contact(world, text))]
    found.sort(key=lambda one: len(one[0].valid))
    if not found:
        raise StatementError(f"no parameter is known that takes “{phrase}” to such a bound",
                             instead=f"ask for that of one parameter: “{superlative} P for which {text}”.")  # fmt: skip
    [(first, _), *others] = found
    names = [name for _, name in found]
    if any(not is_zero(one.values[0] - first.values[0]) for one, _ in others) or depends_on(first.values[0], names[0]):
        if load := _load(world, names):
            return replace(next(one for one, name in found if name == load), place=None, says=f"as {load} grows")
        raise StatementError(f"it depends on which of {', '.join(names)} changes",
                             instead=f"ask for that of one: “{superlative} {names[0]} for which {text}”.")  # fmt: skip
    return replace(first, place=None) if others else first


def _bounds(world: AskedPhase, superlative: str, phrase: str, text: str) -> Iterator[tuple[Finding, str]]:
    """What a quantity is at most where a parameter that changes it meets a condition, for each that bounds it."""
    for name in _free(world):
        with suppress(RbpsymError):
            phrase, value = optima.sized(world.afresh(), phrase)
            region = critical.which(world.afresh(), None, name, text) if depends_on(value, name) else Finding()
            low, high = world.motion.assumptions.range_of(name)
            ends = {"b": region.values, "<": (low, *region.values), ">": (*region.values, high)}.get(region.relation[:1], ())
            if len(ends) != 2 or not region.values:
                continue
            given = world.motion.assumptions.with_range(name, *ends)
            best = optima.of_extreme(value, name, given, SUPERLATIVES[superlative], phrase, closed=True, by_place=False)
            if len(best.values) == 1 and best.relation == "=" and best.place and best.place[1] in region.values:
                yield _resting(world, best, region, text), name


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
