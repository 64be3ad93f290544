"""LaTeX (amsmath) of a formula. One method a box.

Small calligraphic letters use `\\mathpzc`, which `PREAMBLE` declares.
"""

from __future__ import annotations

import re

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.letters import latex_letter
from rbpsym.expr.tree import Node
from rbpsym.typeset import boxes as b
from rbpsym.typeset.layout import COMMANDS, Printer

PREAMBLE = r"\DeclareMathAlphabet{\mathpzc}{OT1}{pzc}{m}{it}"

_SIGNS = {
    "−": "-", "·": r"\cdot", "×": r"\times", "≤": r"\le", "≥": r"\ge", "≠": r"\ne",
    "≈": r"\approx", "→": r"\to", "∫": r"\int", "∑": r"\sum",
}  # fmt: skip
_LETTERS = {"∂": r"\partial", "ı": r"\imath", "ȷ": r"\jmath"}
_ACCENTS = {"bold": "boldsymbol"}


def to_latex(node: Node, notation: Notation = DEFAULT) -> str:
    """The LaTeX of a formula, for math mode; a system in aligned rows."""
    return render.formula(node, notation)


def _escaped(text: str) -> str:
    """Prose with the characters escaped that TeX would act on."""
    text = text.replace("\\", r"\textbackslash ")
    text = re.sub(r"([#$%&_{}])", r"\\\1", text)
    return text.replace("~", r"\textasciitilde ").replace("^", r"\textasciicircum ")


def _braced(text: str) -> str:
    return text if len(text) == 1 else f"{{{text}}}"


def joined(pieces: list[str]) -> str:
    """The pieces side by side, with a space only where TeX or a reader needs one."""
    text = ""
    for piece in pieces:
        needed = re.search(r"\\[A-Za-z]+$", text) and re.match(r"[A-Za-z0-9]", piece)
        text += (" " if needed else "") + piece
    return re.sub(r" {2,}", " ", text).strip()


def _row_pair(pair: tuple[b.Box, b.Box]) -> str:
    left, right = (render(part) for part in pair)
    return f"{left} &{right}".lstrip()


_FORMS = {
    "thin": r" \, ", "times": " ", "under": "%(base)s_{%(under)s}", "fraction": r"\frac{%(num)s}{%(den)s}",
    "radical": r"\sqrt{%(body)s}",
}  # fmt: skip


class _Latex(Printer):
    """LaTeX."""

    signs = _SIGNS
    forms = _FORMS

    def phrase(self, box: b.Phrase) -> str:
        return rf"\text{{{_escaped(box.text)}}}"

    def accent(self, box: b.Accent) -> str:
        return rf"\{_ACCENTS.get(box.kind, box.kind)}{{{self(box.body)}}}"

    def script(self, box: b.Script) -> str:
        sub = "_" + _braced(self(box.sub)) if box.sub else ""
        primes, sup = b.split_primes(box.sup)
        raised = "^" + _braced(self(sup)) if sup else ""
        gap = " " if isinstance(box.base, b.Big) else ""
        return self(box.base) + sub + "'" * primes + raised + gap

    def fence(self, box: b.Fence) -> str:
        body = self(box.body)
        if box.tall:
            return rf"\left{box.opening or '.'} {body} \right{box.closing or '.'}"
        if box.opening == "|":
            return rf"\lvert {body} \rvert"
        return f"{box.opening}{body}{box.closing}"

    def function(self, box: b.Function) -> str:
        return f"\\{box.name}" if box.name in COMMANDS else rf"\operatorname{{{box.name}}}"

    def applied(self, box: b.Applied) -> str:
        return joined([self(box.head), self(box.arg)])

    def row(self, box: b.Row) -> str:
        return joined([self(item) for item in box.items])

    def rows(self, box: b.Rows) -> str:
        body = r" \\ ".join(_row_pair(pair) for pair in box.rows)
        return rf"\begin{{aligned}} {body} \end{{aligned}}"

    def in_italic(self, text: str) -> str:
        return _LETTERS.get(text) or latex_letter(text)

    def in_upright(self, text: str) -> str:
        if len(text) == 1 and not text.isascii():
            return self.in_italic(text)
        return rf"\mathrm{{{text}}}" if text.isascii() else rf"\text{{{_escaped(text)}}}"

    def in_script(self, text: str) -> str:
        return (r"\mathpzc{%s}" if text.islower() else r"\mathcal{%s}") % latex_letter(text)

    def in_number(self, text: str) -> str:
        return text.replace(",", "{,}")


render = _Latex()
