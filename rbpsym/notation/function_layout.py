"""Boxes of functions, powers and roots: when `sin` goes without parentheses, when a power does."""

from __future__ import annotations

from fractions import Fraction as Rational

from rbpsym.notation import boxes as b
from rbpsym.notation import tree as t
from rbpsym.notation.drawing import attach_sup, attached
from rbpsym.notation.levels import POWER, factors_of, level, plain_fraction
from rbpsym.notation.setting import Style, draw, draws, fenced

WRITTEN = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}
TRIGONOMETRIC = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})


@draws(t.Pow)
def _pow(node: t.Pow, style: Style) -> b.Box:
    if is_function_power(node):
        return applied(node, style)
    sup = draw(node.exponent, style.script)
    base = draw(_magnitude(node), style)
    if level(node.base, style.mode) < POWER + 1 or plain_fraction(node.base) or not attached(base):
        base = fenced(base)
    return attach_sup(base, sup)


def _magnitude(node: t.Pow) -> t.Node:
    """The base, without its arrow where the square of a vector is the square of its magnitude: V²."""
    squared = isinstance(node.base, t.Vec) and node.exponent == t.TWO
    return t.Sym(node.base.name) if squared else node.base


def is_function_power(node: t.Node) -> bool:
    """Is it a power that is written sin²θ?"""
    if not (isinstance(node, t.Pow) and isinstance(node.base, t.Fn)):
        return False
    n = node.exponent.value if isinstance(node.exponent, t.Num) else 0
    return node.base.name in TRIGONOMETRIC and n > 1 and Rational(n).denominator == 1


@draws(t.Sqrt)
def _sqrt(node: t.Sqrt, style: Style) -> b.Box:
    return b.Radical(draw(node.arg, style))


@draws(t.Fn)
def _fn(node: t.Fn, style: Style) -> b.Box:
    return applied(node, style)


def applied(node: t.Node, style: Style, *, closed: bool = False) -> b.Box:
    """A function (or its power) before its argument, in parentheses unless it is simple."""
    call = node if isinstance(node, t.Fn) else node.base
    head: b.Box = b.Function(style.notation.functions.get(call.name) or WRITTEN.get(call.name, call.name))
    if isinstance(node, t.Pow):
        head = b.Script(head, None, draw(node.exponent, style))
    arg = draw(call.arg, style)
    bare = isinstance(call.arg, t.Group) or (not closed and call.name != "exp" and _is_simple_argument(call.arg, style))
    return b.Applied(head, arg if bare else fenced(arg))


def _is_simple_argument(node: t.Node, style: Style) -> bool:
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
