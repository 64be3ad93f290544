"""Boxes: what is on the page, after all decisions of typesetting and before any format.

`layout.layout` turns a display tree into boxes; LaTeX, Typst, MathML, text (and OMML) each need
only one function a box.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from rbpsym.frozen import Frozen


class Box(Frozen):
    """A part of a page."""


class Letter(Box):
    """A letter or word; `style` is italic, upright, script or number."""

    text: str
    style: str = "italic"


class Phrase(Box):
    """Words of prose inside a formula, with spaces around."""

    text: str


class Operator(Box):
    """A sign: kind "binary" (+ − · ×), "prefix" (−), "relation" (=), "mark" (, / |)."""

    sign: str
    kind: str = "binary"


class Big(Box):
    """A large operator: ∫ or ∑."""

    sign: str


class Thin(Box):
    """A thin space."""


class Times(Box):
    """The invisible sign between factors that stand side by side."""


class Accent(Box):
    """A sign over a box: vec, bold, hat, bar, tilde, check, dot, ddot, dddot."""

    kind: str
    body: Box


class Prime(Box):
    """One or more primes, as a superscript."""

    count: int


class Script(Box):
    """A base with a subscript, superscript or both."""

    base: Box
    sub: Box | None = None
    sup: Box | None = None


class Under(Box):
    """An operator word with something under it (lim)."""

    base: Box
    under: Box


class Fraction(Box):
    """A fraction with a bar."""

    num: Box
    den: Box


class Radical(Box):
    """A square root."""

    body: Box


class Fence(Box):
    """A body between delimiters ( [ | or none (""); `tall` if they must grow."""

    opening: str
    body: Box
    closing: str
    tall: bool = False


class Function(Box):
    """The name of a function, upright."""

    name: str


class Applied(Box):
    """A function head (perhaps with a power) before its argument."""

    head: Box
    arg: Box


class Row(Box):
    """Boxes side by side."""

    items: tuple[Box, ...]


class Rows(Box):
    """Aligned rows: each a left part and a right part that begins with its relation sign."""

    rows: tuple[tuple[Box, Box], ...]


def parts(box: Box) -> Iterator[Box]:
    """The direct parts of a box."""
    for item in fields(box):
        value = getattr(box, item.name)
        if isinstance(value, Box):
            yield value
        elif isinstance(value, tuple):
            yield from (part for part in value if isinstance(part, Box))


def is_tall(box: Box) -> bool:
    """Does the box need growing delimiters: is there a fraction or integral on its line?"""
    if isinstance(box, (Fraction, Big, Rows)):
        return True
    if isinstance(box, Script):
        return is_tall(box.base)
    return any(is_tall(part) for part in parts(box))


def split_primes(sup: Box | None) -> tuple[int, Box | None]:
    """(number of primes, the rest of a superscript)."""
    if isinstance(sup, Prime):
        return sup.count, None
    if isinstance(sup, Row) and sup.items and isinstance(sup.items[0], Prime):
        return sup.items[0].count, Row(sup.items[1:])
    return 0, sup
