"""Trees that students write, in the words of the field: e^x, 2^x, hyperbolic functions, cube roots."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from types import MappingProxyType

from rbpsym.errors import ReadError
from rbpsym.notation import tree as t
from rbpsym.notation.infix_names import FUNCTIONS
from rbpsym.notation.limits import number_of

Made = Callable[[t.Node], t.Node]


def _exp(node: t.Node) -> t.Node:
    return t.Fn("exp", node)


def _sinh(node: t.Node) -> t.Node:
    return t.Div(t.Add((_exp(node), t.Neg(_exp(t.Neg(node))))), t.TWO)


def _cosh(node: t.Node) -> t.Node:
    return t.Div(t.Add((_exp(node), _exp(t.Neg(node)))), t.TWO)


def _tanh(node: t.Node) -> t.Node:
    return t.Div(_sinh(node), _cosh(node))


def _log10(node: t.Node) -> t.Node:
    return t.Div(t.Fn("ln", node), t.Fn("ln", t.Num(10)))


def _cbrt(node: t.Node) -> t.Node:
    return t.Pow(node, t.Div(t.ONE, t.Num(3)))


def _over_one(function: Made) -> Made:
    return lambda node: t.Div(t.ONE, function(node))


def _square_and(node: t.Node, one: t.Node) -> t.Node:
    return t.Sqrt(t.Add((t.Pow(node, t.TWO), one)))


def _asinh(node: t.Node) -> t.Node:
    return t.Fn("ln", t.Add((node, _square_and(node, t.ONE))))


def _acosh(node: t.Node) -> t.Node:
    return t.Fn("ln", t.Add((node, _square_and(node, t.Neg(t.ONE)))))


def _atanh(node: t.Node) -> t.Node:
    return t.Div(t.Fn("ln", t.Div(t.Add((t.ONE, node)), t.Add((t.ONE, t.Neg(node))))), t.TWO)


MADE: Mapping[str, Made] = MappingProxyType({
    **FUNCTIONS, "sinh": _sinh, "cosh": _cosh, "tanh": _tanh, "log10": _log10, "lg": _log10, "cbrt": _cbrt, "root": t.Sqrt,
    "log_10": _log10, "cotan": FUNCTIONS["cot"], "sech": _over_one(_cosh), "csch": _over_one(_sinh),
    "cosech": _over_one(_sinh), "coth": _over_one(_tanh),
    "senh": _sinh, "tgh": _tanh,
    **dict.fromkeys(("asinh", "arcsinh", "arsinh"), _asinh), **dict.fromkeys(("acosh", "arccosh", "arcosh"), _acosh),
    **dict.fromkeys(("atanh", "arctanh", "artanh"), _atanh),
})  # fmt: skip
PLAIN = (t.Num, t.Sym, t.Add, t.Neg, t.Mul, t.Div, t.Pow, t.Sqrt, t.Fn, t.Abs, t.Group, t.Deriv, t.Chain)
EULER = "e"


def standard(node: t.Node, typed: Mapping[str, str], has_euler: bool) -> t.Node:
    """The tree with names as the problem has them, e as a number, and powers as exponentials where they vary.

    Raises ReadError for what is no formula of an answer (a vector, an integral, a word).
    """
    if not isinstance(node, PLAIN):
        raise ReadError("only numbers, symbols, roots and functions can be read here", instead="Enter the result.")
    if isinstance(node, t.Sym):
        return _name(node, typed, has_euler)
    inner = mapped(node, lambda part: standard(part, typed, has_euler))
    return _power(inner) if isinstance(inner, t.Pow) else inner


def _name(node: t.Sym, typed: Mapping[str, str], has_euler: bool) -> t.Node:
    if has_euler and node.name == EULER:
        return t.Fn("exp", t.ONE)
    return replace(node, name=typed.get(node.name, node.name))


def mapped(node: t.Node, change: Made) -> t.Node:
    """The node with changed parts."""
    changed = {}
    for item in fields(node):
        part = getattr(node, item.name)
        if isinstance(part, t.Node):
            changed[item.name] = change(part)
        elif isinstance(part, tuple) and item.name not in ("span", "ops"):
            changed[item.name] = tuple(change(one) if isinstance(one, t.Node) else one for one in part)
    return replace(node, **changed) if changed else node


def _power(node: t.Pow) -> t.Node:
    """e^x is exp(x), and a^x is exp(x ln a)."""
    if number_of(node.exponent) is not None:
        return node
    if node.base == t.Fn("exp", t.ONE):
        return _exp(node.exponent)
    return _exp(t.Mul((node.exponent, t.Fn("ln", node.base))))
