"""MathML Core of a formula, as browsers draw it without JavaScript. One function a box."""

from __future__ import annotations

from collections.abc import Callable
from html import escape

from rbpsym.notation import boxes as b
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.layout import layout, layout_rows
from rbpsym.notation.letters import UPRIGHT_CAPITALS, bold, script
from rbpsym.notation.tree import Node, System

_THIN = '<mspace width="0.1667em"/>'
_APPLY = "<mo>\u2061</mo>"
_ACCENTS = {
    "vec": "→", "hat": "^", "bar": "¯", "tilde": "~", "check": "ˇ", "dot": "˙", "ddot": "¨",
    "dddot": "\u20db",
}  # fmt: skip
_SIGNS = {"·": "⋅"}


def to_mathml(node: Node, notation: Notation = DEFAULT, *, aligned: bool = False, display: bool = False) -> str:
    """A `<math>` element; `aligned` breaks a chain into rows, `display` sets it on its own line."""
    rows = aligned or isinstance(node, System)
    body = render(layout_rows(node, notation) if rows else layout(node, notation))
    block = ' display="block"' if display else ""
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML"{block}>{body}</math>'


def render(box: b.Box) -> str:
    """The MathML of boxes: exactly one element."""
    return TABLE[type(box)](box)


def _letter(box: b.Letter) -> str:
    return _STYLES[box.style](box.text)


def _italic(text: str) -> str:
    normal = ' mathvariant="normal"' if text in UPRIGHT_CAPITALS else ""
    return f"<mi{normal}>{escape(text)}</mi>"


def _upright(text: str) -> str:
    normal = ' mathvariant="normal"' if len(text) == 1 else ""
    return f"<mi{normal}>{escape(text)}</mi>"


def _script_letter(text: str) -> str:
    return f"<mi>{script(text)}</mi>"


def _number(text: str) -> str:
    return f"<mn>{escape(text)}</mn>"


_STYLES = {"italic": _italic, "upright": _upright, "script": _script_letter, "number": _number}


def _phrase(box: b.Phrase) -> str:
    words = escape(box.text.replace(" ", "\u00a0"))
    return f'<mi mathvariant="normal">{words}</mi>'


def _operator(box: b.Operator) -> str:
    return _OPERATORS[box.kind].format(escape(_SIGNS.get(box.sign, box.sign)))


_OPERATORS = {
    "binary": "<mo>{}</mo>",
    "relation": '<mo form="infix" lspace="0.2778em" rspace="0.2778em">{}</mo>',
    "prefix": '<mo form="prefix">{}</mo>',
    "mark": '<mo lspace="0" rspace="0" stretchy="false">{}</mo>',
}


def _big(box: b.Big) -> str:
    return f"<mo>{box.sign}</mo>"


def _space(box: b.Space) -> str:
    return _THIN


def _times(box: b.Times) -> str:
    return "<mo>\u2062</mo>"


def _accent(box: b.Accent) -> str:
    if box.kind == "bold" and isinstance(box.body, b.Letter):
        return f'<mi mathvariant="normal">{bold(box.body.text)}</mi>'
    size = ' mathsize="70%"' if box.kind == "vec" else ""
    sign = f'<mo stretchy="false" lspace="0" rspace="0"{size}>{_ACCENTS.get(box.kind, "")}</mo>'
    return f'<mover accent="true">{render(box.body)}{sign}</mover>'


def _prime(box: b.Prime) -> str:
    return f'<mo lspace="0" rspace="0">{"′" * box.count}</mo>'


def _script(box: b.Script) -> str:
    if box.base == b.Big("∑"):
        return f"<munder>{render(box.base)}{render(box.sub)}</munder>"
    primes, sup = b.split_primes(box.sup)
    base = render(box.base)
    base = f"<mrow>{base}{_prime(b.Prime(primes))}</mrow>" if primes else base
    name = _SCRIPTS[box.sub is not None, sup is not None]
    raised = _beside_slant(box.base, render(sup)) if sup and not primes else render(sup) if sup else ""
    return f"<{name}>{base}{render(box.sub) if box.sub else ''}{raised}</{name}>"


def _beside_slant(base: b.Box, raised: str) -> str:
    """What is raised beside a letter, moved off its slanted arm: browsers leave out the italic correction."""
    letter = base.body if isinstance(base, b.Accent) else base
    room = _SLANTS.get(letter.text) if isinstance(letter, b.Letter) and letter.style == "italic" else None
    return f'<mrow><mspace width="{room}em"/>{raised}</mrow>' if room else raised


# the italic corrections of Latin Modern Math, in em of the small letters that are raised
_SLANTS = {
    "C": 0.1, "F": 0.19, "H": 0.11, "I": 0.12, "J": 0.15, "K": 0.1, "M": 0.15, "N": 0.15, "P": 0.2, "S": 0.09,
    "T": 0.21, "U": 0.15, "V": 0.31, "W": 0.19, "Y": 0.3, "Z": 0.1, "f": 0.13, "ζ": 0.09, "ν": 0.08, "τ": 0.15,
}  # fmt: skip


_SCRIPTS = {
    (False, False): "mrow", (True, False): "msub", (False, True): "msup", (True, True): "msubsup",
}  # fmt: skip


def _under(box: b.Under) -> str:
    return f"<munder>{render(box.base)}{render(box.under)}</munder>"


def _fraction(box: b.Fraction) -> str:
    return f"<mfrac>{render(box.num)}{render(box.den)}</mfrac>"


def _radical(box: b.Radical) -> str:
    return f"<msqrt>{render(box.body)}</msqrt>"


def _fence(box: b.Fence) -> str:
    left = _delimiter(box.opening, "prefix", tall=box.tall)
    right = _delimiter(box.closing, "postfix", tall=box.tall)
    return f"<mrow>{left}{render(box.body)}{right}</mrow>"


def _delimiter(sign: str, form: str, *, tall: bool) -> str:
    stretchy = "true" if tall else "false"
    return f'<mo form="{form}" fence="true" stretchy="{stretchy}">{sign}</mo>' if sign else ""


def _function(box: b.Function) -> str:
    return f"<mi>{box.name}</mi>"


def _applied(box: b.Applied) -> str:
    gap = "" if isinstance(box.arg, b.Fence) else _THIN
    return f"<mrow>{render(box.head)}{_APPLY}{gap}{render(box.arg)}</mrow>"


def _row(box: b.Row) -> str:
    items = box.items
    around = zip((None, *items), items, (*items[1:], None), strict=False)
    return f"<mrow>{''.join(_in_row(*three) for three in around)}</mrow>"


def _in_row(before: b.Box | None, box: b.Box, after: b.Box | None) -> str:
    """A box of a row; the invisible sign gets a thin space beside a function."""
    beside = isinstance(box, b.Times) and isinstance(after, b.Applied)
    open_before = isinstance(before, b.Applied) and not isinstance(before.arg, b.Fence)
    behind = isinstance(box, b.Times) and open_before
    return render(box) + (_THIN if beside or behind else "")


def _rows(box: b.Rows) -> str:
    rows = "".join(
        f'<mtr><mtd style="text-align:right;padding-right:0">{render(left)}</mtd>'
        f'<mtd style="text-align:left;padding-left:0">{render(right)}</mtd></mtr>'
        for left, right in box.rows
    )
    return f'<mtable displaystyle="true">{rows}</mtable>'


TABLE: dict[type, Callable[..., str]] = {
    b.Letter: _letter, b.Phrase: _phrase, b.Operator: _operator, b.Big: _big, b.Space: _space,
    b.Times: _times, b.Accent: _accent, b.Prime: _prime, b.Script: _script, b.Under: _under,
    b.Fraction: _fraction, b.Radical: _radical, b.Fence: _fence, b.Function: _function,
    b.Applied: _applied, b.Row: _row, b.Rows: _rows,
}  # fmt: skip
