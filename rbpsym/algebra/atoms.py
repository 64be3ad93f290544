"""Generators of the field, interned so that a monomial is a tuple of small integers.

An atom is a plain symbol, the sine or cosine of an angle, a square root, or another function
(exp, ln, asin ...) of a scalar. The intern table only grows; an atom's index never changes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Atom:
    """kind: "symbol" (arg: name), "cos"/"sin" (arg: Poly of the angle), "root" (arg: Scalar),
    or the name of a function (arg: Scalar)."""

    kind: str
    arg: Any


_INDEX: dict[tuple[str, Any], int] = {}
_TABLE: list[Atom] = []


def intern(kind: str, arg: Any) -> int:
    """The index of the atom, which is made if it is new."""
    index = _INDEX.get((kind, arg))
    if index is None:
        index = _INDEX[kind, arg] = len(_TABLE)
        _TABLE.append(Atom(kind, arg))
    return index


def atom(index: int) -> Atom:
    """The atom of an index."""
    return _TABLE[index]


def symbol_name(index: int) -> str | None:
    """Name of a symbol atom, None for any other kind."""
    found = _TABLE[index]
    return found.arg if found.kind == "symbol" else None


PI = intern("symbol", "pi")
