"""Boxes of numbers, names, fractions and delimiters."""

from __future__ import annotations

from fractions import Fraction as Rational

from rbpsym.notation import boxes as b
from rbpsym.notation import tree as t
from rbpsym.notation.drawing import glyph_box, unit_box
from rbpsym.notation.levels import POWER, PRODUCT, is_decimal, is_open, plain_fraction
from rbpsym.notation.setting import Style, draw, draws, fenced, wrapped

MINUS = b.Operator("−", "prefix")
VULGAR = {
    Rational(1, 2): "½", Rational(1, 3): "⅓", Rational(2, 3): "⅔", Rational(1, 4): "¼",
    Rational(3, 4): "¾", Rational(1, 5): "⅕", Rational(2, 5): "⅖", Rational(3, 5): "⅗",
    Rational(4, 5): "⅘", Rational(1, 6): "⅙", Rational(5, 6): "⅚", Rational(1, 8): "⅛",
    Rational(3, 8): "⅜", Rational(5, 8): "⅝", Rational(7, 8): "⅞",
}  # fmt: skip


@draws(t.Num)
def _num(node: t.Num, style: Style) -> b.Box:
    value = Rational(node.value)
    if value < 0:
        return b.Row((MINUS, _num(t.Num(-value), style)))
    if value.denominator == 1:
        return b.Letter(str(value.numerator), "number")
    if is_decimal(value):
        return b.Letter(_decimal(value, style.notation.decimal), "number")
    return _fraction_of_numbers(value, style)


def _decimal(value: Rational, mark: str) -> str:
    """9.81 for 981/100"""
    digits = len(str(value.denominator)) * 4
    whole, rest = divmod(int(value * 10**digits), 10**digits)
    return f"{whole}{mark}{str(rest).zfill(digits).rstrip('0')}"


def _fraction_of_numbers(value: Rational, style: Style) -> b.Box:
    return _div(t.Div(t.Num(value.numerator), t.Num(value.denominator)), style)


@draws(t.Sym)
def _sym(node: t.Sym, style: Style) -> b.Box:
    return glyph_box(style.notation.glyph(node.name))


@draws(t.Vec)
def _vec(node: t.Vec, style: Style) -> b.Box:
    kind = {"arrow": "vec", "bold": "bold"}[style.notation.vector]
    return glyph_box(style.notation.glyph(node.name), kind)


@draws(t.Unit)
def _unit(node: t.Unit, style: Style) -> b.Box:
    return unit_box(node.axis)


@draws(t.Div)
def _div(node: t.Div, style: Style) -> b.Box:
    if style.mode == "display":
        return b.Fraction(draw(node.num, style), draw(node.den, style))
    if _is_vulgar(node, style):
        return b.Letter(VULGAR[_ratio(node)], "number")
    num = wrapped(node.num, PRODUCT, style)
    if plain_fraction(node.num) or is_open(node.num):
        num = fenced(draw(node.num, style))
    return b.Row((num, b.Operator("/", "mark"), wrapped(node.den, POWER, style)))


def is_slashed(node: t.Node, style: Style) -> bool:
    """Is the node written with a slash in one line (and not as ½)?"""
    return plain_fraction(node) and not _is_vulgar(node, style)


def _is_vulgar(node: t.Node, style: Style) -> bool:
    """Is the node one character in text, such as ½?"""
    return style.mode == "text" and _ratio(node) in VULGAR


def _ratio(node: t.Node) -> Rational | None:
    """The value of a number or of a fraction of two whole numbers as written in lowest terms."""
    if isinstance(node, t.Div) and isinstance(node.num, t.Num) and isinstance(node.den, t.Num):
        value = Rational(node.num.value) / node.den.value if node.den.value else None
        return value if value and value.numerator == node.num.value else None
    return Rational(node.value) if isinstance(node, t.Num) else None


@draws(t.Abs)
def _abs(node: t.Abs, style: Style) -> b.Box:
    return fenced(draw(node.arg, style), "|", "|")


@draws(t.Group)
def _group(node: t.Group, style: Style) -> b.Box:
    closing = {"(": ")", "[": "]"}[node.kind]
    return fenced(draw(node.arg, style), node.kind, closing)


@draws(t.Word)
def _word(node: t.Word, style: Style) -> b.Box:
    return b.Phrase(node.text)
