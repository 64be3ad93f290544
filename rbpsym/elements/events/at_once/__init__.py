"""The next phase begins where this one does."""

from rbpsym.elements.kinds import event

KIND = event(__name__, "the phase begins at the start of the one before: a blow, a point suddenly held")
