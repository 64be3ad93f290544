"""Integrals along the motion from the start to now, over the coordinates."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra.scalar import Scalar
from rbpsym.derivation.draft import Draft
from rbpsym.notation import tree as t


def over_coordinates(draft: Draft, parts: Mapping[str, Scalar]) -> t.Node:
    """Σ ∫ f dq from the start to now."""
    return t.add(*(integral(draft, name, part) for name, part in parts.items()))


def integral(draft: Draft, name: str, part: Scalar) -> t.Node:
    """∫_{q₀}^{q} part dq, a common sign in front."""
    shown = draft.show(part, factor=True)
    start = start_of(draft, name)
    if isinstance(shown, t.Neg):
        return t.neg(t.Integral(shown.arg, name, start, t.Sym(name)))
    return t.Integral(shown, name, start, t.Sym(name))


def start_of(draft: Draft, name: str) -> t.Node:
    """The start of a coordinate as the author wrote it, else a constant with index 0."""
    if name == "t":
        return t.ZERO
    coordinate = next(c for c in draft.study.problem.coordinates if c.name == name)
    return coordinate.start if coordinate.start is not None else t.Sym(f"{name}_0")
