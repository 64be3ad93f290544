"""Checks of what is told of answers beside a formula of the motion: that it is the same for all, that it changes, that its sign
is kept or its least value is this, that an equation has one zero, that one value is the greatest of several.

They share nothing with what finds it but formulas, signs and ranges: no zeros, no series are looked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.equal import compare, scalars_equal
from rbpsym.decide.rooted import rooted, shorter, sign_along
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, all_of, proved, undecided
from rbpsym.field import NOTHING, UNITY, Meanings, Scalar, atoms, depends_on, derivative, is_zero, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.present.forms import present
from rbpsym.proof.checks.of_steps import right_sides, same
from rbpsym.proof.checks.parameters import KINDS, side_of
from rbpsym.proof.context import Context
from rbpsym.proof.step import Step

OTHER = "other_{}"


def put_in(context: Context, step: Step) -> Verdict:
    """Each stated value is the formula of another one, read with these meanings of its letters (`data`: "value", "image")."""
    read = scalar(present(step.data["value"]), Meanings(step.data["image"]))
    return all_of(same(context, value, read) for value in right_sides(context, step))


def no_change(context: Context, step: Step) -> Verdict:
    """The value is the best one, which is told, whatever the named quantities are (`data`: "value", "names", "best", "given")."""
    value, names, best, given = (step.data[key] for key in ("value", "names", "best", "given"))
    told = [same(context, value, best) for value in right_sides(context, step)]
    return all_of([*told, scalars_equal(_renamed(value, names), best, _alike(given, names))])


def changes(context: Context, step: Step) -> Verdict:
    """Two values of the named quantity give different values (`data`: "value", "name", "given")."""
    value, name, given = (step.data[key] for key in ("value", "name", "given"))
    if sign(derivative(value, name), given).is_nonzero:
        return proved("it is monotone in it")
    found = scalars_equal(_renamed(value, (name,)), value, _alike(given, (name,)))
    return proved("it differs at two values") if found.is_refuted else undecided("that it changes is not seen on a second road")


def _renamed(value: Scalar, names: Sequence[str]) -> Scalar:
    return substitute(value, {name: symbol(OTHER.format(name)) for name in names})


def _alike(given: Assumptions, names: Sequence[str]) -> Assumptions:
    """The assumptions with other names of which the same is declared."""
    for name in names:
        given = given.with_signs({OTHER.format(name): given.sign_of(name)})
        given = given.with_range(OTHER.format(name), *given.range_of(name)) if name in given.ranges else given
    return given


def kept_or_not(context: Context, step: Step) -> Verdict:
    """Whether the rate of a value vanishes on the motion, by its partial derivatives (`data`: "value", "kept")."""
    rates = {**context.study.system.scope.rates, "t": UNITY}
    gain = sum((derivative(step.data["value"], name) * rate for name, rate in rates.items()), NOTHING)
    found = same(context, context.on_motion(gain), NOTHING)
    if step.data["kept"]:
        return found
    return proved("its rate does not vanish") if found.is_refuted else undecided("that it changes is not seen on a second road")


def least_on_way(context: Context, step: Step) -> Verdict:
    """All values are positive, or not negative, on the way (`data`: "holds" True), one is negative somewhere (False), or each
    is where its least values are (None; "parts": (value, place, what is found there), "along", "given", "turns" of its slope)."""
    parts, along, given, holds = (step.data[key] for key in ("parts", "along", "given", "holds"))
    if holds:
        return all_of(_is_kept(value, along, given) for value in dict.fromkeys(value for value, _, _ in parts))
    if holds is False:
        fails = any(_is_negative(value, along, place, given) for value, place, _ in parts)
        return proved("it is negative there") if fails else undecided("that it fails is not seen on a second road")
    lows = {value: [(place, low) for other, place, low in parts if other is value] for value, _, _ in parts}
    return all_of(_least(value, found, along, given, step.data["turns"].get(value, ())) for value, found in lows.items())


def _is_kept(value: Scalar, along: str | None, given: Assumptions) -> Verdict:
    value = rooted(value, given)
    if sign(value, given).is_nonnegative or side_of(value, along, given) > 0:
        return proved("it is nowhere negative")
    found = compare(NOTHING, value, given, strict=False)  # a witness need not meet all conditions that are told
    return found if found.is_proved else undecided("that it is nowhere negative is not seen on a second road")


def _is_negative(value: Scalar, along: str | None, place: Scalar | None, given: Assumptions) -> bool:
    """Whether it is negative at a place, or beside one at which it vanishes."""
    if along is None or not depends_on(value, along):
        return any(side_of(rooted(value, given), name, given) < 0 for name in (None, *given.ranges)) or compare(
            value, NOTHING, given).is_proved  # fmt: skip
    if place is None:
        return side_of(value, along, given) < 0
    there, apart = rooted(substitute(value, {along: place}), given), given.without(along)
    if not is_zero(there):
        return sign(there, apart).kind == "negative" or compare(there, NOTHING, apart).is_proved
    lower = of_symbol(along, given).lower
    side = 1 if lower is not None and is_zero(place - lower) else -1
    slope = rooted(substitute(derivative(value, along), {along: place}), given)
    return sign(slope * side, apart).kind == "negative"


def _least(
    value: Scalar, lows: Sequence[tuple[Scalar | None, Scalar]], along: str | None, given: Assumptions, turns: Sequence[Scalar]
) -> Verdict:
    """Whether a value is nowhere less than at the places that are told."""
    if along is None or not depends_on(value, along):
        return all_of(scalars_equal(value, low, given) for _, low in lows)
    there = ((rooted(substitute(value, {along: place}), given), low) for place, low in lows if place is not None)
    nowhere = _nowhere_less(value, {place for place, _ in lows}, along, given, turns)
    return all_of([*(scalars_equal(*pair, given) for pair in there), nowhere])


def _nowhere_less(value: Scalar, places: set[Scalar | None], along: str, given: Assumptions, turns: Sequence[Scalar]) -> Verdict:
    """Whether it falls to these places only: between the turns its slope keeps its sign."""
    slope, limits = shorter(derivative(value, along)), of_symbol(along, given)
    points = [limits.lower, *turns, limits.upper]
    signs = [side_of(slope, along, given.with_range(along, *ends)) for ends in pairwise(points)]
    falls = {point for point, before, after in zip(points, [-1, *signs], [*signs, 1], strict=True) if before < 0 < after}
    if all(signs) and falls <= places:
        return proved("between these places its slope keeps its sign")
    return undecided("that there is no other place is not seen on a second road")


def one_zero(context: Context, step: Step) -> Verdict:
    """The equation is monotone and has both signs in the range; with a "value" it is its slope, but for what keeps its sign
    (`data`: "equation", "name", "given", "value")."""
    equation, name, given, value = (step.data[key] for key in ("equation", "name", "given", "value"))
    slope = shorter(derivative(equation, name))
    if not sign(slope, given).is_nonzero and not sign_along(slope, name, given):
        return undecided("that it is monotone is not seen on a second road")
    if value is not None:
        rest = shorter(derivative(value, name) / equation)
        if not sign(rooted(rest, given), given).is_nonzero:
            return undecided("that the slope vanishes there alone is not seen on a second road")
    ends = {_kind_at_end(equation, name, given, side) for side in (1, -1)}
    both = ends == set(KINDS.values())
    return proved("it is monotone and has both signs") if both else undecided("its signs at the ends are not decided")


def _kind_at_end(value: Scalar, name: str, given: Assumptions, side: int) -> str | None:
    """The sign at the lower (1) or the upper end (-1); towards infinity that of the lowest powers of one over the quantity."""
    limits, apart, small = of_symbol(name, given), given.without(name), OTHER.format(name)
    end = limits.lower if side > 0 else limits.upper
    if end is not None:
        return sign(rooted(substitute(value, {name: end}), apart), apart).kind
    near = substitute(value, {name: -side / symbol(small)})
    powers = [poly.by_power(atoms.intern("symbol", small)) for poly in (near.num, near.den)]
    above, below = (Scalar(part[min(part)]) for part in powers)
    return sign(rooted(above * below, apart), apart).kind


def greatest_of(context: Context, step: Step) -> Verdict:
    """No other value lies beyond the best one (`data`: "best", "others": values with what is given where each is compared,
    "sense")."""
    best, others, sense = (step.data[key] for key in ("best", "others", "sense"))
    told = [same(context, value, best) for value in right_sides(context, step)]
    pairs = (((other, best) if sense > 0 else (best, other), given) for other, given in others)
    return all_of([*told, *(compare(*ends, given, strict=False) for ends, given in pairs)])
