"""What the phase brings closes."""

from rbpsym.elements.kinds import event

KIND = event(
    __name__, "the contact, string or bounce “of”, which the phase brings, begins: a body lands, a string goes taut",
    of="constraint or bounce of its own", fails="does not begin", moment="begins", place="value", shown=("reaches",),
)
