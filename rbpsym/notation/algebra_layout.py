"""Boxes of sums and products: signs, parentheses, and what stands between two factors."""

from __future__ import annotations

from rbpsym.notation import boxes as b
from rbpsym.notation import tree as t
from rbpsym.notation.atom_layout import is_slashed
from rbpsym.notation.function_layout import applied, is_function_power
from rbpsym.notation.levels import PRODUCT, SUM, factors_of, is_open, plain_fraction, signed
from rbpsym.notation.setting import Style, draw, draws, fenced, wrapped

MINUS = b.Operator("−", "prefix")


@draws(t.Add)
def _add(node: t.Add, style: Style) -> b.Box:
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
def _neg(node: t.Neg, style: Style) -> b.Box:
    negative, body = signed(node)
    box = wrapped(body, SUM + 1, style) if negative else draw(body, style)
    return b.Row((MINUS, box)) if negative else box


@draws(t.Mul)
def _mul(node: t.Mul, style: Style) -> b.Box:
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


def _factor(factor: t.Node, after: t.Node | None, style: Style) -> b.Box:
    if after is None:
        return wrapped(factor, PRODUCT, style)
    if is_open(factor):
        return fenced(draw(factor, style))
    if _ends_in_function(factor) and not _stops_argument(after):
        return applied(factor, style, closed=True)
    slashed = style.mode != "display" and is_slashed(factor, style)
    return fenced(draw(factor, style)) if slashed else wrapped(factor, PRODUCT, style)


def _ends_in_function(node: t.Node) -> bool:
    return isinstance(node, t.Fn) or is_function_power(node)


def _stops_argument(after: t.Node) -> bool:
    """Can no reader take `after` for a part of the argument of the function before it?"""
    return _ends_in_function(after) or isinstance(after, (t.Unit, t.Vec))


def _between(left: t.Node, right: t.Node, style: Style) -> b.Box:
    """What stands between two factors: a dot before a number, a thin space around words."""
    if starts_with_digit(right) or (_is_number(left) and _is_numeric_fraction(right)):
        return b.Operator("·")
    if isinstance(right, (t.Unit, t.Word)) or isinstance(left, t.Word):
        return b.Space()
    if _is_wordy(left, style) or _is_wordy(right, style):
        return b.Space()
    return b.Times()


def starts_with_digit(node: t.Node) -> bool:
    """Does the node's print begin with a digit?"""
    if isinstance(node, t.Pow):
        return starts_with_digit(node.base)
    return isinstance(node, t.Num) and node.value >= 0 and not plain_fraction(node)


def _is_number(node: t.Node) -> bool:
    return isinstance(node, t.Num)


def _is_numeric_fraction(node: t.Node) -> bool:
    return plain_fraction(node) and (
        isinstance(node, t.Num) or (isinstance(node, t.Div) and starts_with_digit(node.num))
    )


def _is_wordy(node: t.Node, style: Style) -> bool:
    return isinstance(node, t.Sym) and style.notation.glyph(node.name).style == "upright"


@draws(t.Cross, t.Dot)
def _cross(node: t.Cross | t.Dot, style: Style) -> b.Box:
    sign = "×" if isinstance(node, t.Cross) else "·"
    left = wrapped(node.left, PRODUCT, style)
    left = fenced(left) if is_open(node.left) else left
    return b.Row((left, b.Operator(sign), wrapped(node.right, PRODUCT, style)))
