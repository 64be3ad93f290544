"""Office MathML of a formula: the native equations of Word. One method a box.

The sign of an integral or sum holds what follows it in its row, as far as the next + − or relation sign.
"""

from __future__ import annotations

from html import escape

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.letters import UPRIGHT_CAPITALS, bold
from rbpsym.expr.tree import Node
from rbpsym.typeset import boxes as b
from rbpsym.typeset.layout import Printer

NAMESPACE = "http://schemas.openxmlformats.org/officeDocument/2006/math"
_ACCENTS = {
    "vec": "\u20d7", "hat": "\u0302", "bar": "\u0305", "tilde": "\u0303", "check": "\u030c", "dot": "\u0307",
    "ddot": "\u0308", "dddot": "\u20db",
}  # fmt: skip
_SIGNS = {"·": "⋅"}
_ENDS = frozenset("+−")


def to_omml(node: Node, notation: Notation = DEFAULT) -> str:
    """An `m:oMath` element."""
    return formula(render.formula(node, notation))


def formula(content: str) -> str:
    """The element that holds rendered boxes."""
    return f'<m:oMath xmlns:m="{NAMESPACE}">{content}</m:oMath>'


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


_SCRIPTS = {(False, False): "", (True, False): "sSub", (False, True): "sSup", (True, True): "sSubSup"}


def nary(box: b.Box, body: str) -> str:
    """The sign of an integral or sum with its limits before what it applies to."""
    script = box if isinstance(box, b.Script) else b.Script(box)
    assert isinstance(script.base, b.Big)
    place = "undOvr" if script.base.sign == "∑" else "subSup"
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


_FORMS = {
    "under": "<m:limLow><m:e>%(base)s</m:e><m:lim>%(under)s</m:lim></m:limLow>",
    "fraction": "<m:f><m:num>%(num)s</m:num><m:den>%(den)s</m:den></m:f>",
    "radical": '<m:rad><m:radPr><m:degHide m:val="1"/></m:radPr><m:deg/><m:e>%(body)s</m:e></m:rad>',
    "applied": "<m:func><m:fName>%(head)s</m:fName><m:e>%(arg)s</m:e></m:func>",
    "fence": '<m:d><m:dPr><m:begChr m:val="%(opening)s"/><m:endChr m:val="%(closing)s"/></m:dPr><m:e>%(body)s</m:e></m:d>',
}


class _Omml(Printer):
    """Office MathML: elements side by side."""

    forms = _FORMS

    def operator(self, box: b.Operator) -> str:
        return run(_SIGNS.get(box.sign, box.sign))

    def big(self, box: b.Big) -> str:
        return nary(box, "")

    def thin(self, box: b.Thin) -> str:
        return run("\u2009")

    def function(self, box: b.Function) -> str:
        return run(box.name)

    def phrase(self, box: b.Phrase) -> str:
        text = escape(f" {box.text.strip()} ", quote=False)
        return f'<m:r><m:rPr><m:nor/></m:rPr><m:t xml:space="preserve">{text}</m:t></m:r>'

    def accent(self, box: b.Accent) -> str:
        if box.kind == "bold":
            return run(bold(box.body.text)) if isinstance(box.body, b.Letter) else self(box.body)
        sign = f'<m:accPr><m:chr m:val="{_ACCENTS[box.kind]}"/></m:accPr>'
        return f"<m:acc>{sign}<m:e>{self(box.body)}</m:e></m:acc>"

    def prime(self, box: b.Prime) -> str:
        return run("′" * box.count)

    def script(self, box: b.Script) -> str:
        if isinstance(box.base, b.Big):
            return nary(box, "")
        sub = f"<m:sub>{self(box.sub)}</m:sub>" if box.sub else ""
        sup = f"<m:sup>{self(box.sup)}</m:sup>" if box.sup else ""
        name = _SCRIPTS[bool(sub), bool(sup)]
        base = self(box.base)
        return f"<m:{name}><m:e>{base}</m:e>{sub}{sup}</m:{name}>" if name else base

    def row(self, box: b.Row) -> str:
        return _side_by_side(box.items)

    def rows(self, box: b.Rows) -> str:
        return rows([(self(left), self(right)) for left, right in box.rows])

    def in_italic(self, text: str) -> str:
        return run(text, "p" if text in UPRIGHT_CAPITALS else "i")

    def in_upright(self, text: str) -> str:
        """A word is ordinary text: LibreOffice knows no other upright letters."""
        if len(text) < 2:
            return run(text)
        return f"<m:r><m:rPr><m:nor/></m:rPr><m:t>{escape(text, quote=False)}</m:t></m:r>"

    def in_number(self, text: str) -> str:
        return run(text)

    def in_script(self, text: str) -> str:
        style = '<m:scr m:val="script"/><m:sty m:val="p"/>'
        return f"<m:r><m:rPr>{style}</m:rPr><m:t>{escape(text, quote=False)}</m:t></m:r>"


render = _Omml()
