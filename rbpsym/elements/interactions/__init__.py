"""The interactions that a statement can name: forces and couples that are known laws."""

from rbpsym.elements.kinds import ElementKind, in_folders

INTERACTIONS: dict[str, ElementKind] = in_folders(__name__, __path__)
LETTERS = {kind.name: letter for kind in INTERACTIONS.values() for field in kind.fields for letter, _ in field.variables}
"""By kind of resistance: the letter for the speed in its size."""
