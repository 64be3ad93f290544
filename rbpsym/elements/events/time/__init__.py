"""A time has gone."""

from rbpsym.elements.kinds import event

KIND = event(__name__, "the time “at” has gone since the phase before began", at="time", moment="time")
