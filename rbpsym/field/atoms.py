"""Generators of the field, interned so that a monomial is a tuple of integers.

An atom is a plain symbol, the sine or cosine of an angle, a square root, or another function
(exp, ln, asin ...) of a scalar. The intern table only grows; an atom's index never changes, and says what it is: forms, signs
and orders that go by it are the same whatever was met before.
"""

from __future__ import annotations

from string import ascii_letters, digits
from typing import Any
from zlib import crc32

from rbpsym.expr.letters import LETTERS
from rbpsym.field.poly import ONE, Poly
from rbpsym.frozen import Frozen


class Atom(Frozen):
    """kind: "symbol" (arg: name), "cos"/"sin" (arg: Poly of the angle), "root" (arg: Scalar),
    or the name of a function (arg: Scalar)."""

    kind: str
    arg: Any


PI = 0
_INDEX: dict[tuple[str, Any], int] = {("symbol", "pi"): PI}
_TABLE: dict[int, Atom] = {PI: Atom("symbol", "pi")}
ORDER = {letter: place for place, letter in enumerate((*digits, *ascii_letters, *LETTERS), 2)}  # another one: 1; none: 0
BITS, LONGEST, BELOW = 7, 4, 29  # of a letter, letters of a name, bits for the kind and all that is inside


def intern(kind: str, arg: Any) -> int:
    """The index of the atom, which is made if it is new."""
    index = _INDEX.get((kind, arg))
    if index is None:
        index = _own(kind, arg)
        while index in _TABLE:
            index += 1
        _INDEX[kind, arg] = index
        _TABLE[index] = Atom(kind, _in_order(arg))
    return index


def _own(kind: str, arg: Any) -> int:
    """A number for what it is: first how deep it is, then by the letters of the first name inside and its kind."""
    if isinstance(arg, str):
        depth, name, stem, text = 0, 0, arg.partition("_")[0], arg
        letters = (stem, *arg.removeprefix(stem)) if stem in LETTERS else arg
        for place in range(LONGEST):
            name = name << BITS | (ORDER.get(letters[place], 1) if place < len(letters) else 0)
    else:
        polys = [arg] if isinstance(arg, Poly) else [arg.num, arg.den]
        text = str([sorted((m, str(c)) for m, c in poly.terms.items()) for poly in polys])
        used = [index >> BELOW for poly in polys for index in poly.atoms() if index]
        names = 1 << BITS * LONGEST
        depth, name = 1 + max(used, default=0) // names, min((one % names for one in used), default=0)
    return (depth << BITS * LONGEST | name) << BELOW | ord(kind[0]) % 32 << 24 | crc32(f"{kind} {text}".encode()) >> 8


def _in_order(arg: Any) -> Any:
    """The same with its terms in order, the plainest first, however it was first met."""
    if isinstance(arg, Poly):
        return arg if arg is ONE else Poly({m: arg.terms[m] for m in sorted(arg.terms, key=lambda m: (len(m), m))})
    return arg if isinstance(arg, str) else type(arg)(_in_order(arg.num), _in_order(arg.den))


def atom(index: int) -> Atom:
    """The atom of an index."""
    return _TABLE[index]


def symbol_name(index: int) -> str | None:
    """Name of a symbol atom, None for any other kind."""
    found = _TABLE[index]
    return found.arg if found.kind == "symbol" else None
