"""Boxes of numbers, names, fractions and delimiters; of functions, powers and roots; of sums and products."""

from __future__ import annotations

from fractions import Fraction as Rational

from rbpsym.expr import tree as t
from rbpsym.typeset import boxes as b
from rbpsym.typeset.setting import (
    POWER,
    PRODUCT,
    SUM,
    LayoutStyle,
    attach_sup,
    attached,
    draw,
    draws,
    factors_of,
    fenced,
    glyph_box,
    is_decimal,
    is_open,
    level,
    plain_fraction,
    signed,
    unit_box,
    wrapped,
)

MINUS = b.Operator("−", "prefix")
VULGAR = {
    Rational(1, 2): "½", Rational(1, 3): "⅓", Rational(2, 3): "⅔", Rational(1, 4): "¼",
    Rational(3, 4): "¾", Rational(1, 5): "⅕", Rational(2, 5): "⅖", Rational(3, 5): "⅗",
    Rational(4, 5): "⅘", Rational(1, 6): "⅙", Rational(5, 6): "⅚", Rational(1, 8): "⅛",
    Rational(3, 8): "⅜", Rational(5, 8): "⅝", Rational(7, 8): "⅞",
}  # fmt: skip


@draws(t.Num)
def _num(node: t.Num, style: LayoutStyle) -> b.Box:
    value = Rational(node.value)
    if value < 0:
        return b.Row((MINUS, _num(t.Num(-value), style)))
    if value.denominator == 1:
        return b.Letter(str(value.numerator), "number")
    if is_decimal(value):
        return b.Letter(_decimal(value, style.notation.decimal), "number")
    return _div(t.Div(t.Num(value.numerator), t.Num(value.denominator)), style)


def _decimal(value: Rational, mark: str) -> str:
    """9.81 for 981/100"""
    digits = len(str(value.denominator)) * 4
    whole, rest = divmod(int(value * 10**digits), 10**digits)
    return f"{whole}{mark}{str(rest).zfill(digits).rstrip('0')}"


@draws(t.Sym)
def _sym(node: t.Sym, style: LayoutStyle) -> b.Box:
    return glyph_box(style.notation.glyph(node.name))


@draws(t.Vec)
def _vec(node: t.Vec, style: LayoutStyle) -> b.Box:
    glyph = style.notation.glyph(node.name)
    return glyph_box(glyph, "" if glyph.accent == "hat" else {"arrow": "vec", "bold": "bold"}[style.notation.vector])


@draws(t.Unit)
def _unit(node: t.Unit, style: LayoutStyle) -> b.Box:
    return unit_box(node.axis)


@draws(t.Div)
def _div(node: t.Div, style: LayoutStyle) -> b.Box:
    if style.mode == "display":
        return b.Fraction(draw(node.num, style), draw(node.den, style))
    if vulgar := _vulgar(node, style):
        return b.Letter(vulgar, "number")
    num = wrapped(node.num, PRODUCT, style)
    if plain_fraction(node.num) or is_open(node.num):
        num = fenced(draw(node.num, style))
    return b.Row((num, b.Operator("/", "mark"), wrapped(node.den, POWER, style)))


def is_slashed(node: t.Node, style: LayoutStyle) -> bool:
    """Is the node written with a slash in one line (and not as ½)?"""
    return plain_fraction(node) and not _vulgar(node, style)


def _vulgar(node: t.Node, style: LayoutStyle) -> str:
    """The one character that the node is in text, such as ½; none is empty."""
    ratio = _ratio(node) if style.mode == "text" else None
    return VULGAR.get(ratio, "") if ratio else ""


def _ratio(node: t.Node) -> Rational | None:
    """The value of a number or of a fraction of two whole numbers as written in lowest terms."""
    if isinstance(node, t.Div) and isinstance(node.num, t.Num) and isinstance(node.den, t.Num):
        value = Rational(node.num.value) / node.den.value if node.den.value else None
        return value if value and value.numerator == node.num.value else None
    return Rational(node.value) if isinstance(node, t.Num) else None


@draws(t.Abs)
def _abs(node: t.Abs, style: LayoutStyle) -> b.Box:
    return fenced(draw(node.arg, style), "|", "|")


@draws(t.Group)
def _group(node: t.Group, style: LayoutStyle) -> b.Box:
    closing = {"(": ")", "[": "]"}[node.kind]
    return fenced(draw(node.arg, style), node.kind, closing)


@draws(t.Word)
def _word(node: t.Word, style: LayoutStyle) -> b.Box:
    return b.Phrase(node.text)


WRITTEN = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "elliptic_k": "K", "elliptic_e": "E"}
OF_SQUARE = frozenset({"elliptic_k", "elliptic_e"})  # told of the modulus k, and known as functions of k²
TRIGONOMETRIC = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})


@draws(t.Pow)
def _pow(node: t.Pow, style: LayoutStyle) -> b.Box:
    if is_function_power(node):
        return applied(node, style)
    sup = draw(node.exponent, style.script)
    base = draw(_magnitude(node), style)
    if level(node.base, style.mode) < POWER + 1 or plain_fraction(node.base) or not attached(base):
        base = fenced(base)
    return attach_sup(base, sup)


def _magnitude(node: t.Pow) -> t.Node:
    """The base, without its arrow where the square of a vector is the square of its magnitude: V²."""
    return t.Sym(node.base.name) if isinstance(node.base, t.Vec) and node.exponent == t.TWO else node.base


def is_function_power(node: t.Node) -> bool:
    """Is it a power that is written sin²θ?"""
    if not (isinstance(node, t.Pow) and isinstance(node.base, t.Fn)):
        return False
    n = node.exponent.value if isinstance(node.exponent, t.Num) else 0
    return node.base.name in TRIGONOMETRIC and n > 1 and Rational(n).denominator == 1


@draws(t.Sqrt)
def _sqrt(node: t.Sqrt, style: LayoutStyle) -> b.Box:
    return b.Radical(draw(node.arg, style))


@draws(t.Fn)
def _fn(node: t.Fn, style: LayoutStyle) -> b.Box:
    return applied(node, style)


def applied(node: t.Node, style: LayoutStyle, *, closed: bool = False) -> b.Box:
    """A function (or its power) before its argument, in parentheses unless it is simple."""
    call = node.base if isinstance(node, t.Pow) else node
    assert isinstance(call, t.Fn)  # a power of a function, written sin² x
    head: b.Box = b.Function(style.notation.functions.get(call.name) or WRITTEN.get(call.name, call.name))
    if isinstance(node, t.Pow):
        head = b.Script(head, None, draw(node.exponent, style))
    inner = _modulus(call.arg) if call.name in OF_SQUARE else call.arg
    arg = draw(inner, style)
    closed = closed or call.name == "exp" or call.name in OF_SQUARE
    bare = isinstance(inner, t.Group) or (not closed and _is_simple_argument(inner, style))
    return b.Applied(head, arg if bare else fenced(arg))


def _modulus(square: t.Node) -> t.Node:
    """The root of what is printed, without it where that is a square."""
    return square.base if isinstance(square, t.Pow) and square.exponent == t.TWO else t.Sqrt(square)


def _is_simple_argument(node: t.Node, style: LayoutStyle) -> bool:
    """Is it an argument that a textbook writes without parentheses: θ, 2θ, θ/2?"""
    if isinstance(node, t.Sym):
        return not style.notation.glyph(node.name).prefix
    if plain_fraction(node) and style.mode != "display":
        return False
    if isinstance(node, t.Num):
        return node.value >= 0
    if isinstance(node, t.Div):
        return is_simple_product(node.num) and is_simple_product(node.den)
    symbols = [part for part in t.walk(node) if isinstance(part, t.Sym)]
    return len(symbols) <= 1 and is_simple_product(node)


def is_simple_product(node: t.Node) -> bool:
    """A number, a symbol, or up to three of them with numbers only in front."""
    if isinstance(node, t.Num):
        return node.value >= 0 and Rational(node.value).denominator == 1
    if isinstance(node, t.Mul):
        first, *rest = factors_of(node)
        return (
            0 < len(rest) < 3
            and isinstance(first, (t.Num, t.Sym))
            and is_simple_product(first)
            and all(isinstance(factor, t.Sym) for factor in rest)
        )
    return isinstance(node, t.Sym)


@draws(t.Add)
def _add(node: t.Add, style: LayoutStyle) -> b.Box:
    if not node.terms:
        return draw(t.ZERO, style)
    items: list[b.Box] = []
    for position, term in enumerate(node.terms):
        negative, body = signed(term)
        if position:
            items.append(b.Operator("−" if negative else "+"))
        elif negative:
            items.append(MINUS)
        items.append(wrapped(body, SUM + 1, style))
    return b.Row(tuple(items))


@draws(t.Neg)
def _neg(node: t.Neg, style: LayoutStyle) -> b.Box:
    negative, body = signed(node)
    box = wrapped(body, SUM + 1, style) if negative else draw(body, style)
    return b.Row((MINUS, box)) if negative else box


@draws(t.Mul)
def _mul(node: t.Mul, style: LayoutStyle) -> b.Box:
    negative, body = signed(node)
    if negative or not isinstance(body, t.Mul):
        return draw(t.Neg(body) if negative else body, style)
    factors = factors_of(body)
    items: list[b.Box] = []
    for position, factor in enumerate(factors):
        after = factors[position + 1] if position + 1 < len(factors) else None
        if position:
            items.append(_between(factors[position - 1], factor, style))
        items.append(_factor(factor, after, style))
    return b.Row(tuple(items))


def _factor(factor: t.Node, after: t.Node | None, style: LayoutStyle) -> b.Box:
    if after is None:
        return wrapped(factor, PRODUCT, style)
    if is_open(factor):
        return fenced(draw(factor, style))
    if _ends_in_function(factor) and not (_ends_in_function(after) or isinstance(after, (t.Unit, t.Vec))):
        return applied(factor, style, closed=True)
    slashed = style.mode != "display" and is_slashed(factor, style)
    return fenced(draw(factor, style)) if slashed else wrapped(factor, PRODUCT, style)


def _ends_in_function(node: t.Node) -> bool:
    return isinstance(node, t.Fn) or is_function_power(node)


def _between(left: t.Node, right: t.Node, style: LayoutStyle) -> b.Box:
    """What stands between two factors: a dot before a number, a thin space around words."""
    if starts_with_digit(right) or (isinstance(left, t.Num) and _is_numeric_fraction(right)):
        return b.Operator("·")
    if isinstance(right, (t.Unit, t.Word)) or isinstance(left, t.Word):
        return b.Thin()
    if _is_wordy(left, style) or _is_wordy(right, style):
        return b.Thin()
    return b.Times()


def starts_with_digit(node: t.Node) -> bool:
    """Does the node's print begin with a digit?"""
    if isinstance(node, t.Pow):
        return starts_with_digit(node.base)
    return isinstance(node, t.Num) and node.value >= 0 and not plain_fraction(node)


def _is_numeric_fraction(node: t.Node) -> bool:
    return plain_fraction(node) and (
        isinstance(node, t.Num) or (isinstance(node, t.Div) and starts_with_digit(node.num))
    )


def _is_wordy(node: t.Node, style: LayoutStyle) -> bool:
    return isinstance(node, t.Sym) and style.notation.glyph(node.name).style == "upright"


@draws(t.Cross, t.Dot)
def _cross(node: t.Cross | t.Dot, style: LayoutStyle) -> b.Box:
    sign = "×" if isinstance(node, t.Cross) else "·"
    left = wrapped(node.left, PRODUCT, style)
    left = fenced(left) if is_open(node.left) else left
    return b.Row((left, b.Operator(sign), wrapped(node.right, PRODUCT, style)))
