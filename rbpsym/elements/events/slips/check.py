"""What friction has left of its limit, in both senses."""

from rbpsym.field import NOTHING, Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.proof.checks.courses import EventCheck, force_there
from rbpsym.proof.context import Context
from rbpsym.statement.model import Phase


def _there(context: Context, phase: Phase) -> Scalar:
    element = context.study.system.element(phase.subject)
    grip, most = force_there(context, element["friction"]), sum((force_there(context, n) for n in element.normals), NOTHING)
    most *= scalar(element["limit"])
    return (most - grip) * (most + grip)


CHECK = EventCheck(there=_there)
