"""The normal force."""

from rbpsym.proof.checks.courses import EventCheck, force_then, force_there

CHECK = EventCheck(
    lambda context, phase: force_then(context, phase.subject), lambda context, phase: force_there(context, phase.subject)
)
