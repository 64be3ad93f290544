"""A slip has gone."""

from rbpsym.elements.kinds import event

KIND = event(
    __name__, "the constraint “of”, which has kinetic friction, stops slipping",
    of="constraint", fails="does not stop slipping", moment="slip", place="rest", shown=("holds",), by_friction=True,
)
