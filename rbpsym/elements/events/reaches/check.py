"""How far it is to the value."""

from rbpsym.errors import there
from rbpsym.field import Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.proof.checks.courses import EventCheck, course_of
from rbpsym.proof.checks.places import own_place
from rbpsym.proof.context import Context
from rbpsym.statement.model import Phase


def _then(context: Context, phase: Phase) -> Scalar:
    return course_of(context, own_place(context, phase.subject))[0] - scalar(there(phase.value))


def _there(context: Context, phase: Phase) -> Scalar:
    return own_place(context, phase.subject) - scalar(there(phase.value))


CHECK = EventCheck(_then, _there)
