"""A formula in letters that a screen reader reads out: alt texts of figures and plots."""

from __future__ import annotations

import re
from unicodedata import decomposition, normalize

from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.text import to_text
from rbpsym.notation.tree import Node

ARROW = "\u20d7"


def plain_letters(node: Node, notation: Notation = DEFAULT) -> str:
    """The formula in one line without arrows, script letters and small subscripts, which many voices skip or spell.

    >>> from rbpsym.notation.tree import Sym, Vec
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
