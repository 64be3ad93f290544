"""The remarks on the results of a derivation: in a fixed order of what matters, each of them once in a text.

What drops out, and because of which pair of forces; what the result does not depend on; what it would be without an
interaction; what it becomes where something is small; which way it goes with its parameters. docs/remarks.md tells the rule.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from rbpsym.ask.finding import checked
from rbpsym.ask.limits import SMALL, leading, squeezed
from rbpsym.decide.domain import divisors
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, at_most, depends_on, is_zero, names_in, substitute
from rbpsym.present.forms import present
from rbpsym.proof.step import Derivation, Step
from rbpsym.quantities import LENGTH, MASS
from rbpsym.remarks.dependence import drops_out, free_of, monotone
from rbpsym.remarks.result import Made, Result, results

STRENGTHS: Mapping[str, str] = {
    "spring": "stiffness",
    "torsion-spring": "stiffness",
    "damper": "coefficient",
    "rotary-damper": "coefficient",
    "pull": "size",
    "contact": "coefficient",
}  # of interactions, and of the friction of a contact: the value with which they disappear


def without(result: Result) -> Iterator[Made]:
    """What it would be without an interaction or without sliding friction, whose strength goes to zero."""
    elements = (*result.study.problem.interactions, *result.study.problem.constraints)
    strengths = [element.values.get(STRENGTHS.get(element.kind, "")) for element in elements]
    for element, strength in zip(elements, strengths, strict=True):
        name = strength.name if isinstance(strength, t.Sym) else ""
        force = element.values.get("friction") or element.name
        if name in result.declared and _disappears(force, name, result):
            alone = strengths.count(strength) == 1  # else others disappear with it
            yield from _limit(result, name, *(("remark.without", {"force": t.Sym(force)}) if alone else ("remark.small", {})))


def _disappears(force: str, name: str, result: Result) -> bool:
    """Are all parts of the force zero where its strength is?"""
    parts = (part for f in result.study.system.named(force) for part in (f.vector.x, f.vector.y, f.couple))
    return all(is_zero(substitute(part, {name: NOTHING})) for part in parts)


def small(result: Result) -> Iterator[Made]:
    """What it becomes where a length or a mass is small against another one in it."""
    kinds = {name: q.dimension for name, q in result.declared.items() if q.sign == "positive" and depends_on(result.value, name)}
    for name, dimension in sorted(kinds.items(), key=lambda pair: pair[1] != LENGTH):  # a body's size before its mass
        others = [other for other, kind in kinds.items() if kind == dimension and other != name]
        if dimension not in (LENGTH, MASS) or not others:
            continue
        if len(others) == 1 and dimension == MASS:
            yield from _limit(result, name, "remark.much", {"great": t.Sym(others[0])})
        else:
            yield from _limit(result, name, "remark.small", {})


def _limit(result: Result, name: str, key: str, slots: Mapping[str, object]) -> Iterator[Made]:
    """The limit where it is finite and not zero, and still a function of the same coordinates."""
    if not depends_on(result.value, name) or squeezed(result.value, name, NOTHING, result.given):
        return
    found = leading(result.value, name, NOTHING, result.given)
    moving = {*result.study.system.scope.rates, *(c.name for c in result.study.problem.coordinates)}
    if found is None or found.order != 0 or moving & (names_in(result.value) - names_in(found.coefficient)):
        return
    if any(not sign(one, result.given).is_nonzero for one in {*divisors(found.coefficient)} - {*divisors(result.value)}):
        return  # where this vanishes the limit is another one
    if isinstance(result.name, t.Pow) and sign(found.coefficient, result.given).sense < 0:
        return  # no square has it: what it told of, an oscillation, is none there
    given = result.given.with_signs({SMALL: "positive"})
    data: dict[str, Any] = {"value": found.image, "name": SMALL, "order": 0, "coefficient": found.coefficient, "given": given}
    verdict = checked("limit", **data)["verdict"]
    value = present(neat(found.coefficient, result.given), result.study.style, factor=True)
    yield Made(key, {"quantity": result.name, "name": t.Sym(name), "value": value, **slots}, verdict, (key, name))


KINDS = (drops_out, free_of, without, small, monotone)  # from what matters most to what matters least
MOST: Mapping[str, int | None] = {"brief": 2, "standard": 3, "full": None}  # remarks on a result
ONCE = (drops_out, without, small, monotone)  # kinds of which shorter notes have one remark in a text
AT_ONE = "remark.free_of"  # without a reason: they say so of one result only, the first
MOST_PRODUCTS = 100_000


def remarks(derivation: Derivation, detail: str) -> list[dict[str, list[Step]]]:
    """The sentences about each result by the id of its step, for each phase; what is refuted or not decided is not said."""
    before: set[object] = set()
    parts = (derivation, *(phase.derivation for phase in derivation.phases))
    return [{found.step.id: list(_chosen(found, detail, before)) for found in results(part)} for part in parts]


def _chosen(result: Result, detail: str, before: set[object]) -> Iterator[Step]:
    is_short, count = detail != "full", 0
    for kind in KINDS:
        for made in () if kind in before else guarded(kind, result):
            step = made.said()
            if not step.phrase or made.about in before or count == MOST[detail] or (is_short and step.phrase in before):
                continue
            before.add(made.about)
            count += 1
            yield step
            if is_short and kind in ONCE:
                before.add(kind)
                break
            before |= {AT_ONE} & {step.phrase}


def guarded(kind: Callable[[Result], Iterable[Made]], result: Result) -> list[Made]:
    """What cannot be decided is not said."""
    try:
        with at_most(MOST_PRODUCTS):
            return list(kind(result))
    except (RbpsymError, ZeroDivisionError):
        return []
