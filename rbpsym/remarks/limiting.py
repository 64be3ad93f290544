"""What a result becomes in a limit: a small body or mass, or an interaction that is left out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rbpsym.algebra import NOTHING, depends_on, is_zero, names_in, substitute
from rbpsym.algebra.present import present
from rbpsym.ask.finding import checked
from rbpsym.ask.limits import SMALL, leading
from rbpsym.equality.rooted import neat
from rbpsym.notation import tree as t
from rbpsym.quantities import LENGTH, MASS
from rbpsym.remarks.made import Made
from rbpsym.remarks.result import Result

STRENGTHS: Mapping[str, str] = {
    "spring": "stiffness",
    "torsion-spring": "stiffness",
    "damper": "coefficient",
    "rotary-damper": "coefficient",
    "resistance": "coefficient",
    "resisting-couple": "coefficient",
    "pull": "size",
    "contact": "coefficient",
}  # of interactions, and of the friction of a contact: the value with which they disappear


def without(result: Result) -> Iterator[Made]:
    """What it would be without an interaction or without sliding friction, whose strength goes to zero."""
    for element in (*result.study.problem.interactions, *result.study.problem.constraints):
        strength = element.values.get(STRENGTHS.get(element.kind, ""))
        name = strength.name if isinstance(strength, t.Sym) else ""
        force = element.values.get("friction") or element.name
        if name in result.declared and _disappears(force, name, result):
            yield from _limit(result, name, "remark.without", {"force": t.Sym(force)})


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
    if not depends_on(result.value, name):
        return
    found = leading(result.value, name, NOTHING, result.given)
    moving = {*result.study.system.scope.rates, *(c.name for c in result.study.problem.coordinates)}
    if found is None or found.order != 0 or moving & (names_in(result.value) - names_in(found.coefficient)):
        return
    given = result.given.with_signs({SMALL: "positive"})
    data = {"value": found.image, "name": SMALL, "order": 0, "coefficient": found.coefficient, "given": given}
    verdict = checked("limit", **data)["verdict"]
    value = present(neat(found.coefficient, result.given), result.study.style, factor=True)
    yield Made(key, {"quantity": result.name, "name": t.Sym(name), "value": value, **slots}, verdict, (key, name))
