"""Glyphs as boxes: letters with accents, primes and subscripts; unit vectors; powers on them."""

from __future__ import annotations

from dataclasses import replace

from rbpsym.notation import boxes as b
from rbpsym.notation.glyphs import Glyph

_DOTS = {1: "dot", 2: "ddot", 3: "dddot"}
_UNITS = {"x": "ı", "y": "ȷ", "z": "k"}


def glyph_box(glyph: Glyph, vector: str = "") -> b.Box:
    """The boxes of a glyph; `vector` is "vec", "bold" or "" for a scalar."""
    box: b.Box = b.Letter(glyph.base, glyph.style)
    dots = _DOTS.get(glyph.dots, "dddot" if glyph.dots else "")
    for accent in (glyph.accent, vector, dots):
        box = b.Accent(accent, box) if accent else box
    sup = b.Prime(glyph.primes) if glyph.primes else None
    box = b.Script(box, _subscripts(glyph), sup) if sup or glyph.subs else box
    return b.Row((b.Letter(glyph.prefix, "upright"), box)) if glyph.prefix else box


def _subscripts(glyph: Glyph) -> b.Box | None:
    """All subscripts of a glyph, with commas between."""
    items: list[b.Box] = []
    for sub in glyph.subs:
        items += [b.Operator(",", "mark")] if items else []
        items.append(glyph_box(sub))
    return (items[0] if len(items) == 1 else b.Row(tuple(items))) if items else None


def unit_box(axis: str) -> b.Box:
    """î, ĵ or k̂."""
    return b.Accent("hat", b.Letter(_UNITS[axis]))


def attached(box: b.Box) -> bool:
    """Can a superscript be put on the box without parentheses?"""
    if isinstance(box, b.Script):
        return box.sup is None or isinstance(box.sup, b.Prime)
    return not isinstance(box, b.Row)


def attach_sup(box: b.Box, sup: b.Box) -> b.Box:
    """The box with a superscript, over its subscript and after its primes."""
    if not isinstance(box, b.Script):
        return b.Script(box, None, sup)
    return replace(box, sup=b.Row((box.sup, sup)) if box.sup else sup)
