"""Checks of what is said of parameters: where a value vanishes, is greatest or least, and for which of them it is positive.

They share nothing with what finds it but formulas, signs and ranges: no sign table, no zero is looked for.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import pairwise

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.equal import compare, scalars_equal
from rbpsym.decide.rooted import rooted, shorter, sign_along
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, all_of, proved, undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, PI, UNITY, Scalar, atoms, factors, generator, inverse, is_zero, symbol
from rbpsym.field.calculus import atom_depends, depends_on, derivative, function, substitute
from rbpsym.field.normal import normal
from rbpsym.field.roots import with_image, without_even_roots
from rbpsym.proof.checks.of_steps import first_proved, right_sides
from rbpsym.proof.context import Context
from rbpsym.proof.step import Step

Ends = Mapping[int, Scalar | None]  # the lower (1) and the upper (-1) bound of a region
Way = tuple[str | None, Sequence[Scalar | None]]  # the coordinate along which a value varies, and the places that decide
KINDS = {1: "positive", -1: "negative"}
SENSES = {"positive": 1, "negative": -1}
MOST_DERIVATIVES = 6


def _told(context: Context, step: Step, values: Sequence[Scalar | None]) -> Verdict:
    """Whether each stated value is one of these."""
    rows = right_sides(context, step)
    known = [value for value in values if value is not None]
    given = step.data["given"]
    return all_of(_any_of(scalars_equal(row, value, given) for value in known) for row in rows)


def _any_of(verdicts: Iterable[Verdict]) -> Verdict:
    return first_proved(verdicts, undecided("what is stated is none of the values that were checked"))


def place_told(context: Context, step: Step) -> Verdict:
    """What is stated is one of the places at which the value vanishes."""
    return _told(context, step, step.data["places"])


def bound_told(context: Context, step: Step) -> Verdict:
    """What is stated are bounds, the lower one behind > and the upper one behind <; of the opposite the other way round."""
    way = -1 if step.data.get("opposite") else 1
    sides = {">": (way,), "<": (-way,), "=": (1, -1)}
    rows = [(replace(step, statement=t.relation(*row)), sides[row[1][0]]) for row in t.relations(step.statement)]
    return all_of(_told(context, row, [step.data["ends"][side] for side in ways]) for row, ways in rows)


def extreme_told(context: Context, step: Step) -> Verdict:
    """What is stated is the extreme value, or its place."""
    return _told(context, step, (step.data["best"], step.data["place"]))


def limit_told(context: Context, step: Step) -> Verdict:
    """What is stated is, near the limit, the leading term; or the limit (`data`: "there", the quantity as a function of ε)."""
    name, order, end = (step.data[key] for key in ("name", "order", "coefficient"))
    ends = [end * symbol(name) ** order, *([NOTHING] if order > 0 else ())]
    seen = (substitute(value, step.data["there"]) for value in right_sides(context, step))
    return all_of(_any_of(scalars_equal(value, one, step.data["given"]) for one in ends) for value in seen)


def vanishes_there(context: Context, step: Step) -> Verdict:
    """The value vanishes at the stated places, and nowhere else in the range: it is monotone, or has one sign between them
    (`data`: "value", "name", "places", "given")."""
    value, name, places, given = (step.data[key] for key in ("value", "name", "places", "given"))
    there = [scalars_equal(rooted(substitute(value, {name: place}), given), NOTHING, given) for place in places]
    forms = dict.fromkeys((value, shorter(without_even_roots(value)), _core(Scalar(value.num), given, is_sign=False)))
    return all_of([*there, first_proved((nowhere_else(form, name, places, given) for form in forms), OTHERS)])


def nowhere_else(value: Scalar, name: str, places: Sequence[Scalar], given: Assumptions) -> Verdict:
    """Whether the value vanishes in its range at these places at most."""
    value = _unwrapped(value, name)
    slope = shorter(derivative(value, name))
    if len(places) == 1 and sign(slope, given).is_nonzero:
        return proved("it is monotone, so that it vanishes once at most")
    if not places and side_of(value, name, given):
        return proved("it has one sign")
    if _degree(value, name) == len(set(places)) > 0:
        return proved("it has no more zeros than its degree")
    limits = of_symbol(name, given)
    ends = ((limits.lower, limits.lower_in), (limits.upper, limits.upper_in))
    reached = (end for end, is_in in ends if is_in and end is not None and end not in places)
    if any(not sign(substitute(value, {name: end}), given).is_nonzero for end in reached):
        return OTHERS  # at an end that may be reached it may vanish too
    if len(places) == 1 and is_zero(derivative(slope, name) + value) and limits.lower is not None and limits.upper is not None:
        whole = (sign(substitute(part, {name: NOTHING}), given.without(name)).is_nonzero for part in (value, slope))
        if sign(PI - limits.upper + limits.lower, given).is_nonnegative and any(whole):
            return proved("it is a wave A cos x + B sin x, which vanishes once in half a turn")
    parts = pairwise([limits.lower, *places, limits.upper])
    if places and all(_is_free(value, slope, given.with_range(name, *ends)) for ends in parts):
        return proved("between these it has one sign")
    return OTHERS


OTHERS = undecided("that there is no other place is not seen on a second road")


def _unwrapped(value: Scalar, name: str) -> Scalar:
    """p - q cos β for acos(p/q) - β, which vanishes wherever that does: so for what is linear in one inverse function."""
    inverses = (index for index in value.num.atoms() if atoms.atom(index).kind in INVERSES)
    inverse_ = [index for index in inverses if depends_on(atoms.atom(index).arg, name)]
    parts = value.num.by_power(inverse_[0]) if len(inverse_) == 1 else {}
    if parts.keys() - {0, 1} or 1 not in parts or any(depends_on(Scalar(part), name) for part in parts.values()):
        return value
    found = atoms.atom(inverse_[0])
    angle = -Scalar(parts.get(0, NOTHING.num)) / Scalar(parts[1])
    with suppress(ZeroDivisionError):
        return Scalar((found.arg - function(INVERSES[found.kind], angle)).num)
    return value


INVERSES = {"acos": "cos", "asin": "sin", "atan": "tan"}


def side_of(value: Scalar, name: str | None, given: Assumptions) -> int:
    """1 or -1 where a value is surely positive or negative in the range of a quantity, as what rises from zero; else 0."""
    found = SENSES.get(sign(value, given).kind or "") or (0 if name is None else sign_along(value, name, given))
    way = 0 if found or name is None else SENSES.get(sign(shorter(derivative(value, name)), given).kind or "", 0)
    if not way or name is None:
        return found
    limits = of_symbol(name, given)
    for side, end, is_in in ((1, limits.lower, limits.lower_in), (-1, limits.upper, limits.upper_in)):
        there = NOTHING if end is None else rooted(substitute(value, {name: end}), given) * side * way
        if end is not None and not is_in and sign(there, given.without(name)).is_nonnegative:
            return side * way
    return found


def _is_free(value: Scalar, slope: Scalar, given: Assumptions) -> bool:
    return sign(value, given).is_nonzero or sign(slope, given).is_nonzero


def _degree(value: Scalar, name: str) -> int | None:
    """The degree of the numerator, if it is a polynomial in the quantity itself; of a² - b² x for a + b √x."""
    index = atoms.intern("symbol", name)
    rooted_ = [i for i in value.num.atoms() if i != index and atom_depends(i, name)]
    if len(rooted_) == 1 and atoms.atom(rooted_[0]).kind == "root":
        parts = {k: Scalar(part) for k, part in value.num.by_power(rooted_[0]).items()}
        a, b = (parts.pop(k, NOTHING) for k in (0, 1))
        return None if parts else _degree(a * a - b * b * atoms.atom(rooted_[0]).arg, name)
    if any(other != index and atom_depends(other, name) for other in value.num.atoms()):
        return None
    powers = value.num.by_power(index)
    return max(powers) - min(powers)


def extreme_said(value: Scalar, best: Scalar, given: Assumptions, sense: int) -> Verdict:
    """Whether no value in the range lies beyond the best one."""
    ends = (value, best) if sense > 0 else (best, value)
    return compare(*ends, given, strict=False)


def end_said(value: Scalar, name: str, given: Assumptions) -> Verdict:
    """Whether the value is monotone, so that it goes to its bounds at the ends."""
    slope = shorter(derivative(value, name))
    if sign(rooted(_core(slope, given), given), given).is_nonzero:
        return proved("it is monotone")
    return undecided("that it is monotone is not seen on a second road")


def valley_said(value: Scalar, name: str, best: Scalar, given: Assumptions, sense: int) -> Verdict:
    """Whether the value falls up to zero and rises from there (the other way round for a least one), and is beyond the best one
    at neither end."""
    limits, core = of_symbol(name, given), _core(shorter(derivative(value, name)), given)
    ends = [end for end in (limits.lower, limits.upper) if end is not None]
    sides = ((ends[0], NOTHING, -sense), (NOTHING, ends[-1], sense)) if len(ends) == 2 else ()
    if not sides or any(sign(core, given.with_range(name, low, high)).kind != KINDS[way] for low, high, way in sides):
        return undecided("that it is monotone is not seen on a second road")
    return all_of(extreme_said(rooted(substitute(value, {name: end}), given), best, given, sense) for end in ends)


def _core(value: Scalar, given: Assumptions, *, is_sign: bool = True) -> Scalar:
    """What has the sign of the value: without roots and factors of known sign, with the others once where their power is odd; or
    only vanishes where it does: with each of them once."""
    _, powers = value.num.content()
    coefficient, found = factors(value.num.scaled(1, inverse(powers)))
    firm = [(index, exponent) for index, exponent in powers if not (is_sign and atoms.atom(index).kind == "root")]
    parts = [*found, *((generator(index), exponent) for index, exponent in firm), (value.den, -1)]
    core, side = UNITY, 1 if coefficient > 0 else -1
    for part, exponent in parts:
        known = SENSES.get(sign(Scalar(part), given).kind or "")
        core = core if known or (is_sign and exponent % 2 == 0) else core * Scalar(part)
        side *= (known or 1) ** (exponent % 2)
    return core * side


def slope_said(value: Scalar, name: str, place: Scalar, given: Assumptions, sense: int) -> Verdict:
    """Whether the value rises up to the place and falls behind it (the other way round for a least one).

    The slope has there a factor that vanishes and is monotone, or has its signs on both sides; the other factors keep theirs.
    """
    slope = shorter(derivative(value, name))
    core = _core(rooted(_core(slope, given), given), given)
    there = scalars_equal(rooted(substitute(core, {name: place}), given), NOTHING, given)
    if there.is_proved and sign(shorter(derivative(core, name)), given).kind == KINDS[-sense]:
        return proved("the slope changes its sign there, and its factor that does is monotone")
    limits = of_symbol(name, given)
    for value, at in ((core, place), (_counted_from(place, name, core, given), NOTHING)):
        ends = [None if end is None else end - place + at for end in (limits.lower, limits.upper)]
        sides = ((ends[0], at, sense), (at, ends[1], -sense))
        if all(sign(value, given.with_range(name, low, high)).kind == KINDS[way] for low, high, way in sides):
            return proved("the slope changes its sign there and nowhere else")
    return undecided("that it is the greatest or least value is not seen on a second road")


def _counted_from(place: Scalar, name: str, value: Scalar, given: Assumptions) -> Scalar:
    """The value as a function of how far the quantity is from a place: b sin x + a cos x is k sin u, counted from its zero."""
    moved = substitute(value, {name: symbol(PLACE) + symbol(name)})
    return rooted(substitute(Scalar(normal(moved.num)), {PLACE: place}) / substitute(Scalar(moved.den), {PLACE: place}), given)


PLACE = "the place"  # a letter that no problem has


def bounds_hold(context: Context, step: Step) -> Verdict:
    """All values are not negative within the stated bounds, and one of them is beyond each; with a sense: at the upper (1) or
    lower (-1) bound, and beyond it (`data`: "values", "name", "ends", "sense", "given", "way": the coordinate along which
    they vary and the places that decide).

    What rises vanishes at the lower bound and what falls at the upper one, at one place, and is nowhere negative there.
    """
    values, name, ends, way, given, sense = (step.data[key] for key in ("values", "name", "ends", "way", "given", "sense"))
    values = [value for value in values if sign(value, given).kind != "positive"]
    if sense:
        return _bound_said(values, {name: ends[-sense]}, way, given, sense)
    slopes = [SENSES.get(sign(shorter(derivative(value, name)), given).kind or "", 0) for value in values]
    seen = [_ends_said(value, slope, name, ends, way, given) for value, slope in zip(values, slopes, strict=True)]
    ended = {slope for slope, (_, vanishes) in zip(slopes, seen, strict=True) if vanishes}
    if all(kept for kept, _ in seen) and all(end is None or side in ended for side, end in ends.items()):
        return proved("it is monotone, and at the bound it vanishes at one place and is nowhere negative")
    limits = of_symbol(name, given)
    low, high = limits.lower if ends[1] is None else ends[1], limits.upper if ends[-1] is None else ends[-1]
    inside = [compare(NOTHING, value, given.with_range(name, low, high)) for value in values]
    return all_of([*inside, *_beyond(values, name, ends, way, given)])


def _bound_said(values: Sequence[Scalar], there: Mapping[str, Scalar], way: Way, given: Assumptions, sense: int) -> Verdict:
    """Whether at one bound no value is negative, while at one place one vanishes there and is negative beyond."""
    [name] = there
    low, high = (end and rooted(substitute(end, there), given) for end in given.range_of(way[0] or ""))
    within = given.with_range(way[0], low, high, given.sides_of(way[0])) if way[0] else given
    is_kept = all(_is_kept(rooted(substitute(value, there), given), way, within) for value in values)
    worst = [value for whole in values for value in _there(whole, *way)]
    edge = [value for value in worst if is_zero(rooted(substitute(value, there), given))]
    limits = of_symbol(name, given)
    floor = NOTHING if symbol(name) in values else limits.lower  # below it, it is negative itself
    outside = given.with_range(name, *((floor, there[name]) if sense < 0 else (there[name], limits.upper)))
    cores = [part for value in edge for part in (value, _core(value, given)) if is_zero(rooted(substitute(part, there), given))]
    falls = (sign(shorter(derivative(value, name)), each).kind == KINDS[-sense] for value in cores for each in (given, outside))
    if is_kept and any(falls):
        return proved("nothing is negative at the bound, and at one place something vanishes there and is negative beyond")
    return undecided("that this is the bound is not seen on a second road")


def _is_kept(value: Scalar, way: Way, given: Assumptions) -> bool:
    """Whether a value is nowhere negative on the way."""
    along = way[0]
    return sign(value, given).is_nonnegative or (along is not None and sign_along(value, along, given) > 0)


def _ends_said(value: Scalar, slope: int, name: str, ends: Ends, way: Way, given: Assumptions) -> tuple[bool, bool]:
    """Whether a value is not negative at the end that matters, and whether it vanishes there at one place."""
    bounds = [end for side, end in ends.items() if end is not None and (not slope or side == slope or ends[slope] is None)]
    kept, vanishes = sign(value, given).is_nonnegative, False
    for bound in bounds:
        at_bound = rooted(substitute(value, {name: bound}), given)
        kept = kept or _is_kept(at_bound, way, given)
        vanishes = vanishes or any(is_zero(rooted(there, given)) for there in _there(at_bound, *way))
    return kept, vanishes


def _beyond(values: Sequence[Scalar], name: str, ends: Ends, way: Way, given: Assumptions) -> Iterator[Verdict]:
    for bound, outer in ((ends[1], (None, ends[1])), (ends[-1], (ends[-1], None))):
        if bound is not None:
            outside = given.with_range(name, *outer)
            there = (place for value in values for place in _there(value, *way))
            fails = any(sign(value, outside).kind == "negative" for value in there)
            yield proved("beyond its bound it fails") if fails else undecided("that it fails beyond is not seen on a second road")


def _there(value: Scalar, along: str | None, worst: Sequence[Scalar | None]) -> Iterator[Scalar]:
    """The value at the places that decide."""
    if along is None or not depends_on(value, along):
        yield value
        return
    for place in worst:
        if place is not None:
            with suppress(ZeroDivisionError):
                yield shorter(substitute(value, {along: place}))


def approached(context: Context, step: Step) -> Verdict:
    """The square of a speed vanishes at a place together with its slope, so that the place is never reached (`data`: "value",
    "name", "place", "given")."""
    value, name, place, given = (step.data[key] for key in ("value", "name", "place", "given"))
    both = (value, derivative(value, name))
    return all_of(scalars_equal(rooted(substitute(one, {name: place}), given), NOTHING, given) for one in both)


def extreme_there(context: Context, step: Step) -> Verdict:
    """The value is the greatest (least) one at the stated place, or towards the end of the range ("at_end")."""
    value, name, given, sense = (step.data[key] for key in ("value", "name", "given", "sense"))
    place, best = step.data["place"], step.data["best"]
    found = end_said(value, name, given) if step.data["at_end"] else slope_said(value, name, place, given, sense)
    found = valley_said(value, name, best, given, sense) if step.data["at_end"] and not found.is_proved else found
    return found if found.is_proved else extreme_said(value, best, given, sense)


def tends_to(context: Context, step: Step) -> Verdict:
    """value/ε^order goes to the coefficient with ε, by l'Hôpital's rule; else their squares do, both being positive (`data`:
    "value" as a function of ε, "name" of ε, "order", "coefficient", "given")."""
    value, order, end, given = (step.data[key] for key in ("value", "order", "coefficient", "given"))
    found = _goes_to(value, step.data["name"], order, end, given)
    if found.is_proved or not all(sign(one, given).kind == "positive" for one in (value, end)):
        return found
    return _goes_to(rooted(value * value, given), step.data["name"], order * 2, rooted(end * end, given), given)


def _without_dying(value: Scalar, name: str, given: Assumptions) -> Scalar:
    """Without e^{-a/ε}, a > 0, which vanishes faster than any power of ε."""
    for index in value.atoms():
        with suppress(ZeroDivisionError):
            one = atoms.atom(index)
            if one.kind == "exp" and sign(substitute(one.arg * symbol(name), {name: NOTHING}), given).kind == "negative":
                value = with_image(value.num, index, NOTHING) / with_image(value.den, index, NOTHING)
    return value


def _goes_to(value: Scalar, name: str, order: int, end: Scalar, given: Assumptions) -> Verdict:
    """The first derivatives above and below the line that do not vanish at ε = 0 are compared."""
    small, index = symbol(name), atoms.intern("symbol", name)
    value = _without_dying(value, name, given)
    lowest = min((min(poly.by_power(index)) for poly in (value.num, value.den)), default=0)
    above, below = (shorter(Scalar(poly) * small ** (-lowest)) for poly in (value.num, value.den))  # no ε stands in a divisor
    above, below = (above, below * small**order) if order >= 0 else (above * small**-order, below)
    try:
        for _ in range(MOST_DERIVATIVES):
            ends = [rooted(substitute(part, {name: NOTHING}), given) for part in (above, below)]
            if not all(map(is_zero, ends)):
                return scalars_equal(ends[0] / ends[1], end, given)
            above, below = shorter(derivative(above, name)), shorter(derivative(below, name))
    except ZeroDivisionError:
        pass
    return undecided("the limit is not seen on a second road")
