"""Checks of what holds at the start: conditions expanded in the time from there, laws with the start put in."""

from __future__ import annotations

from rbpsym.algebra import NOTHING, Scalar, derivative, names_in, substitute, symbol
from rbpsym.derivation.checks import agree, relations, same, weakest
from rbpsym.derivation.context import Context
from rbpsym.derivation.facts import MOTION, law_rows
from rbpsym.derivation.step import Step
from rbpsym.equality.verdict import UNDECIDED, Verdict
from rbpsym.statement.scope import CLOCK

MOMENT = "time_since_the_start"


def _gap(context: Context, step: Step) -> Scalar:
    [(left, _, right)] = list(relations(step.statement))
    return context.value(left) - context.value(right)


def kept_condition(context: Context, step: Step) -> Verdict:
    """What is stated, times a positive constant, is a condition of the constraint (`data`: "constraint", "factor")."""
    context.use(MOTION)
    system, stated = context.study.system, _gap(context, step) * step.data["factor"]
    kept = (c.value for c in (*system.implicit, *system.speed_ties) if c.constraint == step.data["constraint"])
    return next((found for value in kept if (found := same(context, value, stated)).is_proved), NOT_KNOWN)


NOT_KNOWN = Verdict(UNDECIDED, reason="it is not among what is known at the start")


def rate_at_start(context: Context, step: Step) -> Verdict:
    """The derivative of that order of a condition, expanded from the start (`data`: "of", "order", "factor")."""
    context.use(step.data["of"])
    value = _expanded(context, _gap(context, context.steps[step.data["of"]]))
    for _ in range(step.data["order"]):
        value = derivative(value, MOMENT)
    found = substitute(value, {MOMENT: NOTHING})
    return agree(context, found, _gap(context, step) * step.data["factor"], "motion")


def _expanded(context: Context, value: Scalar) -> Scalar:
    """A value with q + q̇ t + q̈ t²/2 from the start for every coordinate."""
    moment, images, held = symbol(MOMENT), {CLOCK: symbol(MOMENT)}, names_in(value)
    for name in context.study.system.coordinates:
        if held & {name, f"{name}_dot"}:
            place, speed, gain = (context.start(symbol(f"{name}{tail}")) for tail in ("", "_dot", "_ddot"))
            images |= {name: place + speed * moment + gain * moment * moment / 2, f"{name}_dot": speed + gain * moment}
    return substitute(value, images)


def law_at_start(context: Context, step: Step) -> Verdict:
    """Each relation is one of the equations of a law where the motion starts, up to its sign (`data`: "law")."""
    context.use(step.data["law"])
    rows = [context.start(row) for row in law_rows(context.whole, context.facts[step.data["law"]])]
    found = []
    for left, _, right in relations(step.statement):
        gap = context.value(left) - context.value(right)
        verdicts = (agree(context, row, way, "motion") for row in rows for way in (gap, -gap))
        found.append(next((verdict for verdict in verdicts if verdict.is_proved), NOT_KNOWN))
    return weakest(found)
