"""Checks of when a coordinate that an equation with the time ties has a value, and of the state then: by the equation itself."""

from __future__ import annotations

from rbpsym.algebra.calculus import derivative, substitute
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.derivation.checks_places import UNSEEN, own_place
from rbpsym.derivation.context import Context
from rbpsym.equality.decide import compare, scalars_equal
from rbpsym.equality.verdict import Verdict
from rbpsym.mechanics.driven import sense_to, tie_to_time
from rbpsym.mechanics.state import State
from rbpsym.statement.model import Phase


def is_driven(context: Context, phase: Phase) -> bool:
    """Whether a phase ends where such a coordinate has a value."""
    return phase.event == "reaches" and tie_to_time(context.study.system, phase.subject) is not None


def left_then(context: Context, phase: Phase) -> Scalar:
    """What vanishes at the moment, as a function of the time."""
    return substitute(tie_to_time(context.study.system, phase.subject), {phase.subject: scalar(phase.value)})


def comes_there(context: Context, phase: Phase) -> Verdict:
    """The value lies ahead of the start, in the sense in which the coordinate changes all the way."""
    ends = (context.start(symbol(phase.subject)), scalar(phase.value))
    way = sense_to(context.study, phase.subject, ends)
    return compare(NOTHING, (ends[1] - ends[0]) * way, context.assumptions) if way else UNSEEN


def is_state(context: Context, subject: str, state: State, what: str, name: str, stated: Scalar) -> Verdict:
    """The stated place, or speed, meets the equation, or its rate, at that time; what depends on it, by its formula."""
    tie, rates = tie_to_time(context.study.system, subject), {"t": state.time, subject: state.places[subject]}
    if name != subject:
        value = own_place(context, name)
        speed = symbol(f"{subject}_dot")
        moved = value if what == "place" else derivative(value, subject) * speed + derivative(value, "t")
        then = {**rates, f"{subject}_dot": state.speeds[subject]}
        return scalars_equal(substitute(moved, then), stated, context.assumptions)
    gap = tie if what == "place" else derivative(tie, subject) * stated + derivative(tie, "t")
    then = {**rates, subject: stated} if what == "place" else rates
    return scalars_equal(substitute(gap, then), NOTHING, context.assumptions)
