"""MathML Core of a formula, as browsers draw it without JavaScript. One method a box."""

from __future__ import annotations

from html import escape

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.letters import UPRIGHT_CAPITALS, bold, script
from rbpsym.expr.tree import Node
from rbpsym.typeset import boxes as b
from rbpsym.typeset.layout import Printer

_THIN = '<mspace width="0.1667em"/>'
_APPLY = "<mo>\u2061</mo>"
_ACCENTS = {
    "vec": "→", "hat": "^", "bar": "¯", "tilde": "~", "check": "ˇ", "dot": "˙", "ddot": "¨",
    "dddot": "\u20db",
}  # fmt: skip
_SIGNS = {"·": "⋅"}


def to_mathml(node: Node, notation: Notation = DEFAULT) -> str:
    """A `<math>` element."""
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML">{render.formula(node, notation)}</math>'


_OPERATORS = {
    "binary": "<mo>{}</mo>",
    "relation": '<mo form="infix" lspace="0.2778em" rspace="0.2778em">{}</mo>',
    "prefix": '<mo form="prefix">{}</mo>',
    "mark": '<mo lspace="0" rspace="0" stretchy="false">{}</mo>',
}


def _beside_slant(base: b.Box, raised: str) -> str:
    """What is raised beside a letter, moved off its slanted arm: browsers leave out the italic correction."""
    letter = base.body if isinstance(base, b.Accent) else base
    room = _SLANTS.get(letter.text) if isinstance(letter, b.Letter) and letter.style == "italic" else None
    return f'<mrow><mspace width="{room}em"/>{raised}</mrow>' if room else raised


# the italic corrections of Latin Modern Math, in em of the small letters that are raised
_SLANTS = {
    "C": 0.1, "F": 0.19, "H": 0.11, "I": 0.12, "J": 0.15, "K": 0.1, "M": 0.15, "N": 0.15, "P": 0.2, "S": 0.09,
    "T": 0.21, "U": 0.15, "V": 0.31, "W": 0.19, "Y": 0.3, "Z": 0.1, "f": 0.13, "ζ": 0.09, "ν": 0.08, "ς": 0.11, "τ": 0.15,
}  # fmt: skip


_SCRIPTS = {
    (False, False): "mrow", (True, False): "msub", (False, True): "msup", (True, True): "msubsup",
}  # fmt: skip


def _delimiter(sign: str, form: str, *, tall: bool) -> str:
    stretchy = "true" if tall else "false"
    return f'<mo form="{form}" fence="true" stretchy="{stretchy}">{sign}</mo>' if sign else ""


def _in_row(before: b.Box | None, box: b.Box, after: b.Box | None) -> str:
    """A box of a row; the invisible sign gets a thin space beside a function."""
    beside = isinstance(box, b.Times) and isinstance(after, b.Applied)
    open_before = isinstance(before, b.Applied) and not isinstance(before.arg, b.Fence)
    behind = isinstance(box, b.Times) and open_before
    return render(box) + (_THIN if beside or behind else "")


_FORMS = {
    "thin": _THIN, "times": "<mo>\u2062</mo>", "big": "<mo>%(sign)s</mo>", "function": "<mi>%(name)s</mi>",
    "under": "<munder>%(base)s%(under)s</munder>", "fraction": "<mfrac>%(num)s%(den)s</mfrac>",
    "radical": "<msqrt>%(body)s</msqrt>",
}  # fmt: skip


class _MathML(Printer):
    """MathML: exactly one element a box."""

    forms = _FORMS

    def phrase(self, box: b.Phrase) -> str:
        words = escape(box.text.replace(" ", "\u00a0"))
        return f'<mi mathvariant="normal">{words}</mi>'

    def operator(self, box: b.Operator) -> str:
        return _OPERATORS[box.kind].format(escape(_SIGNS.get(box.sign, box.sign)))

    def accent(self, box: b.Accent) -> str:
        if box.kind == "bold" and isinstance(box.body, b.Letter):
            return f'<mi mathvariant="normal">{bold(box.body.text)}</mi>'
        size = ' mathsize="70%"' if box.kind == "vec" else ""
        sign = f'<mo stretchy="false" lspace="0" rspace="0"{size}>{_ACCENTS.get(box.kind, "")}</mo>'
        return f'<mover accent="true">{self(box.body)}{sign}</mover>'

    def prime(self, box: b.Prime) -> str:
        return f'<mo lspace="0" rspace="0">{"′" * box.count}</mo>'

    def script(self, box: b.Script) -> str:
        if box.base == b.Big("∑") and box.sub:
            return f"<munder>{self(box.base)}{self(box.sub)}</munder>"
        primes, sup = b.split_primes(box.sup)
        base = self(box.base)
        base = f"<mrow>{base}{self.prime(b.Prime(primes))}</mrow>" if primes else base
        name = _SCRIPTS[box.sub is not None, sup is not None]
        raised = _beside_slant(box.base, self(sup)) if sup and not primes else self(sup) if sup else ""
        return f"<{name}>{base}{self(box.sub) if box.sub else ''}{raised}</{name}>"

    def fence(self, box: b.Fence) -> str:
        left = _delimiter(box.opening, "prefix", tall=box.tall)
        right = _delimiter(box.closing, "postfix", tall=box.tall)
        return f"<mrow>{left}{self(box.body)}{right}</mrow>"

    def applied(self, box: b.Applied) -> str:
        gap = "" if isinstance(box.arg, b.Fence) else _THIN
        return f"<mrow>{self(box.head)}{_APPLY}{gap}{self(box.arg)}</mrow>"

    def row(self, box: b.Row) -> str:
        items = box.items
        around = zip((None, *items), items, (*items[1:], None), strict=False)
        return f"<mrow>{''.join(_in_row(*three) for three in around)}</mrow>"

    def rows(self, box: b.Rows) -> str:
        rows = "".join(
            f'<mtr><mtd style="text-align:right;padding-right:0">{self(left)}</mtd>'
            f'<mtd style="text-align:left;padding-left:0">{self(right)}</mtd></mtr>'
            for left, right in box.rows
        )
        return f'<mtable displaystyle="true">{rows}</mtable>'

    def in_italic(self, text: str) -> str:
        normal = ' mathvariant="normal"' if text in UPRIGHT_CAPITALS else ""
        return f"<mi{normal}>{escape(text)}</mi>"

    def in_upright(self, text: str) -> str:
        normal = ' mathvariant="normal"' if len(text) == 1 else ""
        return f"<mi{normal}>{escape(text)}</mi>"

    def in_script(self, text: str) -> str:
        return f"<mi>{script(text)}</mi>"

    def in_number(self, text: str) -> str:
        return f"<mn>{escape(text)}</mn>"


render = _MathML()
