"""Typst (0.13 or later) of a formula, to be put between dollar signs. One method a box.

Letters and signs are printed as Unicode; a comma is quoted, so that it can't split arguments.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.tree import Node
from rbpsym.typeset import boxes as b
from rbpsym.typeset.layout import COMMANDS, Printer

_SIGNS = {"·": "⋅", ",": '","', "/": r"\/"}
_ACCENTS = {
    "vec": "arrow", "bar": "macron", "check": "caron", "ddot": "dot.double",
    "dddot": "dot.triple",
}  # fmt: skip
_LETTERS = {"ı": "dotless.i", "ȷ": "dotless.j"}


def to_typst(node: Node, notation: Notation = DEFAULT) -> str:
    """The Typst math of a formula; a system in aligned rows."""
    return render.formula(node, notation)


def _quoted(text: str) -> str:
    escaped = text.replace("\\", r"\\").replace('"', r"\"")
    return f'"{escaped}"'


def _grouped(text: str) -> str:
    return text if len(text) == 1 else f"({text})"


_FENCES: dict[str, Callable[[str], str]] = {
    "(": "({})".format, "[": "[{}]".format, "|": "abs({})".format, "": "lr({} |)".format,
}  # fmt: skip


_FORMS = {
    "thin": "thin", "under": "%(base)s_(%(under)s)", "fraction": "frac(%(num)s, %(den)s)", "radical": "sqrt(%(body)s)",
    "applied": "%(head)s %(arg)s",
}  # fmt: skip


class _Typst(Printer):
    """Typst math."""

    forms = _FORMS

    def operator(self, box: b.Operator) -> str:
        return _SIGNS.get(box.sign, box.sign)

    def phrase(self, box: b.Phrase) -> str:
        return _quoted(box.text)

    def accent(self, box: b.Accent) -> str:
        return f"{_ACCENTS.get(box.kind, box.kind)}({self(box.body)})"

    def script(self, box: b.Script) -> str:
        primes, sup = b.split_primes(box.sup)
        sub = "_" + _grouped(self(box.sub)) if box.sub else ""
        return self(box.base) + "'" * primes + sub + ("^" + _grouped(self(sup)) if sup else "")

    def fence(self, box: b.Fence) -> str:
        if box.opening and not box.closing:
            return f"lr(\\{box.opening} {self(box.body)})"
        if box.closing in (")", "]") and not box.opening:
            return f"lr({self(box.body)} \\{box.closing})"
        return _FENCES[box.opening](self(box.body))

    def function(self, box: b.Function) -> str:
        return box.name if box.name in COMMANDS else f"op({_quoted(box.name)})"

    def row(self, box: b.Row) -> str:
        text = " ".join(text for item in box.items if (text := self(item)))
        return re.sub(r' (","|\\/) ', r"\1", text)

    def rows(self, box: b.Rows) -> str:
        return " \\\n".join(f"{self(left)} &{self(right)}".strip() for left, right in box.rows)

    def in_italic(self, text: str) -> str:
        return _LETTERS.get(text, text)

    def in_upright(self, text: str) -> str:
        return f"upright({text})" if len(text) == 1 else _quoted(text)

    def in_script(self, text: str) -> str:
        return f"cal({text})"

    def in_number(self, text: str) -> str:
        return _quoted(text) if "," in text else text


render = _Typst()
