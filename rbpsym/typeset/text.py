"""A formula in one line of Unicode, for a terminal: θ̈ = −(3g/4ℓ) cos θ. One method a box.

And in letters that a screen reader reads out: alt texts of figures and plots.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from unicodedata import decomposition, normalize

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.letters import bold, script, subscript, superscript
from rbpsym.expr.tree import Node
from rbpsym.typeset import boxes as b
from rbpsym.typeset.layout import Printer

_COMBINING = {
    "vec": "\u20d7", "bold": "\u20d7", "hat": "\u0302", "bar": "\u0304", "tilde": "\u0303",
    "check": "\u030c", "dot": "\u0307", "ddot": "\u0308", "dddot": "\u20db",
}  # fmt: skip
_DOTTED = {"ı": "i", "ȷ": "j"}


def to_text(node: Node, notation: Notation = DEFAULT) -> str:
    """The formula in one line; a system in one line a row."""
    return render.formula(node, notation)


def _attached(mark: str, text: str, small: Callable[[str], str | None]) -> str:
    """A sub- or superscript in small characters, or after `_` or `^`."""
    found = small(text.strip())
    return found or (f"{mark}{text}" if text.isalnum() else f"{mark}({text})")


def _needs_gap(items: tuple[b.Box, ...], texts: list[str], position: int) -> bool:
    """Would two factors side by side be taken for one name or argument?"""
    before, after = position - 1, position + 1
    if isinstance(items[after], b.Fence):
        return isinstance(items[before], b.Applied)
    wide = (b.Applied, b.Radical, b.Under)
    parts = (items[before], items[after])
    return any(isinstance(part, wide) for part in parts) or any(
        set("_^ ∫") & set(texts[place]) for place in (before, after)
    )


ARROW = "\u20d7"


def plain_letters(node: Node, notation: Notation = DEFAULT) -> str:
    """The formula in one line without arrows, script letters and small subscripts, which many voices skip or spell.

    >>> from rbpsym.expr.tree import Sym, Vec
    >>> plain_letters(Vec("W_rod")), plain_letters(Sym("cal_W_T_W")), plain_letters(Sym("vartheta_1"))
    ('W_rod', 'W_T,W', 'ϑ_1')
    """
    text = to_text(node, notation).replace(ARROW, "")
    below = "".join(f"\0{normalize('NFKC', c)}" if _is(c, "<sub>") else c for c in text)
    runs = re.sub(r"(?:\0[^\0])+", lambda found: "_" + found.group().replace("\0", ""), below)
    letters = "".join(normalize("NFKC", c) if _is(c, "<font>") else c for c in runs)
    return re.sub(r"_\(([^()]*)\)", r"_\1", letters)


def _is(letter: str, kind: str) -> bool:
    return decomposition(letter).startswith(kind)


_FORMS = {
    "phrase": "%(text)s", "thin": " ", "under": "%(base)s(%(under)s)", "fence": "%(opening)s%(body)s%(closing)s",
}  # fmt: skip


class _Text(Printer):
    """Unicode."""

    mode = "text"
    forms = _FORMS

    def letter(self, box: b.Letter) -> str:
        return script(box.text) if box.style == "script" else box.text

    def accent(self, box: b.Accent) -> str:
        if box.kind == "bold" and isinstance(box.body, b.Letter):
            return bold(box.body.text)
        body = self(box.body)
        return unicodedata.normalize("NFC", _DOTTED.get(body, body) + _COMBINING[box.kind])

    def script(self, box: b.Script) -> str:
        primes, sup = b.split_primes(box.sup)
        sub = _attached("_", self(box.sub), subscript) if box.sub else ""
        raised = _attached("^", self(sup), superscript) if sup else ""
        gap = " " if isinstance(box.base, b.Big) else ""
        return self(box.base) + "′" * primes + sub + raised + gap

    def radical(self, box: b.Radical) -> str:
        body = self(box.body)
        return f"√{body}" if len(body) == 1 or body.isdigit() else f"√({body})"

    def applied(self, box: b.Applied) -> str:
        gap = "" if isinstance(box.arg, b.Fence) else " "
        return f"{self(box.head)}{gap}{self(box.arg)}"

    def row(self, box: b.Row) -> str:
        texts = [self(item) for item in box.items]
        for position, item in enumerate(box.items):
            if isinstance(item, b.Times) and texts[position + 1][:1].isdigit():
                texts[position] = "·"
            elif isinstance(item, b.Times) and _needs_gap(box.items, texts, position):
                texts[position] = " "
        return "".join(texts)

    def rows(self, box: b.Rows) -> str:
        lefts = [self(left) for left, _ in box.rows]
        width = max((len(left) for left in lefts), default=0)
        rights = (self(right).lstrip() for _, right in box.rows)
        return "\n".join(f"{left:>{width}} {right}".rstrip() for left, right in zip(lefts, rights, strict=True))


render = _Text()
