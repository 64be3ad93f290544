"""What antiderivatives give: integrals between fixed ends, and letters as functions of the time."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from rbpsym.errors import Undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, derivative, names_in, reduce_roots, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.field.integration import antiderivative
from rbpsym.kernel.certificates import Have, KnownEquation, Multiples
from rbpsym.kernel.claim import TIME, Proposition, brief, tree_of

if TYPE_CHECKING:
    from rbpsym.kernel.proofs import Search


def integrated(search: Search) -> list[KnownEquation]:
    """The values of the integrals that were met."""
    found = []
    for node in [*search.integrals.values()]:
        if node.var not in (*search.source.rates, TIME) and node in search.met:
            have = _integral(node)
            found.append(search.note("integral", have.claim, of=have.of, inner=have.inner, parts=have.parts))
    return found


def _integral(node: t.Integral) -> Have:
    """The value of an integral; of one inside first."""
    inner = _integral(node.integrand) if isinstance(node.integrand, t.Integral) else None
    integrand = node.integrand if inner is None else inner.claim.right
    primitive = antiderivative(scalar(integrand), node.var)
    if primitive is None:
        raise Undecided("no closed form of an integral was found")
    ends = [substitute(primitive, {node.var: scalar(end)}) for end in (node.upper, node.lower)]
    plain = (tree_of(reduce_roots(scalar(integrand).num)),) if any(isinstance(part, t.Sqrt) for part in t.walk(integrand)) else ()
    return Have("", "integral", Proposition(node, tree_of(ends[0] - ends[1])), tree_of(primitive), inner=inner, parts=plain)


def courses(search: Search, known: Sequence[KnownEquation]) -> list[KnownEquation]:
    """What each is at any time, from its start; what has a rate without a closed form is left out."""
    found: dict[str, KnownEquation] = {}
    free = [item for item in known if item.is_free]
    names = [name for name in search.rates if name != TIME and name not in search.integrals]
    for name in (*names, *names):  # speeds first, then what they move
        if name not in found:
            with suppress(Undecided):
                found[name] = _course(search, name, [*free, *found.values()])
    search.fixed -= found.keys()
    return [*found.values()]


def _course(search: Search, name: str, known: Sequence[KnownEquation]) -> KnownEquation:
    """A letter less its start and what its rate gives does not change."""
    rate, _ = search.follow(search.rates[name], known)
    way = None if any(map(search.moving, names_in(rate) - {TIME})) else antiderivative(rate, TIME)
    if way is None:
        raise Undecided("its rate is no function of the time")
    begun = [KnownEquation(item.name, item.claim, "0", item.by) for item in known if item.name in search.given]
    start, _ = search.follow(search.at_start(symbol(name)), begun)
    by_rates(search, symbol(name) - start - way + substitute(way, {TIME: NOTHING}), known)
    have = search.haves[-1]
    return KnownEquation(have.name, have.claim)


def by_rates(search: Search, goal: Scalar, known: Sequence[KnownEquation]) -> Multiples:
    """left - right does not change and is 0 at the start."""
    known = [item for item in known if item.is_free]
    rest, by = search.follow(goal, known, only=True)
    begun = _begins(search, rest, known)
    shown = search.shown(search.rate_of(rest), known)
    return _gone(search, by, "flat", rest, multiples=shown, begin=begun)


def _begins(search: Search, rest: Scalar, known: Sequence[KnownEquation]) -> Multiples:
    """By what it is 0 at the start."""
    first = [KnownEquation(i.name, i.claim, "0", i.by) for i in known if i.name in search.given and i.when == "t"]
    begin, begun = search.follow(search.at_start(rest), first)
    if not search.vanishes(begin):
        raise Undecided("at the start, of left - right stays " + brief(search.tree(begin)))
    return begun


def _gone(search: Search, by: Multiples, how: str, rest: Scalar, **more: Any) -> Multiples:
    """The multiples `by` which the rest is left, and the claim on the way that it is 0."""
    return Multiples((*by.known, (t.ONE, search.note(how, Proposition(search.tree(rest), t.ZERO), **more))), by.circles)


def by_course(search: Search, goal: Scalar, known: Sequence[KnownEquation]) -> Multiples:
    """left - right and its rate are 0 at the start, and solve a linear equation of second order."""
    known = [item for item in known if item.is_free]
    first, by = search.follow(goal, known, only=True)
    second, why = search.follow(search.rate_of(first), known)
    third = search.rate_of(second)
    turns = _linear(search, first, second, search.follow(third, known)[0])
    shown = search.shown(third - turns[0] * first - turns[1] * second, known)
    below = Have("", "course", Proposition(search.tree(second), t.ZERO), multiples=shown, begin=_begins(search, second, known))
    more = {"begin": _begins(search, first, known), "inner": below, "parts": tuple(map(search.tree, turns))}
    return _gone(search, by, "course", first, multiples=why, **more)


def _linear(search: Search, first: Scalar, second: Scalar, third: Scalar) -> tuple[Scalar, Scalar]:
    """By which constants the third is a sum of the first two, in which one coordinate and its speed stand."""
    names = [name for name in names_in(second) & search.source.rates.keys() if name not in names_in(first)]
    places = [name for name in names_in(first) if search.source.rates.get(name) == symbol(names[0])] if len(names) == 1 else []
    if not places:
        raise Undecided("no other letter and its rate stand there")
    place, speed = ([derivative(value, name) for value in (first, second, third)] for name in (places[0], names[0]))
    turn = speed[2] / speed[1]
    found = ((place[2] - turn * place[1]) / place[0], turn)
    if any(search.moving(name) for value in found for name in names_in(value)):
        raise Undecided("they are no constants")
    return found
