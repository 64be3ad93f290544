"""How far it is to the value."""

from rbpsym.errors import there
from rbpsym.field import Scalar, depends_on, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.proof.checks.courses import EventCheck, course_of
from rbpsym.proof.checks.places import own_place
from rbpsym.proof.context import Context
from rbpsym.statement.model import Phase


def _then(context: Context, phase: Phase) -> Scalar:
    """By the equation with the time that ties the coordinate, if there is one."""
    value, system = scalar(there(phase.value)), context.study.system
    tie = next((tie.value for tie in system.implicit if depends_on(tie.value, phase.subject)), None)
    if tie is not None and not system.independent:
        return substitute(tie, {phase.subject: value})
    return course_of(context, own_place(context, phase.subject))[0] - value


CHECK = EventCheck(_then, lambda context, phase: own_place(context, phase.subject) - scalar(there(phase.value)))
