"""The impulses that a phase can begin with: what changes velocities in no time."""

from rbpsym.elements.kinds import ElementKind, in_folders

IMPULSES: dict[str, ElementKind] = in_folders(__name__, __path__)
