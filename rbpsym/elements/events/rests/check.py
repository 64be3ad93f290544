"""The speed, and its square along the motion."""

from rbpsym.field import Scalar, time_derivative
from rbpsym.proof.checks.courses import EventCheck, course_of
from rbpsym.proof.checks.places import own_place
from rbpsym.proof.context import Context
from rbpsym.statement.model import Phase


def _there(context: Context, phase: Phase) -> Scalar:
    return context.along(time_derivative(own_place(context, phase.subject), context.study.system.scope) ** 2)


CHECK = EventCheck(lambda context, phase: course_of(context, own_place(context, phase.subject))[1], _there)
