"""The events that end a phase of the motion: what is true then."""

from rbpsym.elements.kinds import EventKind, in_folders

EVENTS: dict[str, EventKind] = in_folders(__name__, __path__)
STATED = {name: kind for name, kind in EVENTS.items() if kind.is_stated}
