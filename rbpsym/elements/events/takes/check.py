"""What the force is above its value."""

from rbpsym.errors import there
from rbpsym.field.evaluate import scalar
from rbpsym.proof.checks.courses import EventCheck, force_there

CHECK = EventCheck(there=lambda context, phase: force_there(context, phase.subject) - scalar(there(phase.value)))
