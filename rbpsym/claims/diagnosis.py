"""Near misses: what a refuted relation seems to mean, decided by equality on repaired relations.

Repairs are small: another sign, number, exponent, function, symbol, moment of inertia or point.
Floating-point numbers choose which of them are decided; only one that is PROVED is told.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise
from typing import TypeVar

from rbpsym.claims.check import NOBODY, Neighbours, decide
from rbpsym.claims.decide import equal_to_first_order, has_slopes, is_constant
from rbpsym.claims.diagnosis_edits import TURNS, Change, Repair, Rule, alone_last, anywhere, edits, numbers
from rbpsym.claims.diagnosis_numbers import TOLERANCE, Sample, samples
from rbpsym.claims.ground import EqualityQuestion, Ground, holds_unknowns
from rbpsym.claims.integrals import prepared, valued
from rbpsym.claims.model import Claim, Outcome
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.limits import number_of
from rbpsym.expr.places import Path, put, sites
from rbpsym.field import Space, depends_on, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.present.forms import present
from rbpsym.quantity.bound import Bound
from rbpsym.typeset.text import to_text


def terms(relation: t.Chain) -> Iterator[tuple[Path, t.Node]]:
    """The terms of all sums and the sides themselves, the right side first: what can have a sign or be left out."""
    for path, node in sorted(sites(relation), key=lambda item: item[0][:1] != (("items", 1),)):
        if path and (path[-1][0] in ("terms", "items")) and node != t.ZERO:
            yield path, node


def is_in_exponent(path: Path) -> bool:
    """Does the place stand in an exponent, or in the limits of an integral?"""
    return any(name in ("exponent", "lower", "upper", "to", "condition") for name, _ in path)


MOST_UNSEEN, MOST_LOOSE, MOST_DECIDED = 24, 400, 12
FACTORS = tuple(Fraction(n, d) for n, d in (
    (2, 1), (1, 2), (3, 1), (1, 3), (4, 1), (1, 4), (3, 2), (2, 3), (3, 4), (4, 3), (6, 1), (1, 6), (8, 1), (1, 8), (5, 1),
    (1, 5), (12, 1), (1, 12), (-2, 1), (-1, 2),
))  # fmt: skip


N = TypeVar("N", bound=t.Node)


class Diagnosis(Frozen):
    """What a refuted relation seems to mean, in words, and the relation that was proved in its place."""

    words: str = ""
    relation: t.Chain | None = None


def diagnosis(relation: t.Chain, claim: Claim, ground: Ground, near: Neighbours = NOBODY) -> Diagnosis:
    """The first repair that is PROVED and with which its neighbours in a chain hold; else the first that is; what is true of a
    symbol that stands alone if none is."""
    if relation.ops != ("=",):
        return Diagnosis()
    told, loosely = _said_otherwise(relation, claim, ground)
    loose = _is_loose(relation, ground)
    looks = [] if loose else samples(EqualityQuestion(ground, claim.holds), relation=relation)
    first = empty = None
    decided, unseen, most = 0, 0, MOST_LOOSE if loose else MOST_UNSEEN
    for repair in _repairs(relation, claim, ground):
        if len(set(repair.relation.items)) == 1:
            continue  # I = I says nothing
        seen = _is_likely(repair, ground, looks)
        unseen += seen is None
        if seen is False or (seen is None and unseen > most) or decided >= MOST_DECIDED:
            continue
        decided += seen is True
        link = decide(repair.relation, repair.ground or ground, claim.holds, witnesses=False)
        if link.outcome is Outcome.PROVED and not _says_nothing(repair, ground):
            if told and repair.words.startswith(("the term", "factor")):
                break  # nobody's slip is a constant
            found = Diagnosis(f"{repair.words}: {to_text(repair.relation)}", repair.relation)
            if looks and (looks[0].is_identity(repair.relation, repair.ground or ground) or _repeats(repair.relation)):
                empty = empty or found
                continue
            if all(_holds_beside(one, holds, relation, repair, claim, ground) for one, holds in near.items()):
                return found
            first = first or found
    return first or empty or Diagnosis(told or loosely or _actual(relation, ground))


def _repeats(relation: t.Chain) -> bool:
    """Is a factor printed twice? Nobody meant it."""
    products = [part.factors for part in t.walk(relation) if isinstance(part, t.Mul)]
    return any(factors.count(one) > 1 for factors in products for one in factors if isinstance(one, t.Sym))


def _says_nothing(repair: Repair, ground: Ground) -> bool:
    """Is it 0 = 0, or is one side a 0 in disguise?"""
    items, looks = repair.relation.items, samples(EqualityQuestion(repair.ground or ground), 1)
    look = looks[0] if looks else None
    if t.ZERO not in items:
        swallows = any(one in getattr(other, "terms", ()) for one, other in (items, items[::-1]))  # a + b = b
        return swallows or (look is not None and any(map(look.is_hollow, items)))
    hollow = (isinstance(item, t.Sym) or look is None or look.is_hollow(item) for item in items if item != t.ZERO)
    return "in place of" not in repair.words and all(hollow)


def _holds_beside(one: t.Chain, holds: bool, relation: t.Chain, repair: Repair, claim: Claim, ground: Ground) -> bool:
    """Does a neighbour in the chain hold with what was repaired of the side that they share?"""
    pairs = zip(relation.items, repair.relation.items, strict=True)
    changed = {id(old): new for old, new in pairs if new != old}
    if not any(id(item) in changed for item in one.items):
        return holds
    other = replace(one, items=tuple(changed.get(id(item), item) for item in one.items))
    return decide(other, repair.ground or ground, claim.holds, witnesses=False).outcome is Outcome.PROVED


def _said_otherwise(relation: t.Chain, claim: Claim, ground: Ground) -> tuple[str, str]:
    """What makes the relation true as it stands, if it is said so: up to a constant, to first order; "" for what does not."""
    question = EqualityQuestion(ground, claim.holds, False)
    try:
        left, right = (valued(side, ground) for side in relation.items)
        if isinstance(left, Space) or isinstance(right, Space):
            return "", ""
        gap = left - right
        names = [latex for latex, meaning in claim.setting.symbols.items() if ENERGY.fullmatch(meaning.phrase)]
        alone = {side.name for side in relation.items if isinstance(side, t.Sym)}
        for latex in names:
            if ground.glossary.names[latex][0] in alone and is_constant(gap, question, ("identity",)):
                asked = f"is {latex} the {claim.setting.symbols[latex].phrase}, up to a constant?"
                return f"{FACT} the sides differ by a constant, {to_text(present(gap))}: {asked}", ""
        small = [name for name in question.motion.scope.start if depends_on(gap, name)]
        if equal_to_first_order(left, right, question).is_proved and has_slopes([left, right], small):
            return "", f"{FACT} it holds to first order in {' and '.join(to_text(t.Sym(name)) for name in small)}: write \\approx"
    except (RbpsymError, ZeroDivisionError):  # a side has no value, or none where the coordinates vanish
        pass
    return "", ""


ENERGY = re.compile(r"(?:(?:total |mechanical |potential )*energy|Lagrangian)(?: of .+)?")
FACT = "in fact"  # begins a diagnosis that is no near miss
LONGEST = 120  # characters of a value that is told


def _actual(relation: t.Chain, ground: Ground) -> str:
    """What a quantity that stands alone on one side really is; "" if that is not known or too long to read."""
    alone = next((node for node in relation.items if isinstance(node, t.Sym)), None)
    question = EqualityQuestion(ground)
    if alone is None or question.motion.is_free or ground.kind(alone.name) != "value":
        return ""
    try:
        found = question.seen(scalar(alone, ground.scope), "start")
    except RbpsymError:  # it is not known on the motion
        return ""
    told_of_work = any(depends_on(found, work) for work in question.motion.ledger)
    if told_of_work or found == symbol(alone.name) or holds_unknowns(found, question):
        return ""
    told = to_text(present(found))
    return f"{FACT} {to_text(alone)} is {told}" if len(told) <= LONGEST else ""


def _is_loose(relation: t.Chain, ground: Ground) -> bool:
    """Does a constant that nobody knows stand in it? Then numbers say nothing."""
    return any(ground.kind(name) in ("constant", "up to a constant") for name in t.names(relation))


def _is_likely(repair: Repair, ground: Ground, looks: list[Sample]) -> bool | None:
    """Do numbers agree with the repaired relation? None if they can't be had."""
    own = repair.ground or ground
    if not looks or _is_loose(repair.relation, own):
        return None
    try:
        ready = t.Chain(tuple(prepared(item, own) for item in repair.relation.items), ("=",))
    except (RbpsymError, ZeroDivisionError):  # the repair leaves a formula without a value
        return False
    if repair.ground is not None:
        looks = [replace(look, question=replace(look.question, ground=own), known={}) for look in looks]
    gaps = [gap for look in looks if (gap := look.gap(ready)) is not None]
    return None if len(gaps) < len(looks) else max(gaps) < TOLERANCE


def _repairs(relation: t.Chain, claim: Claim, ground: Ground) -> Iterator[Repair]:
    for rule in RULES:
        yield from rule(relation)
    yield from _moments(relation, ground)
    yield from _pivots(relation, claim, ground)
    yield from edits(relation, claim, ground)


def _signs(relation: t.Chain) -> Iterator[Repair]:
    for path, node in sorted(terms(relation), key=lambda item: item[0][-1] == ("terms", 0)):  # first those with a sign in front
        yield Repair(put(relation, path, t.neg(node)), f"sign of {to_text(node)}")


def _products(path: Path, node: t.Node) -> Iterator[Change]:
    if isinstance(node, t.Cross):
        yield replace(node, left=node.right, right=node.left), "order of the vector product"


def _doubled(path: Path, node: t.Node) -> Iterator[Change]:
    """A number, a factor, a term or a digit that is too much."""
    if isinstance(node, t.Mul):
        for k, one in enumerate(node.factors):
            if number_of(one) is not None and t.names(node):
                yield t.mul(*node.factors[:k], *node.factors[k + 1 :]), f"{to_text(one)} is too much"
        for k, (one, other) in enumerate(pairwise(node.factors)):
            if one == (other.base if isinstance(other, t.Pow) else other):
                yield t.mul(*node.factors[:k], *node.factors[k + 1 :]), f"{to_text(one)} is printed twice"
    terms = node.terms if isinstance(node, t.Add) else ()
    for k, one in enumerate(terms):
        if one in terms[:k]:
            gone = k if k + 1 == len(terms) else terms.index(one)  # what is left stands together
            yield t.add(*terms[:gone], *terms[gone + 1 :]), f"{to_text(one)} is printed twice"
    digits = str(node.value) if isinstance(node, t.Num) else ""
    for k, pair in enumerate(pairwise(digits)):
        if len({*pair}) == 1 and digits.isdigit():
            yield t.Num(int(digits[:k] + digits[k + 1 :])), f"{pair[0]} is printed twice"


def _extra(relation: t.Chain) -> Iterator[Repair]:
    for path, node in terms(relation):
        if path[-1][0] == "terms":
            rest = [part for way, part in sites(relation) if len(way) == len(path) and way[:-1] == path[:-1] and way != path]
            yield Repair(put(relation, path[:-1], t.add(*rest)), f"the term {to_text(node)} is too much")


def _factors(relation: t.Chain) -> Iterator[Repair]:
    inner = [(path, node) for path, node in sites(relation) if path and path[-1][0] in ("num", "den", "arg")]
    for path, node in [*sorted(terms(relation), key=lambda item: item[0][-1][0] != "terms"), *inner]:
        for factor in FACTORS:
            yield Repair(put(relation, path, _times(factor, node)), f"factor {factor} at {to_text(node)}")


def _times(factor: Fraction, node: t.Node) -> t.Node:
    """The node with its number in front multiplied."""
    if isinstance(node, t.Mul) and (number := number_of(node.factors[0])) is not None:
        return t.mul(t.Num(number * factor), *node.factors[1:])
    if isinstance(node, t.Neg):
        return t.neg(_times(factor, node.arg))
    if isinstance(node, t.Div) and t.names(node.num) and factor.denominator == 1:
        return replace(node, num=_times(factor, node.num), span=None)
    return t.mul(t.Num(factor), node)


def _functions(path: Path, node: t.Node) -> Iterator[Change]:
    if isinstance(node, t.Fn) and node.name in TURNS:
        yield from ((replace(node, name=other), f"{other} in place of {node.name}") for other in TURNS if other != node.name)


def _exponents(path: Path, node: t.Node) -> Iterator[Change]:
    if is_in_exponent(path):
        return
    if isinstance(node, t.Pow) and isinstance(node.exponent, t.Num):
        for step in (-1, 1):
            yield t.power(node.base, node.exponent.value + step), f"exponent of {to_text(node.base)}"
    elif (isinstance(node, (t.Sym, t.Fn, t.Group)) and (not path or path[-1][0] != "base")) or (
        isinstance(node, t.Add) and path and path[-1][0] in ("factors", "terms")
    ):
        yield t.Pow(node, t.TWO), f"exponent of {to_text(node)}"


def _symbols(relation: t.Chain) -> Iterator[Repair]:
    """One symbol in place of another that the formula has, in one place or everywhere."""
    names = sorted({node.name for _, node in sites(relation) if isinstance(node, t.Sym)})
    for path, node in alone_last(relation):
        if isinstance(node, t.Sym) and not is_in_exponent(path):
            for other in names:
                if other != node.name:
                    words = f"{to_text(t.Sym(other))} in place of {to_text(node)}"
                    yield Repair(put(relation, path, t.Sym(other)), words)
    for path, node in sites(relation):
        if isinstance(node, t.Mul):
            for one, other in combinations(sorted({part.name for _, part in sites(node) if isinstance(part, t.Sym)}), 2):
                words = f"{to_text(t.Sym(one))} and {to_text(t.Sym(other))} exchanged"
                yield Repair(put(relation, path, _exchanged(node, one, other)), words)
    for one in names:
        for other in (name for name in names if name > one):
            yield Repair(_exchanged(relation, one, other), f"{to_text(t.Sym(one))} and {to_text(t.Sym(other))} exchanged")


def _exchanged(relation: N, one: str, other: str) -> N:
    swap = {one: other, other: one}
    for path, node in list(sites(relation)):
        if isinstance(node, t.Sym) and node.name in swap:
            relation = put(relation, path, t.Sym(swap[node.name]))
    return relation


def _limits(path: Path, node: t.Node) -> Iterator[Change]:
    if isinstance(node, (t.Integral, t.Bracket)):
        yield replace(node, lower=node.upper, upper=node.lower), "limits of the integral exchanged"


def _turned(path: Path, node: t.Node) -> Iterator[Change]:
    if isinstance(node, t.Div):
        yield replace(node, num=node.den, den=node.num, span=None), f"the fraction {to_text(node)} is upside down"


def _dots(_path: Path, node: t.Node) -> Iterator[Change]:
    """A dot more, or less."""
    if isinstance(node, t.Deriv) and node.wrt == "t":
        for order in (node.order - 1, node.order + 1):
            yield replace(node, order=order) if order else node.of, "the number of dots"


RULES: tuple[Rule, ...] = (
    anywhere(_doubled), anywhere(_products), _signs, anywhere(_functions),
    anywhere(lambda path, node: iter(()) if is_in_exponent(path) else numbers(path, node)), _factors, _extra,
    *map(anywhere, (_exponents, _limits, _turned, _dots)), _symbols,
)  # fmt: skip


def _moments(relation: t.Chain, ground: Ground) -> Iterator[Repair]:
    """In the general theory, which has no values: I ω, I α or ½ I ω² about the centre of mass, added or taken away."""
    if getattr(ground.world, "study", None) is not None:
        return
    names = {
        "I_cm": "moment of inertia about the centre of mass", "omega": "angular velocity", "alpha": "angular acceleration",
    }  # fmt: skip
    yield from _with_terms(relation, t.Sym("I_cm"), ("omega", "alpha"), _with_phrases(ground, names))


def _with_phrases(ground: Ground, names: dict[str, str]) -> Ground:
    """The ground with some more names, by their phrases."""
    bounds = {(name, arrow): ground.world.bound(phrase) for name, phrase in names.items() for arrow in (True, False)}
    return replace(ground, bounds={**bounds, **ground.bounds})


def _with_terms(relation: t.Chain, inertia: t.Sym, speeds: tuple[str, str], ground: Ground) -> Iterator[Repair]:
    """I ω, I α, ½ I ω² added to the right side."""
    left, right = relation.items
    parts = [t.mul(inertia, kind(name)) for name in speeds for kind in (t.Vec, t.Sym)]
    parts.append(t.mul(t.HALF, inertia, t.Pow(t.Sym(speeds[0]), t.TWO)))
    for part in parts:
        for signed, what in ((part, "is missing"), (t.Neg(part), "is too much")):
            yield Repair(t.Chain((left, t.add(right, signed)), ("=",)), f"{to_text(part)} {what}", ground)


def _pivots(relation: t.Chain, claim: Claim, ground: Ground) -> Iterator[Repair]:
    """A momentum, torque or moment of inertia about another point."""
    study = getattr(ground.world, "study", None)
    if study is None:
        return
    points = ["O", *(f"{body}.cm" for body in study.system.bodies)]
    for latex, meaning in claim.setting.symbols.items():
        key = ground.glossary.names[latex]
        found = re.fullmatch(r"(.*) about ([\w.]+)(.*)", meaning.phrase)
        if key not in ground.bounds or not found:
            continue
        for point in points:
            if point != found[2]:
                yield from _about(relation, ground, key, f"{found[1]} about {point}{found[3]}", point)


def _about(relation: t.Chain, ground: Ground, key: tuple[str, bool], phrase: str, point: str) -> Iterator[Repair]:
    try:
        bound: Bound = ground.world.bound(phrase)
    except RbpsymError:
        return
    other = replace(ground, bounds={**ground.bounds, key: bound})
    yield Repair(relation, f"it holds about {point}", other)
