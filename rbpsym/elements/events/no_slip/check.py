"""The slip, by points fixed in the bodies."""

from rbpsym.field import Scalar, symbol, time_derivative
from rbpsym.proof.checks.constraints import slip_at
from rbpsym.proof.checks.courses import EventCheck
from rbpsym.proof.context import Context
from rbpsym.statement.model import Phase


def _then(context: Context, phase: Phase) -> Scalar:
    """At a rate that does not change."""
    slip = slip_at(context.study.system, context.study.system.element(phase.subject))
    left: Scalar = context.start(slip) + context.on_motion(time_derivative(slip, context.study.system.scope)) * symbol("t")
    return left


def _there(context: Context, phase: Phase) -> Scalar:
    squared: Scalar = context.along(slip_at(context.study.system, context.study.system.element(phase.subject)) ** 2)
    return squared


CHECK = EventCheck(_then, _there)
