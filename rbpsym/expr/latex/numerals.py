"""LaTeX tokens -> numbers, with decimal marks and degrees."""

from __future__ import annotations

import re
from fractions import Fraction as Rational

from rbpsym.expr import tree as t
from rbpsym.expr.symbol_table import LatexReader

DEGREE = t.Div(t.Sym("pi"), t.Num(180))


def number(reader: LatexReader) -> t.Node:
    """A number of adjacent digits, with perhaps a decimal mark."""
    start, digits, commas = reader.token.start, "", 0
    while reader.token.kind == "digit" or (
        reader.sees_sign(".", "{,}") and reader.ahead().kind == "digit" and reader.ahead().start == reader.token.end
    ):
        token = reader.take()
        digits += token.text if token.kind == "digit" else "."
        commas += token.text == "{,}"
    if commas and not reader.table.comma and len(digits.partition(".")[2]) % 3 == 0:
        what = "is this comma a decimal mark, or does it group thousands?"
        raise reader.source.error(what, start, reader.previous_end, "Write a point, as in 1.500, or no mark, as in 1500.")
    if digits[:1] == "0" and digits[1:2].isdigit():
        raise reader.source.error("no number begins with this 0", start, reader.previous_end, "Write indices below, or a point.")
    if len(digits) > 30 or digits.count(".") > 1:
        what = "a number of more than 30 digits" if len(digits) > 30 else "two decimal marks"
        raise reader.source.limit(what, start, reader.previous_end)
    value = Rational(digits)
    value = value / 100 if reader.pass_sign(r"\%") else value
    found = reader.spanned(t.Num(int(value) if value.denominator == 1 else value), start)
    if not reader.pass_sign("°"):
        return found
    if reader.token.text in ("C", "F"):  # a temperature, and no angle
        return reader.spanned(t.Formal("measured", (found, t.Word(f"°{reader.take().text}"))), start)
    return reader.spanned(t.mul(found, DEGREE), start)


_UNIT = r"(?:k?g|[ckm]?m|[mk]?N|[kM]?[JWV]|[km]?s|Hz|rad|K|Pa|[kM]?eV|min|mol)(?:\^\{?-?\d\}?)?"
_UNITS = rf"{_UNIT}(?:\s*(?:/|\\cdot|~|\\[ ,])?\s*{_UNIT}){{0,4}}"
_BEHIND = r"(?:~|\\[ ;]|\\q?quad)"
_RATIO = rf"\\[dt]?frac\s*\{{\s*{_UNITS}\s*\}}\s*\{{[^{{}}]*s[^{{}}]*(?:\{{\d\}})?\}}"
_TENS = r"(?:\s*\\(?:times|cdot)\s*10\s*\^\s*\{?-?\d+\}?)?"


def measured(reader: LatexReader, node: t.Node) -> t.Node:
    """The side of a relation; marked where it is a number and letters that spell a unit, or such a fraction, but may be symbols:
    of these nothing is known, or they stand apart behind a decimal number."""
    gap = rf"(?:{_BEHIND}|\\,)?" if reader.table.open else _BEHIND
    number = rf"-?\s*\d+(?:\.\d+)?{_TENS}" if reader.table.open else r"-?\s*\d+\.\d+"
    text = reader.source.text[slice(*(node.span or (0, 0)))]
    found = re.fullmatch(rf"{number}\s*(?:{gap}\s*(?:{_UNITS})|(?:{_BEHIND}|\\,)?\s*(?:{_RATIO}))\s*", text)
    return t.Formal("spelled", (node,), span=node.span) if found else node
