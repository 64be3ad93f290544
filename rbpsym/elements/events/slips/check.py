"""What friction has left of its limit, in both senses."""

from collections.abc import Callable
from functools import partial

from rbpsym.field import NOTHING, Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.proof.checks.courses import EventCheck, force_then, force_there
from rbpsym.proof.context import Context
from rbpsym.statement.model import Phase


def _left(force: Callable[[Context, str], Scalar], context: Context, phase: Phase) -> Scalar:
    element = context.study.system.element(phase.subject)
    grip, most = force(context, element["friction"]), sum((force(context, n) for n in element.normals), NOTHING)
    most *= scalar(element["limit"])
    return (most - grip) * (most + grip)


CHECK = EventCheck(partial(_left, force_then), partial(_left, force_there))
