"""Trees that students write, in the words of the field: e^x, 2^x, hyperbolic functions, cube roots."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

from rbpsym.errors import ReadError
from rbpsym.notation import tree as t
from rbpsym.notation.hyperbolic import HYPERBOLIC
from rbpsym.notation.infix_names import FUNCTIONS
from rbpsym.notation.limits import number_of

Made = Callable[[t.Node], t.Node]


def _exp(node: t.Node) -> t.Node:
    return t.Fn("exp", node)


def _log10(node: t.Node) -> t.Node:
    return t.Div(t.Fn("ln", node), t.Fn("ln", t.Num(10)))


def _cbrt(node: t.Node) -> t.Node:
    return t.Pow(node, t.Div(t.ONE, t.Num(3)))


def _of_reciprocal(name: str) -> Made:
    return lambda node: t.Fn(name, t.Div(t.ONE, node))


MADE: Mapping[str, Made] = MappingProxyType({
    **FUNCTIONS, **HYPERBOLIC, "log10": _log10, "lg": _log10, "log_10": _log10, "cbrt": _cbrt, "root": t.Sqrt,
    "cotan": FUNCTIONS["cot"], "tangent": FUNCTIONS["tan"], "sine": FUNCTIONS["sin"], "cosine": FUNCTIONS["cos"],
    **dict.fromkeys(("asec", "arcsec"), _of_reciprocal("acos")), **dict.fromkeys(("acsc", "arccsc"), _of_reciprocal("asin")),
})  # fmt: skip
PLAIN = (t.Num, t.Sym, t.Add, t.Neg, t.Mul, t.Div, t.Pow, t.Sqrt, t.Fn, t.Abs, t.Group, t.Deriv, t.Chain,
         t.Integral)
EULER = "e"


def standard(node: t.Node, typed: Mapping[str, str], has_euler: bool) -> t.Node:
    """The tree with names as the problem has them, e as a number, and powers as exponentials where they vary.

    Raises ReadError for what is no formula of an answer (a vector, an integral without limits, a word).
    """
    if not isinstance(node, PLAIN):
        raise ReadError("only numbers, symbols, roots and functions can be read here", instead="Enter the result.")
    if isinstance(node, t.Sym):
        return _name(node, typed, has_euler)
    inner = t.mapped(node, lambda part: standard(part, typed, has_euler))
    if isinstance(inner, t.Integral):
        return replace(inner, var=typed.get(inner.var, inner.var))
    return _power(inner) if isinstance(inner, t.Pow) else inner


def _name(node: t.Sym, typed: Mapping[str, str], has_euler: bool) -> t.Node:
    if has_euler and node.name == EULER:
        return t.Fn("exp", t.ONE)
    return replace(node, name=typed.get(node.name, node.name))


def _power(node: t.Pow) -> t.Node:
    """e^x is exp(x), and a^x is exp(x ln a)."""
    if number_of(node.exponent) is not None:
        return node
    if node.base == t.Fn("exp", t.ONE):
        return _exp(node.exponent)
    return _exp(t.Mul((node.exponent, t.Fn("ln", node.base))))
