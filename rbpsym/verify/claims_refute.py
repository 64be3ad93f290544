"""States of the motion at which two values differ: the witnesses of a refutation.

The start is a state; any position and speed is one, if nothing is said of the start; else the
speeds are those of the motion from the start. Where a speed remains, both signs are excluded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from fractions import Fraction

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.integration import definite
from rbpsym.algebra.poly import ONE
from rbpsym.algebra.scalar import NOTHING, Scalar, show, symbol
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.decide import find_witness
from rbpsym.equality.domain import Condition
from rbpsym.equality.enclosure import Number, are_disjoint, sign_of
from rbpsym.equality.verdict import Kind, Verdict, refuted, undecided
from rbpsym.errors import RbpsymError, Undecided
from rbpsym.mechanics.motion import along_motion, with_squares
from rbpsym.notation import tree as t
from rbpsym.verify.claims_bound import Motion
from rbpsym.verify.claims_question import Question, holds_unknowns, tells_of_start

PARTS = (Fraction(1, 10), Fraction(1, 2), Fraction(9, 10))


def refutation(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """A state of the motion at which the sides differ."""
    moves = any(depends_on(value, name) for value in (a, b) for name in question.motion.scope.rates)
    if question.motion.is_tied and (moves or any(holds_unknowns(value, question) for value in (a, b))):
        return undecided("the coordinates are tied by conditions that are not solved in closed form")
    for find in (_at_start, _at_any_state, _along):
        with suppress(ZeroDivisionError, Undecided):
            found = find(a, b, question)
            if found.is_refuted:
                return found
    return undecided("neither a proof nor a state of the motion at which the sides differ was found")


def witness_of(
    a: Scalar,
    b: Scalar,
    assumptions: Assumptions,
    domain: Iterable[Condition] = (),
    differ: Callable[[Number, Number], bool] = are_disjoint,
) -> Verdict:
    """REFUTED with a point at which the values differ (or are not ordered), UNDECIDED if none is found."""
    try:
        point = find_witness(a, b, assumptions, domain, differ)
    except (RbpsymError, ZeroDivisionError):
        point = None
    return refuted("the sides differ at a point", point) if point else undecided("no point was found")


def _at_start(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """The start is a state of the motion; only tried where start values or integrals are told."""
    if not (tells_of_start(a, question) or tells_of_start(b, question)):
        return undecided("")
    x, y = question.begin(a), question.begin(b)
    return undecided("") if holds_unknowns(x - y, question) else witness_of(x, y, question.motion.assumptions)


def _at_any_state(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """Every position and speed is a state of some motion, if nothing is said of the start."""
    if tells_of_start(a, question) or tells_of_start(b, question):
        return undecided("")
    x, y = (question.seen(v, "motion") for v in (a, b))
    if holds_unknowns(x, question) or holds_unknowns(y, question):
        return undecided("")
    return witness_of(x, y, question.motion.assumptions)


def _along(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """Values along the motion, integrals carried out; else the rates of both sides."""
    x, y = (carried_out(v, question) for v in (a, b))
    if x is not None and y is not None:
        found = _differ(x, y, question)
        if found.is_refuted:
            return found
    return _differ(*(question.seen(question.rate(v), "start") for v in (a, b)), question)


def _differ(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """Where a speed remains, both signs of its root are excluded: (a - b)(a' - b') is not zero."""
    squares = question.motion.squares
    left, right, gap = a, b, a - b
    for name, square in squares.items():
        speed = f"{name}_dot"
        if depends_on(gap, speed):
            slope = derivative(gap, speed)
            rest = substitute(gap, {speed: NOTHING})
            gap = with_squares(rest * rest - slope * slope * square, squares)
            left, right = rest * rest, with_squares(slope * slope * square, squares)
    if _mixes_clock(gap, question.motion):
        return undecided("the coordinates are functions of the time that are not known in closed form")
    bound_speeds = not question.motion.is_free and any(_is_speed(index) for index in gap.atoms())
    if bound_speeds or holds_unknowns(gap, question):
        return undecided("")
    found = witness_of(left, right, question.motion.assumptions, _reachable(question))
    return found if found.is_refuted else witness_of(left, right, question.motion.assumptions)


def _mixes_clock(gap: Scalar, motion: Motion) -> bool:
    """Does it hold the time beside coordinates or speeds? On the motion from the start these are no longer free."""
    clock = "t" in motion.scope.rates and depends_on(gap, "t")
    return clock and any(depends_on(gap, n) or depends_on(gap, f"{n}_dot") for n in motion.scope.rates if n != "t")


def _is_speed(index: int) -> bool:
    name = atoms.symbol_name(index)
    return bool(name) and name.endswith(("_dot", "_ddot"))


def carried_out(value: Scalar, question: Question) -> Scalar | None:
    """The value along the motion with every work and integral in closed form; None if one has none."""
    images: dict[str, Scalar] = {}
    for name, power in question.motion.ledger.items():
        if depends_on(value, name):
            done = work_done(power, question.motion)
            if done is None:
                return None
            images[name] = done
    return question.seen(substitute(value, images), "start")


def work_done(power: Scalar, motion: Motion) -> Scalar | None:
    """∫ power dt from the start over the one coordinate along which it is done; None without a closed form."""
    known = motion.moved(power)
    for name in motion.scope.start:
        speed = f"{name}_dot"
        if not depends_on(known, speed) or name not in motion.scope.rates:
            continue
        integrand = along_motion(substitute(known / symbol(speed), {}), motion.squares)
        if integrand is None or (integrand.den is not ONE and depends_on(Scalar(integrand.den), name)):
            return None
        return definite(integrand, name, motion.scope.start[name], symbol(name))
    return None


def disorder(low: Scalar, high: Scalar, question: Question, *, strict: bool) -> Verdict:
    """A state of the motion in which low is not below high.

    Any position is one, if nothing is said of speeds and of the start; else the squares of the speeds
    are those of the motion from the start, and not negative there.
    """
    motion, domain = question.motion, []
    pair = [question.seen(value, "motion") for value in (low, high)]
    if not motion.is_free and any(tells_of_start(v, question) or _holds_speed(v) for v in pair):
        pair = [question.seen(value, "start") for value in pair]
        domain = _reachable(question)
    if motion.is_tied or any((_holds_speed(v) and not motion.is_free) or holds_unknowns(v, question) for v in pair):
        return undecided("the sign of the difference is not known for the motion from the start")
    signs = (0, 1) if strict else (1,)
    found = witness_of(*pair, motion.assumptions, domain, lambda x, y: sign_of(x - y) in signs)
    return found if found.is_refuted else _inside_ranges(pair, motion.assumptions, domain, signs)


def _inside_ranges(pair: list[Scalar], assumptions: Assumptions, domain: list[Condition], signs: tuple) -> Verdict:
    """Where a name has a range between other quantities, numbers alone hardly meet it: at parts of that range."""
    for name, (lower, upper) in assumptions.ranges.items():
        if not any(bound is not None and bound.atoms() for bound in (lower, upper)):
            continue
        for place, condition in _parts_of(lower, upper):
            image = {name: place}
            moved = [Condition(c.node, c.op, substitute(c.value, image)) for c in domain]
            sides = [substitute(value, image) for value in pair]
            found = witness_of(
                *sides, assumptions.without(name), [*moved, condition], lambda x, y: sign_of(x - y) in signs
            )
            if found.is_refuted:
                return Verdict(Kind.REFUTED, reason=f"where {name} is {show(place)}: {found.witness}")
    return undecided("no point was found")


def _parts_of(lower: Scalar | None, upper: Scalar | None) -> Iterator[tuple[Scalar, Condition]]:
    """Places in a range, with the condition that there is room for them."""
    for part in PARTS:
        if lower is not None and upper is not None:
            yield lower + (upper - lower) * part, Condition(t.ZERO, ">", upper - lower)
        elif lower is not None:
            yield lower * (part + 1), Condition(t.ZERO, ">", lower)
        elif upper is not None:
            yield upper * (1 - part), Condition(t.ZERO, ">", upper)


def _holds_speed(value: Scalar) -> bool:
    return any(_is_speed(index) for index in value.atoms())


def _reachable(question: Question) -> list[Condition]:
    """The squares of the speeds are not negative."""
    squares = question.motion.squares.items()
    return [Condition(t.Sym(f"{name}_dot"), ">=", square) for name, square in squares]
