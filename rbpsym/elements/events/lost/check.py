"""The normal force."""

from rbpsym.proof.checks.courses import EventCheck, force_there

CHECK = EventCheck(there=lambda context, phase: force_there(context, phase.subject))
