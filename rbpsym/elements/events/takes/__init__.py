"""An unknown force has a value: asked for in questions alone."""

from rbpsym.elements.kinds import event

KIND = event(
    __name__, "the unknown force “of” has the value “at”",
    of="force", at="value", fails="does not have this value", moment="value", place="value", is_stated=False,
)
