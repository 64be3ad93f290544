"""For which values of a parameter something holds, is least, is greatest or is equal: questions and their answers."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from rbpsym.ask.conditions import wanted
from rbpsym.ask.finding import FOR_EVERY, FOR_NONE, NO_SUCH, Finding, checked, kept_said, together
from rbpsym.ask.question import SUPERLATIVES
from rbpsym.ask.regions import SIDES, Region, alone, binding, by_order, common, equal_for, region_on_way
from rbpsym.ask.seen import AskedPhase, moving, never_told, parameter, seen, told
from rbpsym.ask.wanted import GOES, Wanted, arrives, begins_to_slip, case_of, of_contact, on_what, premises, unsaid
from rbpsym.ask.zeros import where_met
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.rooted import rooted
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import undecided
from rbpsym.errors import StatementError, all_there, there
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, short, substitute
from rbpsym.mechanics.demands import Demand, assuming, possible
from rbpsym.mechanics.numbers import floating, sample
from rbpsym.mechanics.stability import essential

_BEFORE = r"((?: (?:until|before) .+)?)"
OPPOSITE = re.compile(rf"(\w+) (?:begins to |starts to |just )?(slip|leave|lift|tip|move)s?(?: off| over)?{_BEFORE}")
NEVER = re.compile(r"(\w+) (?:(?:does not|never) (?:reach(?:es)?|gets? to|comes? to)|(?:stays|remains) (?:below|above)) (.+)")
STILL = re.compile(r"(\w+) (?:does not|never) (?:begin to |start to )?(?:slip|move)s?")
KEPT = {"slip": "does not slip", "move": "does not move", **dict.fromkeys(("leave", "lift", "tip"), "keeps contact")}
VANISHES = re.compile(rf"(\w+) vanishes{_BEFORE}")
FLIPPED = {">=": "<", ">": "<=", "<=": ">", "<": ">="}


def which(world: AskedPhase, superlative: str | None, name: str, text: str, opposite: str = "") -> Finding:
    """SYMBOL for which a condition is met, or its opposite (as it was asked for); the smallest or largest of them."""
    text = of_contact(world, text)
    turned = OPPOSITE.fullmatch(text)
    slides = begins_to_slip(world, turned[1]) if turned and turned[2] in ("slip", "move") and not turned[3] else None
    if turned and slides is None:
        return _opposite(world, superlative, name, text, f"{turned[1]} {KEPT[turned[2]]}{turned[3]}")
    if (never := NEVER.fullmatch(text)) and (never[1] in world.coordinates or "never" in text or "does" in text):
        return _opposite(world, superlative, name, text, f"{never[1]} reaches {never[2]}")
    if (still := STILL.fullmatch(text)) and begins_to_slip(world, still[1]) is not None:
        return _opposite(world, superlative, name, text, f"{still[1]} slips")
    vanishing = VANISHES.fullmatch(text) if superlative and name not in world.coordinates else None
    if vanishing and vanishing[1] in world.study.system.unknowns and moving(world, (seen(world, vanishing[1]),)):
        return _opposite(world, superlative, name, text, f"{vanishing[1]} stays positive{vanishing[2]}")  # somewhere on the way
    condition = slides or next(filter(None, (find(world, text) for find in GOES)), None) or wanted(world, text, name)
    if condition.equal:
        return equal_for(world, superlative, name, condition, text)
    stated = premises(world, condition)
    own = (demand.value for demand in stated if depends_on(demand.value, name) and demand.op != "!=")
    condition = replace(condition, beside=(*condition.beside, *own))
    found = region_of(world, name, condition, text, SUPERLATIVES.get(superlative or "", 0), opposite)
    if any(depends_on(demand.value, name) for demand in found.valid):
        found = replace(found, verdict=undecided(f"it was found under conditions on {name} itself"))
    whole = () if found.values else [d for d in case_of(world) if not (found.is_none and depends_on(d.value, name))]
    asked = [demand for demand in (*condition.asked, *stated) if not depends_on(demand.value, name)]
    return replace(found, valid=possible((*found.valid, *asked, *whole), world.motion.assumptions, never_told(text)))


def _opposite(world: AskedPhase, superlative: str | None, name: str, text: str, other: str) -> Finding:
    """The same for the opposite of another condition."""
    turned = superlative and ("largest" if SUPERLATIVES[superlative] < 0 else "smallest")
    found = which(world, turned, name, other, text)
    relation = FLIPPED.get(found.relation, found.relation)
    says = f"every such {name} does" if superlative and relation != "=" else ""
    grounds = tuple((rule, {**data, "opposite": True}) for rule, data in found.grounds)
    if f"“{text}”" in found.says:
        return replace(found, relation=relation, grounds=grounds)
    return replace(found, relation=relation, says=says, grounds=grounds) if found.values else found


def region_of(world: AskedPhase, name: str, condition: Wanted, text: str, sense: int, opposite: str = "") -> Finding:
    """For which values of a parameter what is wanted is positive; `sense`: of which bound it is asked; `opposite`: the text of
    what is asked for instead, where that is the contrary."""
    along = condition.along
    world.senses.extend(condition.asked)
    if condition.others and any(depends_on(demand.value, name) for demand in condition.asked):
        return Finding(undecided(f"the sense in which it sets out depends on {name}, and it may come in both"), name)
    own, given, premise = _own_demands(world, name, condition)
    values = (*(demand.value for demand in own), *condition.values)  # the last is the square of a speed, where it is one
    if name in world.coordinates or not any(depends_on(value, name) for value in (*values, *_ends_of(given, along))):
        parameter(world, name)
    free = [other for other in moving(world, values) if other != along]
    if free:
        raise StatementError(f"“{text}” depends on {free[0]} too", instead="say where or until when: “… until theta = VALUE”.")
    if not any(depends_on(value, name) for value in (*(essential(value, given) for value in values), *_ends_of(given, along))):
        return _for_all(world, name, condition, values, given, text)
    under = (*(given for _ in own), *(premise for _ in condition.values))
    regions = [region_on_way(value, name, along or "", each) for value, each in zip(values, under, strict=True)]
    every = [(value, region_on_way(value, name, along or "", premise)) for value in condition.beside]
    pairs = [(value, one) for value, one in every if one is not None]
    if len(pairs) < len(every):
        world.doubts.append("whether the contacts and the friction last so far is not decided")
    beside = [one for _, one in pairs]
    found = _first(regions, beside, given, sense)
    if found is None:
        case = _case(world, name, (*values, *condition.beside), premise)
        return _under(case, world, name, condition, text, sense, opposite)
    parts = (*values, *(value for value, _ in pairs)), [*regions, *beside]
    if found.cases:
        return _in_cases(name, found, parts, given, along, sense)
    if not found.is_empty and (sense or None in (found.lower, found.upper)):
        found = replace(found, asked=alone(found, parts[1], given, sense or (-1 if found.upper is None else 1)))
    if opposite and not found.is_empty and not found.is_whole:
        bounds = [end for end in (found.lower, found.upper) if end is not None]
        bounds = [end for end in bounds if sense and end == getattr(found, SIDES[sense])] or bounds
        if bounds and not any(end in bounds for one in regions[len(own) :] if one for end in (one.lower, one.upper)):
            return _never(name, condition, regions[len(own) :], found, premise, opposite)
        if len(bounds) > 1:
            return Finding(undecided("it is the contrary of what holds between two bounds"), name)
    said = _said(parts, name, found, given, along, sense)
    told_ = _told(name, found, replace(condition, given=given, asked=tuple(own)), text, sense, said)
    told_ = _otherwise(told_, name, found, parts, given, along, text)
    ends = {end for one in regions if one for end in (one.lower, one.upper)}
    if opposite and sense:
        told_ = _beyond(told_, name, zip(values, regions, strict=True), given, (along, opposite, sense))
    return _stopped(told_, name, condition, pairs, ends, given)


def _beyond(
    told_: Finding, name: str, pairs: Iterable[tuple[Scalar, Region | None]], given: Assumptions, of: tuple[str | None, str, int]
) -> Finding:
    """With where else the contrary of what is wanted holds, beyond a bound on the side that is not asked for."""
    along, opposite, sense = of
    for value, one in pairs:
        if told_.values and one is not None and (end := getattr(one, SIDES[-sense])) is not None:
            part = given.with_range(name, *((None, end) if sense > 0 else (end, None)))
            fails = Finding(**kept_said((value,), along, one.worst, part, holds=False))
            says = f"“{opposite}” holds for {name} {'<' if sense > 0 else '>'} {told(end)}, too"
            told_ = replace(told_, says="; ".join(filter(None, (told_.says, says))), **together(told_, fails))
    return told_


def _case(world: AskedPhase, name: str, values: Sequence[Scalar], given: Assumptions) -> list[Demand]:
    """On which side what is linear in the symbol is bounded, where other parameters tell: the case that the numbers are in."""
    problem, found = world.study.problem, list[Demand]()
    slopes = dict.fromkeys(short(derivative(value, name)) for value in values)
    for slope in (one for one in slopes if one and not depends_on(one, name) and not moving(world, (one,))):
        if not sign(slope, given).sense:
            slope = essential(slope, given)
            way = 1 if floating(slope, sample(problem, problem.example)) > 0 else -1
            found.append(Demand(slope * way))
    return list(dict.fromkeys(found))


def _under(case: list[Demand], world: AskedPhase, name: str, condition: Wanted, text: str, sense: int, opposite: str) -> Finding:
    """What is found in a case, with its conditions."""
    if not case:
        return Finding(undecided("for which values it holds is not decided: a sign on the way is open"), name)
    told_ = region_of(world, name, replace(condition, asked=(*condition.asked, *case)), text, sense, opposite)
    return replace(told_, valid=(*told_.valid, *case))


def _never(
    name: str, condition: Wanted, regions: Sequence[Region | None], found: Region, given: Assumptions, text: str
) -> Finding:
    """That there is no value for which the contrary of what is wanted holds: the motion ceases to be the stated one before."""
    given = where_met(found.within(name, given), found.asked)
    parts = zip(condition.values, regions, strict=True)
    said = [kept_said([value], condition.along, one.worst if one else (), given, holds=True) for value, one in parts]
    says = f"{NO_SUCH} {name}: “{text}” holds for none in its range"
    own = [demand for demand in condition.asked if depends_on(demand.value, name)]
    return Finding(symbol=name, says=says, valid=(*found.asked, *own), **together(*(Finding(**one) for one in said)))


def _own_demands(world: AskedPhase, name: str, condition: Wanted) -> tuple[list[Demand], Assumptions, Assumptions]:
    """What is asked of the symbol itself, what is known without that, and with it: it is a premise of the rest only."""
    asked = [*condition.asked, *unsaid((demand for demand in world.demands if demand.op != "!="), condition, name)]
    own, firm = ([demand for demand in asked if depends_on(demand.value, name) is is_own] for is_own in (True, False))
    given = premise = where_met(assuming(condition.given, firm, tighter=True, whole=True), own)
    if own:
        within = {condition.along: given.range_of(condition.along)} if condition.along else {}
        given = replace(condition.given, ranges={**world.motion.assumptions.ranges, **within})
        given = assuming(given, firm, tighter=True, whole=True)
    return own, given, premise


def _for_all(
    world: AskedPhase, name: str, condition: Wanted, values: tuple[Scalar, ...], given: Assumptions, text: str
) -> Finding:
    """What holds for all values, or none, since it does not depend on the symbol. Raises StatementError where it depends on
    others which of both."""
    known = common([region_on_way(value, name, condition.along or "", given) for value in values], given)
    if known is None or known.asked:
        raise StatementError(f"“{text}” does not depend on {name}", instead=on_what(world, essential(values[0], given)))
    says = f"“{text}” {FOR_NONE if known.is_empty else FOR_EVERY} of the parameters in their declared ranges"
    said = kept_said(values, condition.along, known.worst, given, holds=not known.is_empty)
    return Finding(**said, symbol=name, says=says, steps=condition.steps)


def _otherwise(
    told_: Finding, name: str, found: Region, parts: Parts, given: Assumptions, along: str | None, text: str
) -> Finding:
    """With what holds where the conditions of a bound are not met, as far as it is proved."""
    if told_.relation == "between" and not told_.says and found.asked:
        ends = (("<", found.upper, 1), (">", found.lower, -1))
        free = (end for end in ends if end[1] is not None and not alone(found, parts[1], given, end[2]))
        bare = next(((text, op, end) for op, end, _ in free if end is not None), None)
        told_ = _else(told_, name, found, parts, given, along, bare) if bare else told_
    if found.otherwise and told_.says:
        turned = Demand(-found.asked[0].value, ">=" if found.asked[0].op == ">" else ">")
        else_ = kept_said(parts[0], along, found.worst, where_met(given, [turned]), holds=found.otherwise > 0)
        told_ = replace(told_, **together(told_, Finding(**else_)))
    return told_


def _stopped(
    told_: Finding,
    name: str,
    condition: Wanted,
    pairs: Sequence[tuple[Scalar, Region]],
    ends: set[Scalar | None],
    given: Assumptions,
) -> Finding:
    """With what is said where the motion ceases to be the stated one at a bound that is none of the condition itself."""
    for value, one in pairs:
        worst = next(iter(one.worst), None)
        along = {condition.along: worst} if condition.along and worst is not None else {}
        for bound in (bound for bound in told_.values if bound in (one.lower, one.upper) and bound not in ends):
            zero = substitute(value, {name: bound, **along})
            vanishes = checked("no_change", value=zero, names=(), best=NOTHING, given=given)
            return replace(told_, says=condition.there, **together(told_, Finding(**vanishes)))
    return told_


def _else(
    told_: Finding, name: str, found: Region, parts: Parts, given: Assumptions, along: str | None, bare: tuple[str, str, Scalar]
) -> Finding:
    """With what holds where a condition is not met, if that is proved: the bound that is left alone then."""
    text, op, end = bare
    turned = (Demand(-demand.value, ">=" if demand.op == ">" else ">") for demand in found.asked)
    half = replace(found, lower=end if op == ">" else None, upper=None if op == ">" else end)
    said = [Finding(**_said(parts, name, replace(half, asked=(one,)), given, along)) for one in turned]
    if not all(there(one.verdict).is_proved for one in said):
        return told_
    return replace(told_, says=f"else “{text}” holds for {name} {op} {told(end)}", **together(told_, *said))


def _first(regions: list[Region | None], beside: list[Region], given: Assumptions, sense: int) -> Region | None:
    """Where all hold; in cases by the regions' own bounds where their order is open, or others would come first."""
    found = common([*regions, *beside], given)
    ends = {way: [getattr(one, side) for one in regions if one and getattr(one, side) is not None] for way, side in SIDES.items()}
    ways = [sense] if sense else [way for way in ends if ends[way]]
    end = getattr(found, SIDES[ways[0]], None) if len(ways) == 1 else None
    if len(ways) != 1 or (found is not None and (end is None or end in ends[ways[0]])):
        return found
    return by_order(regions, beside, given, ways[0]) or found


def _ends_of(given: Assumptions, along: str | None) -> list[Scalar]:
    return [end for end in (given.range_of(along) if along else ()) if end is not None]


Parts = tuple[tuple[Scalar, ...], list[Region | None]]  # values and where each of them holds


def _said(parts: Parts, name: str, found: Region, given: Assumptions, along: str | None, sense: int = 0) -> dict[str, Any]:
    side = sense or (1 if found.lower is None else -1 if found.upper is None else 0)
    values = binding(*parts, found, given, side)
    given = assuming(given, found.asked, tighter=True, whole=True)
    if found.crossing:
        return checked("one_zero", equation=found.crossing.equation, name=name, given=given, value=None)
    if found.is_empty and None not in (found.lower, found.upper):
        beyond = checked("greatest_of", best=found.lower, others=((found.upper, given),), sense=1)
        parts_ = (given.with_range(name, *ends) for ends in ((None, found.lower), (found.upper, None)))
        fails = (kept_said(parts[0], along, found.worst, part, holds=False) for part in parts_)
        return together(*(Finding(**said) for said in (beyond, *fails)))
    if found.is_empty or found.is_whole:
        return kept_said(parts[0], along, found.worst, given, holds=not found.is_empty)
    sense = 0 if (found.lower if sense < 0 else found.upper) is None else sense
    ends, way = {1: found.lower, -1: found.upper}, (along, found.worst)
    return checked("holds_for", values=values, name=name, ends=ends, way=way, given=given, sense=sense)


def _in_cases(name: str, found: Region, parts: Parts, given: Assumptions, along: str | None, sense: int) -> Finding:
    """The bounds, each under its condition."""
    bounds = all_there(case.lower if case.upper is None else case.upper for case in found.cases)
    lower = [case.upper is None for case in found.cases]
    if bounds is None or len(set(lower)) > 1 or (sense and lower[0] != (sense < 0)):
        return Finding(undecided("the bounds depend on the parameters in more than one way"), name)
    said = together(*(Finding(**_said(parts, name, case, given, along)) for case in found.cases))
    relation = "=" if sense else ">=" if lower[0] else "<="
    asked = tuple(case.asked for case in found.cases)
    return Finding(**said, symbol=name, values=tuple(bounds), relation=relation, asked=asked)


def _told(name: str, found: Region, condition: Wanted, text: str, sense: int, said: dict[str, Any]) -> Finding:
    if found.is_empty:
        says = f"{NO_SUCH} {name}: “{text}” holds for none in its range"
        return Finding(symbol=name, **said, valid=found.asked, says=says)
    if found.is_whole:
        return Finding(symbol=name, **said, valid=found.asked, says=f"“{text}” holds for every {name} in its range")
    if found.crossing is not None:
        relation = ">" if found.crossing.sense > 0 else "<"
        return Finding(symbol=name, **said, relation=relation, equation=found.crossing.equation)
    ends = (found.lower, found.upper)
    bound = there(ends[0] if ends[1] is None or (sense < 0 and ends[0] is not None) else ends[1])
    closed, says, why = _closed(condition, found, name, bound)
    said = together(Finding(**said), why) if says and (sense or None in ends) else said
    says = says if says and (sense or None in ends) else OTHERWISE[found.otherwise].format(text=text, name=name)
    if sense:
        if (found.lower if sense < 0 else found.upper) is None:
            word, op = ("smaller", "<") if sense < 0 else ("larger", ">")
            says = f"every {word} {name} does: it holds for {name} {op} {told(bound)}"
            return Finding(symbol=name, **said, values=(bound,), relation=op, valid=found.asked, says=says)
        return Finding(symbol=name, **said, values=(bound,), valid=found.asked, says=says)
    if (both := all_there(ends)) is not None:
        return Finding(symbol=name, **said, values=tuple(both), relation="between", valid=found.asked, says=says)
    relation = (">" if found.upper is None else "<") + ("=" if closed else "")
    return Finding(symbol=name, **said, values=(bound,), relation=relation, valid=found.asked, says=says)


def _closed(condition: Wanted, found: Region, name: str, bound: Scalar) -> tuple[bool, str, Finding]:
    """Whether it still holds at the bound; the sentence where it is proved that it does not, with what proves it."""
    along, given, [*places] = condition.along, condition.given, found.worst or (None,)
    edge = [one.value for one in condition.asked if one.op == ">"]
    ends = [rooted(substitute(value, {name: bound}), given) for value in edge]
    if not condition.closed or any(map(is_zero, ends)):
        at = [{name: bound} | ({along: place} if along and place is not None else {}) for place in places]
        open_ = () if condition.closed else condition.values
        ends += [rooted(substitute(value, one), given) for value in open_ for one in at]
        zero = next(filter(is_zero, ends), None)
        why = Finding(**checked("no_change", value=zero or NOTHING, names=(), best=NOTHING, given=given))
        return False, "" if zero is None else f"at this {name} itself it does not hold", why
    [place, *_] = places
    if condition.end is None or along is None or place is None or None in places:
        return True, "", Finding()
    square = substitute(condition.values[-1], {name: bound})
    if arrives(condition, place, {name: bound}) or not is_zero(rooted(substitute(square, {along: place}), given)):
        return True, "", Finding()
    why = Finding(**checked("approached", value=square, name=along, place=place, given=given))
    return False, f"with this {name} itself, {along} = {told(place)} is approached and never reached", why


OTHERWISE = {0: "", 1: "else “{text}” holds for every {name}", -1: "else there is no such {name}"}
