"""Whether a printed relation holds: as an identity, on the motion, or along it from the start.

A difference is zero if it is so as it stands, with the accelerations and forces of the motion,
with the speeds of the motion from the start, or if it is zero at the start and does not change.
It is refuted at a state of the motion at which the sides differ. All by `equality`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import suppress

from rbpsym.claims.ground import HOW, EqualityQuestion, are_same
from rbpsym.claims.integrals import as_vector
from rbpsym.claims.refute import ORDERS, disorder, mixes_clock, refutation, witness_of
from rbpsym.decide.equal import compare, scalars_equal
from rbpsym.decide.points import names_of
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, all_of, proved, refuted, undecided
from rbpsym.errors import Undecided
from rbpsym.field import NOTHING, Scalar, Space, atoms, bases_of, depends_on, derivative, quotient, substitute
from rbpsym.field.normal import normal
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import replace
from rbpsym.proof.checks.places import is_kept
from rbpsym.quantity.path import is_along_one_path, look_different, on_path, path_of

MOST_RATES = 2


def equal_values(a: Scalar | Space, b: Scalar | Space, question: EqualityQuestion) -> Verdict:
    """Whether two values are equal, component by component for vectors."""
    if isinstance(a, Space) or isinstance(b, Space):
        pairs = zip(as_vector(a).components(), as_vector(b).components(), strict=True)
        return all_of(equal_scalars(x, y, question) for x, y in pairs)
    return equal_scalars(a, b, question)


def equal_scalars(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """Whether two scalars are equal, from the strongest depth to the weakest."""
    tried = [depth for depth in question.depths if depth != "start"]
    if (found := _at_depth(a, b, tried, question)) is not None:
        return found
    if question.witnesses and is_along_one_path(question.motion) and look_different(a, b, question.motion):
        found = refutation(a, b, question)
        if found.is_refuted:
            return found
    if (found := _at_depth(a, b, question.depths[len(tried) :], question)) is not None:
        return found
    if "start" in question.depths and _in_each_sense(a, b, question):
        return proved(HOW["sense"])
    if _by_rates(a, b, question):
        return proved(HOW["rates"])
    return refutation(a, b, question) if question.witnesses else undecided("not proved")


def _at_depth(a: Scalar, b: Scalar, depths: Iterable[str], question: EqualityQuestion) -> Verdict | None:
    for depth in depths:
        if are_same(question.seen(a, depth), question.seen(b, depth), question):
            return proved(HOW[depth])
    return None


def _in_each_sense(a: Scalar, b: Scalar, question: EqualityQuestion) -> bool:
    """Equal with the speeds as functions of the place, in the sense in which the motion sets out, or in both."""
    values = tuple(question.seen(value, "start") for value in (a, b))
    if not path_of(values, question.motion).names:
        return False
    return all(are_same(pair[0], pair[1], question) for pair, _ in on_path(values, question.motion))


def _by_rates(a: Scalar, b: Scalar, question: EqualityQuestion) -> bool:
    """Equal at the start, and the difference does not change; or that of their rates does not, and so on."""
    gap = a - b
    for _ in range(MOST_RATES if "motion" in question.depths else 1):
        try:
            if not are_same(question.begin(gap), NOTHING, question):
                return False
        except ZeroDivisionError:  # the start is a place where one of them has no value
            return False
        if is_constant(gap, question, question.depths):
            return True
        gap = question.rate(gap)
    return False


def is_constant(value: Scalar, question: EqualityQuestion, depths: Iterable[str]) -> bool:
    """Does its rate vanish at one of these depths?"""
    for depth in depths:
        with suppress(Undecided):
            if are_same(question.seen(question.rate(value, depth), depth), NOTHING, question):
                return True
    return False


def constant_value(value: Scalar, question: EqualityQuestion) -> Verdict:
    """Whether a value is a constant of the motion."""
    for depth in question.depths:
        if is_constant(value, question, (depth,)):
            return proved(HOW["constant"])
    rate = question.rate(value)
    found = refutation(rate, NOTHING, question) if question.witnesses else undecided("not proved")
    if found.witness is not None:
        return refuted("its rate of change is not zero", found.witness)
    return found


def up_to_constant(value: Scalar, other: Scalar, question: EqualityQuestion) -> Verdict:
    """Whether two values differ by a constant, as an identity in positions and speeds."""
    if is_constant(value - other, question, ("identity",)):
        return proved("equal up to a constant")
    gained, same = (v - question.begin(v) for v in (value, other))
    found = witness_of(gained, same, question.motion.assumptions)
    return found if found.is_refuted else undecided("the difference was not shown to be a constant")


# --- inequalities and approximations


def ordered(a: Scalar, b: Scalar, op: str, question: EqualityQuestion) -> Verdict:
    """Whether a < b (<=, >, >=) in every state."""
    low, high = (a, b) if op in ("<", "<=") else (b, a)
    op, strict = op.replace("<", ">"), op in ("<", ">")
    for depth in question.depths:
        pair = tuple(question.seen(v, depth) for v in (low, high))
        found = _below(pair, question, strict=strict)
        if not found.is_proved and depth == "start" and path_of(pair, question.motion).names:
            each = [_below(way, question, strict=strict) for way, _ in on_path(pair, question.motion)]
            found = proved(HOW["sense"]) if all(one.is_proved for one in each) else found
        if found.is_proved:
            return found
    if "start" in question.depths and _by_growth(high - low, question, strict=strict):
        return proved(HOW["growth"])
    with suppress(Undecided, ZeroDivisionError):
        gap, given = question.seen(high - low, "start"), question.motion.assumptions
        if "start" in question.depths and any(is_kept(gap, square, given, op) for square in question.motion.squares.values()):
            return proved(HOW["sense"])
    return disorder(low, high, question, strict=strict)


def _by_growth(gap: Scalar, question: EqualityQuestion, *, strict: bool) -> bool:
    """Not negative (`strict`: positive) at the start, as its rates are there, up to one that is never negative; positive after
    the start where that one is."""
    given, declared = question.motion.assumptions, question.ground.world.motion.assumptions
    later = strict and given.range_of("t")[0] is not None and 0 not in given.sides_of("t")
    for name in question.motion.scope.rates:  # on the way all states are met, not those alone of which the claim tells
        given = given.with_range(name, *declared.range_of(name), declared.sides_of(name))
    with suppress(Undecided, ZeroDivisionError):
        for order in range(MOST_RATES + 1):
            if not compare(NOTHING, question.begin(gap), given, strict=strict and not order and not later).is_proved:
                return False
            gap = question.rate(gap)
            ways = (way for [way], _ in on_path((question.seen(gap, "start"),), question.motion))
            if all(compare(NOTHING, way, given, strict=later).is_proved for way in ways):
                return True
    return False


def _below(pair: tuple[Scalar, ...], question: EqualityQuestion, *, strict: bool) -> Verdict:
    """Whether the first is below the second as they stand, or in normal form."""
    low, high = _squared([without_even_roots(value) for value in pair], question)
    found = compare(low, high, question.motion.assumptions, strict=strict)
    if found.is_proved:
        return found
    return compare(NOTHING, _in_normal_form(high - low), question.motion.assumptions, strict=strict)


def _in_normal_form(value: Scalar) -> Scalar:
    """The value with numerator and denominator in sines and cosines of the same angles."""
    bases = bases_of(value.num + value.den)
    return quotient(normal(value.num, bases), normal(value.den, bases))


def _squared(pair: list[Scalar], question: EqualityQuestion) -> list[Scalar]:
    """The squares of two roots that are not negative, which are ordered as these."""
    rooted = [any(atoms.atom(index).kind == "root" for index in value.atoms()) for value in pair]
    if all(rooted) and all(sign(value, question.motion.assumptions).is_nonnegative for value in pair):
        return [without_even_roots(value * value) for value in pair]
    return pair


def different(a: Scalar | Space, b: Scalar | Space, question: EqualityQuestion) -> Verdict:
    """Whether a is not identically b: there is a state in which they differ."""
    found = equal_values(a, b, question)
    if found.is_refuted:
        return proved(f"they differ {found.witness}")
    if found.is_proved:
        return undecided(f"they are equal: {found.how}")
    return found


def equal_to_first_order(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """a ≈ b for small values of what is said to be small, or of one coordinate, with its speed, in which they differ, or of all
    of them; at any depth."""
    if question.ground.small == ("t",):
        return _in_time(a, b, question)
    found = undecided("nothing was tried")
    for depth in question.depths:
        sides = [question.seen(side, depth) for side in (a, b)]
        moving = [name for name in question.motion.scope.start if depends_on(sides[0] - sides[1], name)]
        each: dict[str, list[str]] = {name.removesuffix("_dot"): [] for name in moving}
        for name in moving:
            each[name.removesuffix("_dot")].append(name)
        said = [name for name in (*question.ground.small, *moving) if name.removesuffix("_dot") in question.ground.small]
        for small in (said,) if said else (*each.values(), moving) if len(each) != 1 else (moving,):
            found = to_first_order(sides, small, question)
            if found.is_proved:
                first = f"equal to first order in {' and '.join(small)}" if small else ""
                return proved(", ".join(filter(None, (HOW[depth] if depth != "identity" or not small else "", first))))
    for name in names_of([a - b]):
        if to_first_order([a, b], [name], question).is_proved and has_slopes([a, b], [name]):
            return undecided(f"it holds to first order in {name}, of which it is not said that it is small")
    return undecided("it is not said what is small beside the time") if mixes_clock(a - b, question.motion) else found


def _in_time(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """a ≈ b for small times: to first order, and in the first rate that does not vanish at the start; a side that stays as it
    is says nothing of higher ones."""
    is_told = False
    for order, of in enumerate(ORDERS):
        x, y = (question.begin(value) for value in (a, b))
        if not are_same(x, y, question):
            if order > 1 and is_told and NOTHING in (x, y):
                return proved("equal to first order in t")
            found = witness_of(x, y, question.motion.assumptions)
            return found if found.witness is None else replace(found, witness=replace(found.witness, of=of))
        if order and x:
            return proved(f"equal to order {order} in t")
        is_told, a, b = is_told or bool(x), question.rate(a), question.rate(b)
    return undecided("neither side changes with the time to third order")


def to_first_order(sides: list[Scalar], small: list[str], question: EqualityQuestion) -> Verdict:
    """Whether two values and their slopes are equal where all that is small vanishes."""
    at = dict.fromkeys(small, NOTHING)
    rows = [sides, *([derivative(side, name) for side in sides] for name in small)]
    try:
        pairs = [[substitute(value, at) for value in row] for row in rows]
    except ZeroDivisionError:
        return undecided(f"there is no value where {' and '.join(small)} vanish")
    return all_of(scalars_equal(one, other, question.motion.assumptions) for one, other in pairs)


def has_slopes(sides: list[Scalar], small: list[str]) -> bool:
    """Whether one of them has a first order in what is small."""
    at = dict.fromkeys(small, NOTHING)
    return any(substitute(derivative(side, name), at) for side in sides for name in small)


RELATIONS: dict[str, Callable[..., Verdict]] = {
    "=": lambda a, b, op, question: equal_values(a, b, question), "!=": lambda a, b, op, question: different(a, b, question),
    "~": lambda a, b, op, question: equal_to_first_order(a, b, question), **dict.fromkeys(("<", "<=", ">", ">="), ordered),
}  # fmt: skip
