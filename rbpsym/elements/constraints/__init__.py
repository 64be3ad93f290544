"""The constraints that a statement can name: a condition, and the unknown forces that keep it."""

from rbpsym.elements.kinds import ElementKind, in_folders

CONSTRAINTS: dict[str, ElementKind] = in_folders(__name__, __path__)
