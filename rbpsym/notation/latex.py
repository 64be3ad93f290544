"""LaTeX (amsmath) of a formula. `TABLE` has one function a box.

Small calligraphic letters use `\\mathpzc`, which `PREAMBLE` declares.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from rbpsym.notation import boxes as b
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.layout import layout, layout_rows
from rbpsym.notation.letters import latex_letter
from rbpsym.notation.tree import Node, System

PREAMBLE = r"\DeclareMathAlphabet{\mathpzc}{OT1}{pzc}{m}{it}"

_SIGNS = {
    "−": "-", "·": r"\cdot", "×": r"\times", "≤": r"\le", "≥": r"\ge", "≠": r"\ne",
    "≈": r"\approx", "→": r"\to", "∫": r"\int", "∑": r"\sum",
}  # fmt: skip
_LETTERS = {"∂": r"\partial", "ı": r"\imath", "ȷ": r"\jmath"}
_ACCENTS = {"bold": "boldsymbol"}
_OPERATORS = frozenset(  # commands for functions
    ["sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "exp", "ln", "lim"]
)


def to_latex(node: Node, notation: Notation = DEFAULT, *, aligned: bool = False) -> str:
    """The LaTeX of a formula, for math mode; `aligned` breaks a chain into aligned rows."""
    if aligned or isinstance(node, System):
        return render(layout_rows(node, notation))
    return render(layout(node, notation))


def render(box: b.Box) -> str:
    """The LaTeX of boxes."""
    return TABLE[type(box)](box)


def _letter(box: b.Letter) -> str:
    return _STYLES[box.style](box.text)


def _italic(text: str) -> str:
    return _LETTERS.get(text) or latex_letter(text)


def _upright(text: str) -> str:
    if len(text) == 1 and not text.isascii():
        return _italic(text)
    return rf"\mathrm{{{text}}}" if text.isascii() else rf"\text{{{_escaped(text)}}}"


def _script_letter(text: str) -> str:
    return (r"\mathpzc{%s}" if text.islower() else r"\mathcal{%s}") % latex_letter(text)


def _number(text: str) -> str:
    return text.replace(",", "{,}")


_STYLES = {"italic": _italic, "upright": _upright, "script": _script_letter, "number": _number}


def _escaped(text: str) -> str:
    """Prose with the characters escaped that TeX would act on."""
    text = text.replace("\\", r"\textbackslash ")
    text = re.sub(r"([#$%&_{}])", r"\\\1", text)
    return text.replace("~", r"\textasciitilde ").replace("^", r"\textasciicircum ")


def _phrase(box: b.Phrase) -> str:
    return rf"\text{{{_escaped(box.text)}}}"


def _operator(box: b.Operator) -> str:
    sign = _SIGNS.get(box.sign, box.sign)
    return sign if box.kind in ("prefix", "mark") else f" {sign} "


def _big(box: b.Big) -> str:
    return _SIGNS[box.sign]


def _space(box: b.Space) -> str:
    return r" \, "


def _times(box: b.Times) -> str:
    return " "


def _accent(box: b.Accent) -> str:
    return rf"\{_ACCENTS.get(box.kind, box.kind)}{{{render(box.body)}}}"


def _prime(box: b.Prime) -> str:
    return "'" * box.count


def _script(box: b.Script) -> str:
    sub = "_" + _braced(render(box.sub)) if box.sub else ""
    primes, sup = b.split_primes(box.sup)
    raised = "^" + _braced(render(sup)) if sup else ""
    gap = " " if isinstance(box.base, b.Big) else ""
    return render(box.base) + sub + "'" * primes + raised + gap


def _braced(text: str) -> str:
    return text if len(text) == 1 else f"{{{text}}}"


def _under(box: b.Under) -> str:
    return f"{render(box.base)}_{{{render(box.under)}}}"


def _fraction(box: b.Fraction) -> str:
    return rf"\frac{{{render(box.num)}}}{{{render(box.den)}}}"


def _radical(box: b.Radical) -> str:
    return rf"\sqrt{{{render(box.body)}}}"


def _fence(box: b.Fence) -> str:
    body = render(box.body)
    if box.tall:
        return rf"\left{box.opening or '.'} {body} \right{box.closing or '.'}"
    if box.opening == "|":
        return rf"\lvert {body} \rvert"
    return f"{box.opening}{body}{box.closing}"


def _function(box: b.Function) -> str:
    return f"\\{box.name}" if box.name in _OPERATORS else rf"\operatorname{{{box.name}}}"


def _applied(box: b.Applied) -> str:
    return joined([render(box.head), render(box.arg)])


def _row(box: b.Row) -> str:
    return joined([render(item) for item in box.items])


def joined(pieces: list[str]) -> str:
    """The pieces side by side, with a space only where TeX or a reader needs one."""
    text = ""
    for piece in pieces:
        needed = re.search(r"\\[A-Za-z]+$", text) and re.match(r"[A-Za-z0-9]", piece)
        text += (" " if needed else "") + piece
    return re.sub(r" {2,}", " ", text).strip()


def _rows(box: b.Rows) -> str:
    body = r" \\ ".join(_row_pair(pair) for pair in box.rows)
    return rf"\begin{{aligned}} {body} \end{{aligned}}"


def _row_pair(pair: tuple[b.Box, b.Box]) -> str:
    left, right = (render(part) for part in pair)
    return f"{left} &{right}".lstrip()


TABLE: dict[type, Callable[..., str]] = {
    b.Letter: _letter, b.Phrase: _phrase, b.Operator: _operator, b.Big: _big, b.Space: _space,
    b.Times: _times, b.Accent: _accent, b.Prime: _prime, b.Script: _script, b.Under: _under,
    b.Fraction: _fraction, b.Radical: _radical, b.Fence: _fence, b.Function: _function,
    b.Applied: _applied, b.Row: _row, b.Rows: _rows,
}  # fmt: skip
