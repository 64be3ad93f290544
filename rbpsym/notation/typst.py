"""Typst (0.13 or later) of a formula, to be put between dollar signs. One function a box.

Letters and signs are printed as Unicode; a comma is quoted, so that it can't split arguments.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from rbpsym.notation import boxes as b
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.layout import layout, layout_rows
from rbpsym.notation.tree import Node, System

_SIGNS = {"·": "⋅", ",": '","', "/": r"\/"}
_ACCENTS = {
    "vec": "arrow", "bar": "macron", "check": "caron", "ddot": "dot.double",
    "dddot": "dot.triple",
}  # fmt: skip
_OPERATORS = frozenset(  # commands for functions
    ["sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "exp", "ln", "lim"]
)
_LETTERS = {"ı": "dotless.i", "ȷ": "dotless.j"}


def to_typst(node: Node, notation: Notation = DEFAULT, *, aligned: bool = False) -> str:
    """The Typst math of a formula; `aligned` breaks a chain into aligned rows."""
    if aligned or isinstance(node, System):
        return render(layout_rows(node, notation))
    return render(layout(node, notation))


def render(box: b.Box) -> str:
    """The Typst of boxes."""
    return TABLE[type(box)](box)


def _letter(box: b.Letter) -> str:
    return _STYLES[box.style](box.text)


def _italic(text: str) -> str:
    return _LETTERS.get(text, text)


def _upright(text: str) -> str:
    return f"upright({text})" if len(text) == 1 else _quoted(text)


def _script_letter(text: str) -> str:
    return f"cal({text})"


def _number(text: str) -> str:
    return _quoted(text) if "," in text else text


_STYLES = {"italic": _italic, "upright": _upright, "script": _script_letter, "number": _number}


def _quoted(text: str) -> str:
    escaped = text.replace("\\", r"\\").replace('"', r"\"")
    return f'"{escaped}"'


def _phrase(box: b.Phrase) -> str:
    return _quoted(box.text)


def _operator(box: b.Operator) -> str:
    return _SIGNS.get(box.sign, box.sign)


def _big(box: b.Big) -> str:
    return box.sign


def _space(box: b.Space) -> str:
    return "thin"


def _times(box: b.Times) -> str:
    return ""


def _accent(box: b.Accent) -> str:
    return f"{_ACCENTS.get(box.kind, box.kind)}({render(box.body)})"


def _prime(box: b.Prime) -> str:
    return "'" * box.count


def _script(box: b.Script) -> str:
    primes, sup = b.split_primes(box.sup)
    sub = "_" + _grouped(render(box.sub)) if box.sub else ""
    return render(box.base) + "'" * primes + sub + ("^" + _grouped(render(sup)) if sup else "")


def _grouped(text: str) -> str:
    return text if len(text) == 1 else f"({text})"


def _under(box: b.Under) -> str:
    return f"{render(box.base)}_({render(box.under)})"


def _fraction(box: b.Fraction) -> str:
    return f"frac({render(box.num)}, {render(box.den)})"


def _radical(box: b.Radical) -> str:
    return f"sqrt({render(box.body)})"


def _fence(box: b.Fence) -> str:
    if box.opening and not box.closing:
        return f"lr(\\{box.opening} {render(box.body)})"
    if box.closing in (")", "]") and not box.opening:
        return f"lr({render(box.body)} \\{box.closing})"
    return _FENCES[box.opening](render(box.body))


_FENCES: dict[str, Callable[[str], str]] = {
    "(": "({})".format, "[": "[{}]".format, "|": "abs({})".format, "": "lr({} |)".format,
}  # fmt: skip


def _function(box: b.Function) -> str:
    return box.name if box.name in _OPERATORS else f"op({_quoted(box.name)})"


def _applied(box: b.Applied) -> str:
    return f"{render(box.head)} {render(box.arg)}"


def _row(box: b.Row) -> str:
    text = " ".join(text for item in box.items if (text := render(item)))
    return re.sub(r' (","|\\/) ', r"\1", text)


def _rows(box: b.Rows) -> str:
    return " \\\n".join(f"{render(left)} &{render(right)}".strip() for left, right in box.rows)


TABLE: dict[type, Callable[..., str]] = {
    b.Letter: _letter, b.Phrase: _phrase, b.Operator: _operator, b.Big: _big, b.Space: _space,
    b.Times: _times, b.Accent: _accent, b.Prime: _prime, b.Script: _script, b.Under: _under,
    b.Fraction: _fraction, b.Radical: _radical, b.Fence: _fence, b.Function: _function,
    b.Applied: _applied, b.Row: _row, b.Rows: _rows,
}  # fmt: skip
