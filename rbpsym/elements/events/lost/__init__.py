"""A normal force has gone."""

from rbpsym.elements.kinds import event

KIND = event(
    __name__, "the contact “of” is lost: its normal force reaches zero",
    of="constraint", fails="does not vanish", place="lost", shown=("lost", "slack"), gives_way=True,
)
