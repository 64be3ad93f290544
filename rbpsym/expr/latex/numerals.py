"""LaTeX tokens -> numbers, with decimal marks and degrees."""

from __future__ import annotations

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
