"""Checks that a system can be where it is said to rest: contacts push, strings pull, friction and ranges allow it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain, product

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import IMPLIED, Condition, conditions
from rbpsym.decide.equal import compare, refuted_only_where
from rbpsym.decide.rooted import neat, over_growth, sign_along
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import PROVED, Verdict, proved, undecided
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, PI, ZERO, Scalar, cosine, depends_on, is_zero, quotient, sine, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.field.roots import with_image, with_root_taken_out, without_even_roots
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.events import pushes, taken
from rbpsym.proof.checks.of_steps import along_motion, weakest
from rbpsym.proof.context import Context
from rbpsym.proof.step import Step


def under(context: Context, step: Step, *ops: str) -> Context:
    """The context in which the printed conditions of the step are met (those with these operators; else all)."""
    demands = [demand for demand in demanded(context, step) if demand.op in (ops or (demand.op,))]
    return replace(context, assumed=assuming(context.assumptions, demands, tighter=True, whole=True)) if demands else context


def demanded(context: Context, step: Step) -> list[Demand]:
    """The conditions that the step prints."""
    found = [relation for node in step.obligations for relation in t.relations(node)]
    demands = (Demand(context.value(left) - context.value(right), op) for left, op, right in found)
    return [demand for demand in demands if demand.value]


def stays(context: Context, step: Step) -> Verdict:
    """The stated sign, in each position; else where no square of a speed is negative, nor a force that is lost first, B:
    the force is a B + c with a not negative and c positive, or not negative if ≥ is stated (`data`: "until")."""
    found, until = along_motion(context, step), step.data["until"]
    if found.is_proved:
        return found
    [(left, op, _)] = t.relations(step.statement)
    value = context.along(context.value(left))
    bounds = [context.along(symbol(until))] if until else list(context.study.squares.values())
    for name in () if until else context.study.squares.keys() & {id.removeprefix("square.") for id in context.steps}:
        context.use(f"square.{name}")
    if any(is_kept(value, bound, context.assumptions, op) for bound in bounds):
        return proved("it is more than a multiple of what is not negative")
    begins = sign(context.start(value), context.assumptions).kind == "positive"
    if begins and any(_is_not_met(value, bound, context.assumptions) for bound in bounds):
        return proved("it has the sign at the start, and the motion never comes to where it vanishes")
    if found.is_refuted and bounds:  # there, perhaps, the motion never comes
        return undecided("whether it keeps its sign where the motion goes is not decided")
    return found


def is_kept(value: Scalar, bound: Scalar, given: Assumptions, op: str) -> bool:
    """Whether the value is more (by what is op 0) than a multiple, not negative, of what is bound not to be negative."""
    for index in bound.num.atoms():
        parts = bound.num.by_power(index)
        if set(parts) in ({1}, {0, 1}):
            edge = -(Scalar(parts.get(0, ZERO)) / Scalar(parts[1]))
            rest = with_image(value.num, index, edge) / with_image(value.den, index, edge)
            more = (value - rest) / bound
            if IMPLIED[op](sign(rest, given)) and sign(more, given).is_nonnegative:
                return True
    return False


def _is_not_met(value: Scalar, bound: Scalar, given: Assumptions) -> bool:
    """Where the value vanishes the bound is negative."""
    for index in value.num.atoms():
        parts = value.num.by_power(index)
        if set(parts) == {0, 1} and sign(Scalar(parts[1]), given).is_nonzero:
            edge = -(Scalar(parts[0]) / Scalar(parts[1]))
            there = with_image(bound.num, index, edge) / with_image(bound.den, index, edge)
            if sign(there, given).kind == "negative":
                return True
    return False


def has_sign_of_force(context: Context, step: Step) -> Verdict:
    """What is stated not to be negative is the force, but for a positive factor (`data`: "force")."""
    [(left, op, right)] = t.relations(step.statement)
    more, less = (left, right) if op == ">=" else (right, left)
    force, value = (context.along(v) for v in (symbol(step.data["force"]), context.value(more) - context.value(less)))
    force = with_root_taken_out(Scalar(force.num)) / Scalar(force.den)  # as its condition is printed
    return compare(NOTHING, force / value, context.assumptions)


def can_rest(context: Context, step: Step) -> Verdict:
    """The stated place exists, lies within the ranges, and no force there has the wrong sense (`data`: "at")."""
    context, printed = under(context, step), demanded(context, step)
    nothing = proved("no range, no one-sided force and no limit of friction forbids it")
    with refuted_only_where(Condition(t.ZERO, demand.op, demand.value) for demand in printed):
        return weakest([nothing, *_exists(context, step, printed), *_within(context, step), *_holds(context, step, printed)])


def comes_first(context: Context, step: Step) -> Verdict:
    """From the start to the stated place (without one: to the end of the range, where the force has changed its sign)
    the speed does not vanish and all one-sided forces keep their sign (`data`: "name", "at", "force")."""
    context, name = under(context, step, ">"), step.data["name"]
    ends = [step.data["at"][name]] if step.data["at"] else context.assumptions.range_of(name)
    return next((v for end in ends if end is not None and (v := _first(context, step, end)).is_proved), UNSEEN)


UNSEEN = undecided("it is not decided whether the motion comes there first")


def _first(context: Context, step: Step, end: Scalar) -> Verdict:
    name, given = step.data["name"], context.assumptions
    goes, between = way_to(context, name, end)
    lost = context.along(symbol(step.data["force"]))
    at_start, there = (substitute(lost, {name: place}) for place in (context.start(symbol(name)), end))
    changed = [(NOTHING, at_start, given, False), *([] if step.data["at"] else [(there, NOTHING, given, True)])]
    system = context.study.system
    forces = [context.along(symbol(n)) for e in system.problem.constraints for n in pushes(e)]
    kept = [value for value in forces if step.data["at"] or not is_zero(value - lost)]
    ordered = (*changed, *((NOTHING, value, between, True) for value in kept))
    return weakest(chain(goes, (compare(low, high, where, strict=strict) for low, high, where, strict in ordered)))


def way_to(
    context: Context, name: str, end: Scalar, printed: Sequence[Demand] = ()
) -> tuple[Iterator[Verdict], Assumptions]:
    """Whether the motion sets out for a place and comes there without a halt, one verdict after another, and what holds on the
    way; where the square of its speed rises or falls all the way, it is enough that this is not negative at the end, as is
    `printed`."""
    given = context.assumptions
    begin, speed = (context.start(symbol(key)) for key in (name, f"{name}_dot"))
    drive = speed if not is_zero(speed) else context.start(context.on_motion(symbol(f"{name}_ddot")))
    side = sign(drive, given).sense or (1 if _beyond(context, begin, end).is_proved else -1)
    lower, upper = (begin, end) if side > 0 else (end, begin)
    between = given.with_range(name, lower, upper)

    def verdicts() -> Iterator[Verdict]:
        yield _beyond(context, lower, upper, printed)
        yield compare(NOTHING, drive * side, given, strict=False)
        square = context.study.squares[name]
        goes = compare(NOTHING, square, between)
        if not goes.is_proved:
            is_kept = sign_along(square, name, between, lambda value: _follows(Demand(value, ">="), [*printed], given)) > 0
            goes = proved("from its slope on the way") if is_kept else goes
        yield goes

    return verdicts(), between


def _exists(context: Context, step: Step, printed: list[Demand]) -> Iterator[Verdict]:
    for _, _, right in t.relations(step.statement):
        for condition in conditions(right, context.scope):
            met = IMPLIED[condition.op](sign(condition.value, context.assumptions))
            met = met or _follows(Demand(condition.value, condition.op), printed, context.assumptions)
            yield Verdict(PROVED) if met else undecided("whether the place exists is not decided")


def _follows(asked: Demand, printed: list[Demand], given: Assumptions) -> bool:
    """It is a multiple of what is printed, by a factor of which the sign is known."""
    told = neat(asked.value, given)  # as a value is told, and the condition that is made of it
    ways = (told, neat(told, given), over_growth(told) or told)
    for value, demand in product(ways, printed):
        above, below = value.num * demand.value.den, value.den * demand.value.num
        factor = sign(quotient(above, below), given)
        if demand.op in (">", asked.op) and (factor.is_nonzero if asked.op == "!=" else factor.kind == "positive"):
            return True
    return False


def _within(context: Context, step: Step) -> Iterator[Verdict]:
    tied = {n: substitute(v, step.data["at"]) for n, v in context.study.system.dependent.items()}
    closed = {n: v for n, v in tied.items() if not any(depends_on(v, q) for q in context.study.system.coordinates)}
    for name, place in {**step.data["at"], **closed}.items():
        if name in context.whole.assumptions.ranges:
            context.use(f"range.{name}")
        lower, upper = context.assumptions.range_of(name)
        is_whole = lower is not None and upper is not None and is_zero(upper - lower - PI * 2)
        is_turned = upper is not None and is_whole and is_zero(upper - place)
        for low, high in ((lower, place), (place, None if is_turned else upper)):  # the end of a turn is its beginning
            if low is not None and high is not None:
                found = _beyond(context, low, high)
                is_end = not found.is_proved and is_zero(low - high)  # an end belongs to the range if the start is there
                yield Verdict(PROVED) if is_end and is_zero(context.start(own_place(context, name)) - place) else found


def own_place(context: Context, name: str) -> Scalar:
    """A coordinate in terms of the free ones."""
    return context.study.system.dependent.get(name, symbol(name))


def _beyond(context: Context, low: Scalar, high: Scalar, printed: Sequence[Demand] = ()) -> Verdict:
    """low < high; for angles of one half turn by their cosines or sines, and what is printed."""
    found = compare(low, high, context.assumptions)
    for wave, first, sense in ((cosine, NOTHING, -1), (cosine, -PI, 1), (sine, -PI / 2, 1)):
        ends = [(first, low), (first, high), (low, first + PI), (high, first + PI)]
        if not found.is_proved and all(compare(a, b, context.assumptions, strict=False).is_proved for a, b in ends):
            follows = _follows(Demand((wave(high) - wave(low)) * sense), [*printed], context.assumptions)
            return Verdict(PROVED) if follows else compare(wave(low) * sense, wave(high) * sense, context.assumptions)
    return found


def _holds(context: Context, step: Step, printed: list[Demand]) -> Iterator[Verdict]:
    system = context.study.system
    still = dict.fromkeys((*system.speeds, *system.accelerations), NOTHING)

    def here(name: str) -> Scalar:
        value = substitute(context.on_motion(symbol(name)), still)
        return without_even_roots(substitute(value, step.data["at"]))

    def met(asked: Demand) -> Verdict:
        if _follows(asked, printed, context.assumptions):
            return Verdict(PROVED)
        return compare(NOTHING, asked.value, context.assumptions, strict=asked.op == ">")

    for _, value in taken(system):
        there = without_even_roots(substitute(value, step.data["at"]))
        yield from () if any(depends_on(there, n) for n in system.coordinates) else [met(Demand(there))]
    for element in system.problem.constraints:
        for name in pushes(element):
            yield met(Demand(here(name), ">="))
        if element.values.get("limit") is not None:
            grip, most = here(element["friction"]), sum(map(here, element.normals), NOTHING) * scalar(element["limit"])
            for side in (grip, -grip):
                yield compare(side, most, context.assumptions, strict=False)
