"""What is left of the time."""

from rbpsym.errors import there
from rbpsym.field import symbol
from rbpsym.field.evaluate import scalar
from rbpsym.proof.checks.courses import EventCheck

CHECK = EventCheck(lambda context, phase: symbol("t") - scalar(there(phase.value)))
