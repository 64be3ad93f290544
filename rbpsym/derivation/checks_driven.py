"""Checks of when a coordinate that an equation with the time ties has a value, and of the state then: by the equation itself."""

from __future__ import annotations

from rbpsym.algebra import NOTHING, Scalar, depends_on, derivative, substitute, symbol
from rbpsym.algebra.evaluate import scalar
from rbpsym.derivation.checks_places import UNSEEN, own_place
from rbpsym.derivation.context import Context
from rbpsym.equality.decide import compare, scalars_equal
from rbpsym.equality.signs import sign
from rbpsym.equality.verdict import Verdict
from rbpsym.statement.model import Phase


def is_driven(context: Context, phase: Phase | None) -> bool:
    """Whether a phase ends where such a coordinate has a value."""
    is_alone = phase is not None and phase.event == "reaches" and not context.study.system.independent
    return is_alone and any(depends_on(tie.value, phase.subject) for tie in context.study.ties)


def left_then(context: Context, phase: Phase) -> Scalar:
    """What vanishes at the moment, as a function of the time."""
    return substitute(_tie(context, phase.subject), {phase.subject: scalar(phase.value)})


def _tie(context: Context, name: str) -> Scalar:
    [found] = [tie.value for tie in context.study.ties if depends_on(tie.value, name)]
    return found


def comes_there(context: Context, phase: Phase) -> Verdict:
    """The value lies ahead of the start, in the sense of a speed that keeps its sign all the way."""
    begin, end = context.start(symbol(phase.subject)), scalar(phase.value)
    speed = context.study.system.scope.rates[phase.subject]
    between = (context.assumptions.with_range(phase.subject, *ends) for ends in ((begin, end), (end, begin)))
    ways = {sign(speed, given).sense for given in between}
    return compare(NOTHING, (end - begin) * ways.pop(), context.assumptions) if len(ways) == 1 and 0 not in ways else UNSEEN


def state_said(context: Context, ending, what: str, name: str, stated: Scalar) -> Verdict:
    """The stated place, or speed, meets the equation, or its rate, at that time; what depends on it, by its formula."""
    subject, state = ending.phase.subject, ending.state
    value = _tie(context, subject) if name == subject else own_place(context, name)
    speed = stated if name == subject else state.speeds[subject]
    there = {"t": state.time, subject: stated if (name, what) == (subject, "place") else state.places[subject]}
    moved = value if what == "place" else derivative(value, subject) * speed + derivative(value, "t")
    return scalars_equal(substitute(moved, there), NOTHING if name == subject else stated, context.assumptions)
