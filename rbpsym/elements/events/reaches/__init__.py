"""A coordinate has a value."""

from rbpsym.elements.kinds import event

KIND = event(
    __name__, "the coordinate “of” reaches the value “at”",
    of="coordinate", at="value", fails="does not come to this value", moment="value", place="value", shown=("reaches",),
)
