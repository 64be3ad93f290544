"""Office MathML of a formula: the native equations of Word. One function a box.

The sign of an integral or sum holds what follows it in its row, as far as the next + − or relation sign.
"""

from __future__ import annotations

from collections.abc import Callable
from html import escape

from rbpsym.notation import boxes as b
from rbpsym.notation.glyphs import DEFAULT, Notation
from rbpsym.notation.layout import layout, layout_rows
from rbpsym.notation.letters import UPRIGHT_CAPITALS, bold
from rbpsym.notation.tree import Node, System

NAMESPACE = "http://schemas.openxmlformats.org/officeDocument/2006/math"
_ACCENTS = {
    "vec": "\u20d7", "hat": "\u0302", "bar": "\u0305", "tilde": "\u0303", "check": "\u030c", "dot": "\u0307",
    "ddot": "\u0308", "dddot": "\u20db",
}  # fmt: skip
_SIGNS = {"·": "⋅"}
_ENDS = frozenset("+−")


def to_omml(node: Node, notation: Notation = DEFAULT, *, aligned: bool = False) -> str:
    """An `m:oMath` element; `aligned` breaks a chain into rows that meet at their relation signs."""
    rows_asked = aligned or isinstance(node, System)
    return formula(render(layout_rows(node, notation) if rows_asked else layout(node, notation)))


def formula(content: str) -> str:
    """The element that holds rendered boxes."""
    return f'<m:oMath xmlns:m="{NAMESPACE}">{content}</m:oMath>'


def render(box: b.Box) -> str:
    """The elements of boxes, side by side."""
    return TABLE[type(box)](box)


def rows(pairs: list[tuple[str, str]]) -> str:
    """Rows of rendered boxes as two columns that meet without a gap."""
    lines = "".join(f"<m:mr><m:e>{left or NOTHING}</m:e><m:e>{NOTHING}{right}</m:e></m:mr>" for left, right in pairs)
    return f"<m:m><m:mPr>{_TIGHT}<m:mcs>{_column('right')}{_column('left')}</m:mcs></m:mPr>{lines}</m:m>"


def _column(side: str) -> str:
    return f'<m:mc><m:mcPr><m:count m:val="1"/><m:mcJc m:val="{side}"/></m:mcPr></m:mc>'


_TIGHT = '<m:cGpRule m:val="3"/><m:cGp m:val="0"/>'
# an operand that is not seen: a sign with which a row begins keeps its spaces, and LibreOffice wants one
NOTHING = "<m:r><m:rPr><m:nor/></m:rPr><m:t>\u200b</m:t></m:r>"


def run(text: str, style: str = "p") -> str:
    """Characters in one style: "p" upright, "i" italic, "b" bold."""
    space = ' xml:space="preserve"' if text != text.strip() else ""
    return f'<m:r><m:rPr><m:sty m:val="{style}"/></m:rPr><m:t{space}>{escape(text, quote=False)}</m:t></m:r>'


def _upright(text: str) -> str:
    """A word is ordinary text: LibreOffice knows no other upright letters."""
    if len(text) < 2:
        return run(text)
    return f"<m:r><m:rPr><m:nor/></m:rPr><m:t>{escape(text, quote=False)}</m:t></m:r>"


def _letter(box: b.Letter) -> str:
    return _STYLES[box.style](box.text)


def _italic(text: str) -> str:
    return run(text, "p" if text in UPRIGHT_CAPITALS else "i")


def _script_letter(text: str) -> str:
    style = '<m:scr m:val="script"/><m:sty m:val="p"/>'
    return f"<m:r><m:rPr>{style}</m:rPr><m:t>{escape(text, quote=False)}</m:t></m:r>"


_STYLES: dict[str, Callable[[str], str]] = {
    "italic": _italic, "upright": _upright, "script": _script_letter, "number": run,
}  # fmt: skip


def _phrase(box: b.Phrase) -> str:
    text = escape(f" {box.text.strip()} ", quote=False)
    return f'<m:r><m:rPr><m:nor/></m:rPr><m:t xml:space="preserve">{text}</m:t></m:r>'


def _operator(box: b.Operator) -> str:
    return run(_SIGNS.get(box.sign, box.sign))


def _accent(box: b.Accent) -> str:
    if box.kind == "bold":
        return run(bold(box.body.text)) if isinstance(box.body, b.Letter) else render(box.body)
    sign = f'<m:accPr><m:chr m:val="{_ACCENTS[box.kind]}"/></m:accPr>'
    return f"<m:acc>{sign}<m:e>{render(box.body)}</m:e></m:acc>"


def _prime(box: b.Prime) -> str:
    return run("′" * box.count)


def _script(box: b.Script) -> str:
    if isinstance(box.base, b.Big):
        return nary(box, "")
    sub = f"<m:sub>{render(box.sub)}</m:sub>" if box.sub else ""
    sup = f"<m:sup>{render(box.sup)}</m:sup>" if box.sup else ""
    name = _SCRIPTS[bool(sub), bool(sup)]
    base = render(box.base)
    return f"<m:{name}><m:e>{base}</m:e>{sub}{sup}</m:{name}>" if name else base


_SCRIPTS = {(False, False): "", (True, False): "sSub", (False, True): "sSup", (True, True): "sSubSup"}


def nary(box: b.Box, body: str) -> str:
    """The sign of an integral or sum with its limits before what it applies to."""
    script = box if isinstance(box, b.Script) else b.Script(box)
    place = "undOvr" if script.base == b.Big("∑") else "subSup"
    hidden = "".join(f'<m:{n}Hide m:val="1"/>' for n, part in (("sub", script.sub), ("sup", script.sup)) if not part)
    settings = f'<m:naryPr><m:chr m:val="{script.base.sign}"/><m:limLoc m:val="{place}"/>{hidden}</m:naryPr>'
    ends = "".join(
        f"<m:{name}>{render(part) if part else ''}</m:{name}>"
        for name, part in (("sub", script.sub), ("sup", script.sup))
    )
    return f"<m:nary>{settings}{ends}<m:e>{body}</m:e></m:nary>"


def is_large(box: b.Box) -> bool:
    """Is it the sign of an integral or sum, with or without limits?"""
    return isinstance(box, b.Big) or (isinstance(box, b.Script) and isinstance(box.base, b.Big))


def _row(box: b.Row) -> str:
    return _side_by_side(box.items)


def _side_by_side(items: tuple[b.Box, ...]) -> str:
    place = next((k for k, item in enumerate(items) if is_large(item)), None)
    if place is None:
        return "".join(map(render, items))
    after = items[place + 1 :]
    end = next((k for k, item in enumerate(after) if _ends_body(item)), len(after))
    body = nary(items[place], _side_by_side(after[:end]))
    return "".join(map(render, items[:place])) + body + _side_by_side(after[end:])


def _ends_body(item: b.Box) -> bool:
    """Does what a sign applies to end before this item?"""
    return isinstance(item, b.Operator) and (item.kind == "relation" or item.sign in _ENDS)


def _under(box: b.Under) -> str:
    return f"<m:limLow><m:e>{render(box.base)}</m:e><m:lim>{render(box.under)}</m:lim></m:limLow>"


def _fraction(box: b.Fraction) -> str:
    return f"<m:f><m:num>{render(box.num)}</m:num><m:den>{render(box.den)}</m:den></m:f>"


def _radical(box: b.Radical) -> str:
    return f'<m:rad><m:radPr><m:degHide m:val="1"/></m:radPr><m:deg/><m:e>{render(box.body)}</m:e></m:rad>'


def _fence(box: b.Fence) -> str:
    signs = f'<m:begChr m:val="{box.opening}"/><m:endChr m:val="{box.closing}"/>'
    return f"<m:d><m:dPr>{signs}</m:dPr><m:e>{render(box.body)}</m:e></m:d>"


def _applied(box: b.Applied) -> str:
    return f"<m:func><m:fName>{render(box.head)}</m:fName><m:e>{render(box.arg)}</m:e></m:func>"


def _rows(box: b.Rows) -> str:
    return rows([(render(left), render(right)) for left, right in box.rows])


TABLE: dict[type, Callable[..., str]] = {
    b.Letter: _letter, b.Phrase: _phrase, b.Operator: _operator, b.Big: lambda box: nary(box, ""),
    b.Space: lambda box: run("\u2009"), b.Times: lambda box: "", b.Accent: _accent, b.Prime: _prime,
    b.Script: _script, b.Under: _under, b.Fraction: _fraction, b.Radical: _radical, b.Fence: _fence,
    b.Function: lambda box: run(box.name), b.Applied: _applied, b.Row: _row, b.Rows: _rows,
}  # fmt: skip
