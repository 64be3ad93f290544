"""Hyperbolic functions and their inverses as exponentials, roots and logarithms."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from rbpsym.expr import tree as t

Made = Callable[[t.Node], t.Node]


def _exp(node: t.Node) -> t.Node:
    return t.Fn("exp", node)


def _sinh(node: t.Node) -> t.Node:
    return t.Div(t.Add((_exp(node), t.Neg(_exp(t.Neg(node))))), t.TWO)


def _cosh(node: t.Node) -> t.Node:
    return t.Div(t.Add((_exp(node), _exp(t.Neg(node)))), t.TWO)


def _tanh(node: t.Node) -> t.Node:
    return t.Div(_sinh(node), _cosh(node))


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


HYPERBOLIC: Mapping[str, Made] = MappingProxyType({
    "sinh": _sinh, "cosh": _cosh, "tanh": _tanh, "sech": _over_one(_cosh), "csch": _over_one(_sinh),
    "cosech": _over_one(_sinh), "coth": _over_one(_tanh), "senh": _sinh, "tgh": _tanh,
    **dict.fromkeys(("asinh", "arcsinh", "arsinh", "arcsenh"), _asinh),
    **dict.fromkeys(("acosh", "arccosh", "arcosh"), _acosh), **dict.fromkeys(("atanh", "arctanh", "artanh"), _atanh),
})  # fmt: skip
