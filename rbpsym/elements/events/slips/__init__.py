"""Static friction is at its limit."""

from rbpsym.elements.kinds import event

KIND = event(
    __name__, "the constraint “of”, which static friction with a limit holds, begins to slip: |f| reaches μN",
    of="constraint", fails="does not begin to slip", place="slips", shown=("slips",), gives_way=True,
)
