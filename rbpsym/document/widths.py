"""How wide a formula is, in em: estimates from the boxes that `notation.layout` makes of the display tree."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache

from rbpsym.notation import boxes as b


@lru_cache(maxsize=4096)
def width(box: b.Box) -> float:
    """The width of a box in display style, in em."""
    return WIDTHS[type(box)](box)


def letter_width(box: b.Letter) -> float:
    """Half an em a digit or small letter, more for capitals."""
    return sum(0.72 if char.isupper() else 0.53 for char in box.text)


def script_width(box: b.Script) -> float:
    """The base, and the wider of its two small scripts."""
    scripts = [width(part) for part in (box.sub, box.sup) if part]
    return width(box.base) + 0.7 * max(scripts, default=0.0)


def fence_width(box: b.Fence) -> float:
    """The body with its delimiters."""
    return width(box.body) + (0.5 if box.tall else 0.4) * sum(map(bool, (box.opening, box.closing)))


OPERATORS = {"binary": 1.15, "prefix": 0.8, "relation": 1.35, "mark": 0.4}

WIDTHS: Mapping[type, Callable[..., float]] = {
    b.Letter: letter_width,
    b.Script: script_width,
    b.Fence: fence_width,
    b.Phrase: lambda box: 0.5 * len(box.text) + 0.6,
    b.Operator: lambda box: OPERATORS.get(box.kind, 1.0),
    b.Big: lambda box: 1.0,
    b.Space: lambda box: 0.17,
    b.Times: lambda box: 0.08,
    b.Accent: lambda box: width(box.body),
    b.Prime: lambda box: 0.3 * box.count,
    b.Under: lambda box: max(width(box.base), 0.7 * width(box.under)),
    b.Fraction: lambda box: max(width(box.num), width(box.den)) + 0.25,
    b.Radical: lambda box: width(box.body) + 0.9,
    b.Function: lambda box: 0.5 * len(box.name) + 0.17,
    b.Applied: lambda box: width(box.head) + 0.1 + width(box.arg),
    b.Row: lambda box: sum(map(width, box.items)),
    b.Rows: lambda box: max(width(left) + width(right) for left, right in box.rows),
}
