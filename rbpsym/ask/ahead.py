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
from rbpsym.ask.finding import Finding, together
from rbpsym.ask.question import SUPERLATIVES
from rbpsym.ask.seen import AskedPhase, never_told, parameter, parts_seen
from rbpsym.ask.sliding import of_contact
from rbpsym.ask.wanted import Wanted
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.expr.tree import names as symbols
from rbpsym.field import Scalar, depends_on, is_zero
from rbpsym.mechanics.demands import possible
from rbpsym.mechanics.stability import essential
from rbpsym.quantities import FORCE, LENGTH

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
