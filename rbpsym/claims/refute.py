"""States of the motion at which two values differ: the witnesses of a refutation.

The start is a state; so is each place on the way from the start until the motion first comes to rest, with the
speed that it has there. Where no start is declared, or the speeds are no functions of the place and nothing is
said of the start, any position and speed is a state of some motion.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

from rbpsym.claims.ground import EqualityQuestion, holds_unknowns, tells_of_start
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import Condition
from rbpsym.decide.enclosure import Number, are_disjoint, sign_of
from rbpsym.decide.equal import find_witness
from rbpsym.decide.verdict import Kind, Verdict, refuted, undecided
from rbpsym.errors import RbpsymError, Undecided
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, atoms, depends_on, names_in, show, substitute, symbol
from rbpsym.quantity.bound import Motion
from rbpsym.quantity.path import Path, on_path, path_of, reachable, sense, with_energy, work_done

ORDERS = ("at the start", "rates of change at the start", "second rates at the start", "third rates at the start")
PARTS = (Fraction(1, 10), Fraction(1, 2), Fraction(9, 10))


def refutation(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """A state of the motion at which the sides differ."""
    moves = any(depends_on(value, name) for value in (a, b) for name in question.motion.scope.rates)
    if question.motion.is_tied and (moves or any(holds_unknowns(value, question) for value in (a, b))):
        return undecided("the coordinates are tied by conditions that are not solved in closed form")
    if moves and is_timed(question):
        return undecided(OF_TIME)
    for find in (_at_start, _at_any_state, _along, _in_rates_at_start, _on_other_motions):
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
    path: Path | None = None,
) -> Verdict:
    """REFUTED with a point at which the values differ (or are not ordered), UNDECIDED if none is found."""
    try:
        point = find_witness(a, b, assumptions, domain, differ, path=path)
    except (RbpsymError, ZeroDivisionError):
        point = None
    return refuted("the sides differ at a point", point) if point else undecided("no point was found")


def _at_start(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """The start is a state of the motion; only tried where start values or integrals are told."""
    if not (tells_of_start(a, question) or tells_of_start(b, question)):
        return undecided("")
    x, y = question.begin(a), question.begin(b)
    given = question.motion.assumptions
    return undecided("") if holds_unknowns(x - y, question) else witness_of(x, y, given, _pushing(question))


def begun_within(question: EqualityQuestion) -> list[Condition]:
    """What the conditions of a claim, ranges of what changes, ask of the start for it to be a state of which the claim tells."""
    given, found = question.motion.assumptions, list[Condition]()
    for name, value in question.motion.scope.start.items() if question.ground.assumed is not None else ():
        for side, end in enumerate(given.range_of(name)):
            gap, op = (None if end is None else (value - end) * (1 - 2 * side)), ">=" if side in given.sides_of(name) else ">"
            found += [] if gap is None else [Condition(t.Sym(name), op, gap)]
    return found


def _pushing(question: EqualityQuestion) -> list[Condition]:
    """At the start: those of the claim, and that contacts push."""
    return [*begun_within(question), *(replace(c, value=question.begin(c.value)) for c in question.motion.pushed())]


def _pushing_there(motion: Motion, is_moving: bool) -> list[Condition]:
    """That contacts push: at the place of which a claim tells; of what is constant only what is so at all places."""
    return [c for c in motion.pushed() if is_moving or not names_in(c.value) & {*motion.scope.rates, *motion.speeds}]


def is_timed(question: EqualityQuestion) -> bool:
    """Whether a condition of the claim is one on the time: which places are met then is not looked for."""
    return question.ground.assumed is not None and question.ground.assumed.range_of("t") != (None, None)


OF_TIME = "where the motion is at these times is not known in closed form"


def _at_any_state(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """Where no path is known and nothing is said of the start: any position and speed that has the energy of the start."""
    motion = question.motion
    if tells_of_start(a, question) or tells_of_start(b, question):
        return undecided("")
    x, y = (question.seen(v, "motion") for v in (a, b))
    if holds_unknowns(x, question) or holds_unknowns(y, question) or path_of((x, y), motion).names:
        return undecided("")
    if not _may_be_met((x, y), motion):
        return undecided("")
    is_moving = any(depends_on(v, name) for v in (x, y) for name in motion.scope.rates)
    kept = (*(motion.kept if is_moving else ()), *_pushing_there(motion, is_moving))
    for pair, domain in with_energy((x, y), motion):
        found = witness_of(pair[0], pair[1], motion.assumptions, [*domain, *kept])
        if found.is_refuted:
            return found
    return undecided("")


def _may_be_met(values: Iterable[Scalar], motion: Motion) -> bool:
    """Whether values that are no functions of one place may be had on the motion: the start gives what changes in them a value
    of its own, which is free, and of which they do not tell themselves."""
    held = {name for value in values for name in names_in(value)}
    names = held & motion.scope.rates.keys()
    starts = {motion.scope.start.get(name) for name in names}
    own = {name for start in starts if start is not None for name in names_in(start)} - held
    return motion.is_free or (len(starts) == len(names) and own <= motion.starts and starts == set(map(symbol, own)))


def _on_other_motions(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """Where it is demanded of all motions, and not of the one from the start alone: any position and speed."""
    if "start" in question.depths:
        return undecided("")
    x, y = (question.seen(value, question.depths[-1]) for value in (a, b))
    return undecided("") if holds_unknowns(x - y, question) else witness_of(x, y, question.motion.assumptions)


def _in_rates_at_start(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """What stays equal along the motion has equal rates of change at the start, of each order."""
    for order in ORDERS:
        x, y = (question.begin(value) for value in (a, b))
        if not holds_unknowns(x, question) and not holds_unknowns(y, question):
            found = witness_of(x, y, question.motion.assumptions, _pushing(question))
            if found.witness is not None:
                return replace(found, witness=replace(found.witness, of=order))
        a, b = (question.rate(value) for value in (a, b))
    return undecided("")


def _along(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """Values along the motion, integrals carried out; else the rates of both sides."""
    x, y = (carried_out(v, question) for v in (a, b))
    if x is not None and y is not None:
        found = _differ(x, y, question)
        if found.is_refuted:
            return found
    rates = [question.seen(question.rate(value), "start") for value in (a, b)]
    found = _differ(rates[0], rates[1], question)
    return found if found.witness is None else replace(found, witness=replace(found.witness, of="rates of change"))


def _differ(a: Scalar, b: Scalar, question: EqualityQuestion) -> Verdict:
    """Where both are known as functions of one place on the path: a place at which they differ."""
    motion, path = question.motion, path_of((a, b), question.motion)
    if mixes_clock(a - b, motion):
        return undecided("the coordinates are functions of the time that are not known in closed form")
    if len(path.names) > 1:
        return undecided("how the coordinates are passed at one time is not known in closed form")
    for pair, when in on_path((a, b), motion):
        if holds_unknowns(pair[0] - pair[1], question) or (not motion.is_free and any(map(_holds_speed, pair))):
            continue
        pushing = _pushing_there(motion, bool(path.names))
        found = witness_of(pair[0], pair[1], motion.assumptions, [*reachable(motion), *pushing, *when], path=path)
        if found.is_refuted:
            return found
    return undecided("")


def mixes_clock(gap: Scalar, motion: Motion) -> bool:
    """Does it hold the time beside coordinates or speeds? On the motion from the start these are no longer free."""
    clock = "t" in motion.scope.rates and depends_on(gap, "t")
    return clock and any(depends_on(gap, n) or depends_on(gap, f"{n}_dot") for n in motion.scope.rates if n != "t")


def _is_speed(index: int) -> bool:
    name = atoms.symbol_name(index)
    return name is not None and name.endswith(("_dot", "_ddot"))


def carried_out(value: Scalar, question: EqualityQuestion) -> Scalar | None:
    """The value along the motion with every work and integral in closed form; None if one has none."""
    images: dict[str, Scalar] = {}
    for name, power in question.motion.ledger.items():
        if depends_on(value, name):
            done = work_done(power, question.motion)
            if done is None:
                return None
            images[name] = done
    return question.seen(substitute(value, images), "start")


def disorder(low: Scalar, high: Scalar, question: EqualityQuestion, *, strict: bool) -> Verdict:
    """A state of the motion in which low is not below high.

    Any position is one, if no path is known; else the places on it, with the speeds that the motion has there.
    """
    motion, signs = question.motion, (0, 1) if strict else (1,)
    values = tuple(question.seen(value, "motion") for value in (low, high))
    path = path_of(values, motion)
    if motion.is_tied or any(holds_unknowns(value, question) for value in values):
        return undecided("the sign of the difference is not known for the motion from the start")
    begun = [question.begin(value) for value in values]
    within = begun_within(question)
    found = witness_of(begun[0], begun[1], motion.assumptions, within, lambda x, y: sign_of(x - y) in signs)
    if found.witness is not None:
        return replace(found, witness=replace(found.witness, of=ORDERS[0]))
    if is_timed(question) and any(depends_on(value, name) for value in values for name in motion.scope.rates):
        return undecided(OF_TIME)
    if mixes_clock(values[0] - values[1], motion) or (not path.names and not _may_be_met(values, motion)):
        return undecided("the sign of the difference is not known for the motion from the start")
    for pair, when in on_path(tuple(question.seen(value, "start") for value in values), motion):
        if any(map(_holds_speed, pair)) and not motion.is_free:
            return undecided("the sign of the difference is not known for the motion from the start")
        domain = [*(reachable(motion) if path.names else motion.kept), *when]
        found = witness_of(pair[0], pair[1], motion.assumptions, domain, lambda x, y: sign_of(x - y) in signs, path)
        if not found.is_refuted:
            found = _inside_ranges(pair, _up_to_rest(path), domain, signs, path)
        if found.is_refuted:
            return found
    return found


def _up_to_rest(path: Path) -> Assumptions:
    """With the range from the start to where the square of a speed vanishes, of a coordinate in which that is linear."""
    given = path.motion.assumptions
    for name in path.names:
        parts = path.motion.squares[name].num.by_power(atoms.intern("symbol", name))
        if set(parts) == {0, 1}:
            ends = (path.motion.scope.start[name], -(Scalar(parts[0]) / Scalar(parts[1])))
            given = given.with_range(name, *(ends if sense(path.motion, name) >= 0 else ends[::-1]))
    return given


def _inside_ranges(
    pair: tuple[Scalar, ...], assumptions: Assumptions, domain: list[Condition], signs: tuple[int, ...], path: Path
) -> Verdict:
    """Where a name has a range between other quantities, numbers alone hardly meet it: at parts of that range."""
    for name, (lower, upper) in assumptions.ranges.items():
        if not any(bound is not None and bound.atoms() for bound in (lower, upper)):
            continue
        for place, condition in _parts_of(lower, upper):
            image = {name: place}
            moved = [Condition(c.node, c.op, substitute(c.value, image)) for c in domain]
            sides, way = [substitute(value, image) for value in pair], replace(path, at=image)
            found = witness_of(
                sides[0], sides[1], assumptions.without(name), [*moved, condition], lambda x, y: sign_of(x - y) in signs, way
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
