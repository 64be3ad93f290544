"""Special values and limits of quantities, and on what they depend."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from rbpsym.ask.answer import found_of
from rbpsym.ask.asked import Asked
from rbpsym.ask.finding import Finding, checked, together
from rbpsym.ask.lasting import asks
from rbpsym.ask.limits import SMALL, Leading, leading, squeezed
from rbpsym.ask.seen import AskedPhase, parameter, parts_seen, place_in, require_same, told
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.equal import find_witness
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import all_of, undecided
from rbpsym.errors import ReadError, StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import ZERO, Node, Sym
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, root, substitute, symbol
from rbpsym.mechanics.demands import Demand, possible
from rbpsym.mechanics.impulse import is_holding
from rbpsym.present.forms import present
from rbpsym.quantities import NUMBER, Quantity
from rbpsym.statement.model import Element, Problem
from rbpsym.statement.solids import put_into
from rbpsym.statement.source import did_you_mean

PAIR = re.compile(r"(\w+) ?= ?(.+)")
FAR = ("oo", "inf", "infinity", "∞")


# --- special values


def with_values(world: AskedPhase, phrase: str, text: str) -> Finding:
    """A quantity with values of parameters put in: “c = 2/5 and mu = 0”."""
    pairs, parts, given = _pairs(world, text), parts_seen(world, phrase), world.motion.assumptions
    idle = [name for name in pairs if not any(depends_on(part, name) for part in parts)]
    if idle:
        raise StatementError(f"“{phrase}” does not depend on {idle[0]}", instead="leave it out.")
    image = {name: place_in(world, name, to) for name, to in pairs.items()}
    try:
        never = StatementError("with these values the motion never comes there", instead="choose other values.")
        demands = [Demand(neat(substitute(d.value, image), given), d.op) for d in (*world.demands, *world.standing)]
        valid = possible(demands, given, never)
        values = tuple(neat(substitute(part, image), given) for part in parts)
        grounds = tuple(("put_in", {"value": part, "image": image}) for part in parts)
        return Finding(values=values, valid=valid, met=True, grounds=grounds, parted=True)
    except ZeroDivisionError:
        instead = f"ask for “{phrase} in the limit {next(iter(image))} -> …”."
        raise StatementError(f"“{phrase}” has no value there: a denominator vanishes", instead=instead) from None


def _pairs(world: AskedPhase, text: str) -> dict[str, str]:
    """The values by the names of parameters. Raises ReadError."""
    pairs: dict[str, str] = {}
    for part in re.split(r",\s*(?:and )?|\s+and\s+", text):
        pair = PAIR.fullmatch(part)
        if pair is None:
            raise ReadError(f"“{part}” gives no value to a parameter", instead="write “with NAME = VALUE, NAME = VALUE”.")
        pairs[_constant(world, pair[1])] = pair[2]
    return pairs


def special_problem(world: AskedPhase, text: str) -> Problem:
    """The problem in which parameters have these values from the beginning. Raises ReadError or StatementError."""
    pairs = _pairs(world, text)
    for name, to in pairs.items():
        place_in(world, name, to)
    return _with(world.asked.problem, {name: read_infix(to, world.names) for name, to in pairs.items()})


COEFFICIENT = "mu"


def with_coefficient(asked: Asked, text: str) -> Asked:
    """For a question about the coefficient mu, of which the problem says nothing: asked of the problem in which all that holds
    by as much friction as is needed has it as its limit."""
    problem = asked.problem
    is_said = re.search(rf"\b(?:{COEFFICIENT}|coefficient of (?:static )?friction)\b", text)
    held = (*problem.constraints, *(e for phase in problem.phases for e in (*phase.problem.constraints, *phase.impulses)))
    if not is_said or put_into(problem, {COEFFICIENT: ZERO}) != put_into(problem, {}) or all(_limited(e) == e for e in held):
        return asked

    def rough(part: Problem) -> Problem:
        return replace(part, parameters=known, constraints=tuple(map(_limited, part.constraints)))

    others = tuple(one for one in problem.parameters if one.name != COEFFICIENT)
    known = (*others, Quantity(COEFFICIENT, NUMBER, "coefficient of friction"))
    phases = (replace(p, problem=rough(p.problem), impulses=tuple(map(_limited, p.impulses))) for p in problem.phases)
    return Asked(replace(rough(problem), phases=tuple(phases)))


def _limited(element: Element) -> Element:
    key = "coefficient" if is_holding(element) else "limit"
    is_open = key in element.values and element.values[key] is None
    return element.with_values(**{key: Sym(COEFFICIENT)}) if is_open else element


def _with(problem: Problem, image: Mapping[str, Node]) -> Problem:
    found: Problem = put_into(problem, image)
    return replace(found, parameters=tuple(quantity for quantity in found.parameters if quantity.name not in image))


def left_open(world: AskedPhase, found: Finding) -> tuple[list[Demand], list[str]]:
    """What is not decided of the moments of a scene: for all parameters, or where one has the values that were found, with
    what they ask for there. Raises StatementError where the motion that is stated surely ends before."""
    problem, asked = world.asked.problem, list[Demand]()
    if not world.doubts or found.relation != "=" or found.symbol not in {one.name for one in problem.parameters}:
        return [], world.doubts
    for value in found.values:
        there = Asked(_with(problem, {found.symbol: present(value)}))
        for question, _ in world.used:
            demands, doubts = asks(there, found_of(there, question))
            if doubts:
                return [], [*doubts]
            asked += demands
    return asked, [] if found.values else world.doubts


def _constant(world: AskedPhase, name: str) -> str:
    """A name that has one value throughout: a parameter, or a start."""
    return name if name in world.motion.starts else parameter(world, name)


# --- limits


def in_limit(world: AskedPhase, phrase: str, name: str, text: str, *, as_term: bool = False) -> Finding:
    """A quantity in the limit NAME -> VALUE; near it, its leading term (`as_term`)."""
    return _limits(world, phrase, _constant(world, name), text, parts_seen(world, phrase), as_term=as_term)


def limit_of(world: AskedPhase, found: Finding, phrase: str, name: str, text: str) -> Finding:
    """What was found for a question, in such a limit. Raises StatementError where that is no single value."""
    if len(found.values) != 1 or (found.verdict and not found.verdict.is_proved):
        raise StatementError(f"“{phrase}” has no single value of which a limit could be taken", instead="ask for that alone.")
    asked, world.doubts[:] = left_open(world, found)
    world.standing.extend((*asked, *found.valid, *(demand for demands in found.asked for demand in demands)))
    limit = _limits(world, phrase, _constant(world, name), text, found.values)
    verdict = all_of(one.verdict for one in (limit, found) if one.verdict)
    return replace(limit, verdict=verdict, grounds=(*limit.grounds, *found.grounds))


def _limits(world: AskedPhase, phrase: str, name: str, text: str, parts: Sequence[Scalar], *, as_term: bool = False) -> Finding:
    given = world.motion.assumptions
    sign_, plain = (-1, text[1:]) if text.startswith("-") else (1, text.removeprefix("+"))
    to = None if plain in FAR else place_in(world, name, text)
    limits = of_symbol(name, given)
    at_top = to is not None and limits.upper is not None and is_zero(to - limits.upper)
    side = -1 if at_top else sign_
    _require_room(parts, name, to, given, side)
    found = [_limit(part, name, to, side, given, phrase, as_term=as_term) for part in parts]
    return _near(world, _together(found, phrase), name, to, side)


def _require_room(parts: Sequence[Scalar], name: str, to: Scalar | None, given: Assumptions, side: int = 1) -> None:
    if other := next(filter(None, (squeezed(part, name, to, given, side) for part in parts)), None):
        raise StatementError(f"in this limit no value in its declared range is left to “{other}”",
                             instead=f"declare another range for {other}, or say “with {other} = …”.")  # fmt: skip


def _together(found: Sequence[Finding], phrase: str) -> Finding:
    """What is found of the components as one finding. Raises StatementError where one of them has no limit but 0."""
    if len(found) == 1:
        return found[0]
    if any(one.relation != "=" or not one.values for one in found):
        raise StatementError(f"the components of “{phrase}” have no limits of one kind", instead="name a component.")
    return Finding(**together(*found), values=tuple(value for one in found for value in one.values), parted=True)


def _near(world: AskedPhase, found: Finding, name: str, to: Scalar | None, side: int = 1) -> Finding:
    """With what the quantity asks for, near the limit."""
    given, demands = world.motion.assumptions, (*world.demands, *world.standing)
    near = ((demand, leading(demand.value, name, to, given, side)) for demand in demands)
    asked = [Demand(demand.value if term is None else term.coefficient, demand.op) for demand, term in near]
    never = StatementError("near this limit the motion never comes about as it is stated", instead="choose another limit.")
    return replace(found, valid=possible(asked, given, never), met=True)


def near(world: AskedPhase, phrase: str, name: str, text: str) -> Finding:
    """The leading term of a quantity near that limit."""
    return in_limit(world, phrase, name, text, as_term=True)


def _limit(value: Scalar, name: str, to: Scalar | None, side: int, given: Assumptions, phrase: str, *, as_term: bool) -> Finding:
    found = leading(value, name, to, given, side)
    if not depends_on(value, name):
        same = checked("no_change", value=value, names=(name,), best=value, given=given)
        return Finding(values=(value,), **same, says=f"“{phrase}” does not depend on {name}")
    if found is None and is_zero(value):
        return _nothing(value, name, given)
    if found is None:
        return Finding(undecided("no leading term of its power series was found"))
    term = _term(found, name, to, side)
    said = limit_said(found, name, given)
    if found.order < 0:
        says = f"“{phrase}” grows beyond all bounds, as this"
        return Finding(**said, values=(neat(term, given),), relation="approaches", says=says)
    if found.order > 0:
        if not as_term:
            return Finding(**said, values=(NOTHING,), says=f"“{phrase}” vanishes as {told(neat(term, given))}")
        says = f"the limit is 0; “{phrase}” vanishes as this"
        return Finding(**said, values=(neat(term, given),), relation="approaches", says=says)
    return Finding(**said, values=(neat(found.coefficient, given),))


def limit_said(found: Leading, name: str, given: Assumptions) -> dict[str, Any]:
    """A leading term, checked."""
    data = {"value": found.image, "name": SMALL, "order": int(found.order * found.power), "coefficient": found.coefficient}
    return checked("limit", **data, there={name: found.there}, given=given.with_signs({SMALL: "positive"}))


def _term(found: Leading, name: str, to: Scalar | None, side: int) -> Scalar:
    """The leading term as a function of the quantity."""
    distance = 1 / (symbol(name) * side) if to is None else (symbol(name) - to) * side
    power = found.order
    if power.denominator == 1:
        return found.coefficient * distance ** int(power)
    return found.coefficient * root(distance) ** int(power * 2)


def much(world: AskedPhase, phrase: str, first: str, way: str, second: str) -> Finding:
    """A quantity for M >> m: the leading term for m → 0 (for M → ∞ if m does not occur), all else being fixed."""
    great, small = (first, second) if way == ">>" else (second, first)
    parts, given = parts_seen(world, phrase), world.motion.assumptions
    for name in (great, small):
        parameter(world, name)
    require_same(world, symbol(great), symbol(small), (great, small))
    both = [name for name in (great, small) if any(depends_on(part, name) for part in parts)]
    if not both:
        raise StatementError(f"“{phrase}” depends on neither {great} nor {small}", instead="leave the limit out.")
    name, to = (small, NOTHING) if small in both else (great, None)
    _require_room(parts, name, to, given)
    found = []
    for part in parts:
        term = leading(part, name, to, given)
        if term is None and not is_zero(part):
            return Finding(undecided("no leading term of its power series was found"))
        if term is None:
            found.append(_nothing(part, name, given))
        else:
            found.append(Finding(**limit_said(term, name, given), values=(neat(_term(term, name, to, 1), given),)))
    return _near(world, _together(found, phrase), name, to)


def _nothing(value: Scalar, name: str, given: Assumptions) -> Finding:
    return Finding(values=(NOTHING,), **checked("no_change", value=value, names=(name,), best=NOTHING, given=given))


# --- dependence


def depends(world: AskedPhase, phrase: str, name: str) -> Finding:
    """Whether a quantity depends on a parameter."""
    if name not in world.names:
        raise StatementError(f"“{name}” is no quantity of the problem", instead=did_you_mean(name, world.names, "names"))
    parts, given = parts_seen(world, phrase), world.motion.assumptions
    slopes = [derivative(part, name) for part in parts]
    if all(map(is_zero, slopes)):
        same = (Finding(**checked("no_change", value=part, names=(name,), best=part, given=given)) for part in parts)
        return Finding(**together(*same), says=f"no: “{phrase}” does not depend on {name}", holds=False)
    pairs = zip(parts, slopes, strict=True)
    moved = (part for part, slope in pairs if sign(slope, given).is_nonzero or find_witness(slope, NOTHING, given) is not None)
    if (part := next(moved, None)) is not None:
        said = checked("changes", value=part, name=name, given=given)
        return Finding(**said, says=f"yes: “{phrase}” depends on {name}", holds=True)
    return Finding(undecided("whether its derivative vanishes is not decided"))


def conserved(world: AskedPhase, phrase: str) -> Finding:
    """Whether a quantity stays what it is along the motion."""
    rates, parts = (parts_seen(world, f"{what}{phrase} as a function of the state") for what in ("rate of ", ""))
    pairs, given = list(zip(rates, parts, strict=True)), world.motion.assumptions
    moved = next((part for rate, part in pairs if find_witness(rate, NOTHING, given) is not None), None)
    kept = all(map(is_zero, rates))
    if not kept and moved is None:
        return Finding(undecided("whether its rate vanishes is not decided"))
    told = [Finding(**checked("kept_or_not", world.study, value=part, kept=kept)) for part in (parts if kept else [moved])]
    says = f"yes: “{phrase}” is conserved" if kept else f"no: “{phrase}” changes"
    return Finding(**together(*told), says=says, holds=kept)


def independent(world: AskedPhase, phrase: str, name: str) -> Finding:
    """Whether a quantity does not depend on a parameter."""
    found = depends(world, phrase, name)
    if found.holds is None:
        return found
    says = found.says.replace("no:", "yes:") if not found.holds else found.says.replace("yes:", "no:")
    return replace(found, holds=not found.holds, says=says)
