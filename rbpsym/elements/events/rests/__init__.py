"""A coordinate has come to rest."""

from rbpsym.elements.kinds import event

KIND = event(
    __name__, "the coordinate “of” comes to rest: its speed vanishes",
    of="coordinate", fails="does not come to rest", moment="rest", place="turn", shown=("reaches",),
)
