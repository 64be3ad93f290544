"""Hyperbolic functions and their inverses as exponentials, roots and logarithms."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from rbpsym.expr import tree as t

Made = Callable[[t.Node], t.Node]


def _exp(node: t.Node) -> t.Node:
    return t.Fn("exp", node)


def _ln_root(one: t.Node) -> Made:
    return lambda node: t.Fn("ln", t.Add((node, t.Sqrt(t.Add((t.Pow(node, t.TWO), one))))))


def _over(above: Made, below: Made) -> Made:
    return lambda node: t.Div(above(node), below(node))


_SINH = _over(lambda node: t.Add((_exp(node), t.Neg(_exp(t.Neg(node))))), lambda _: t.TWO)
_COSH = _over(lambda node: t.Add((_exp(node), _exp(t.Neg(node)))), lambda _: t.TWO)
_TANH = _over(_SINH, _COSH)
_ATANH = _over(lambda node: t.Fn("ln", t.Div(t.Add((t.ONE, node)), t.Add((t.ONE, t.Neg(node))))), lambda _: t.TWO)
_SECH, _CSCH, _COTH = (_over(lambda _: t.ONE, function) for function in (_COSH, _SINH, _TANH))
HYPERBOLIC: Mapping[str, Made] = MappingProxyType({
    "sinh": _SINH, "cosh": _COSH, "tanh": _TANH, "sech": _SECH, "csch": _CSCH, "cosech": _CSCH, "coth": _COTH, "senh": _SINH,
    "tgh": _TANH, **dict.fromkeys(("asinh", "arcsinh", "arsinh", "arcsenh"), _ln_root(t.ONE)),
    **dict.fromkeys(("acosh", "arccosh", "arcosh"), _ln_root(t.Neg(t.ONE))),
    **dict.fromkeys(("atanh", "arctanh", "artanh"), _ATANH),
})  # fmt: skip
# Names of functions in the languages whose papers are read; behind a backslash, or upright: \\operatorname{sen}.
CIRCULAR: Mapping[str, str] = MappingProxyType({
    **{name: name for name in ("sin", "cos", "tan", "cot", "sec", "csc", "exp", "ln")},
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "log": "ln", "sen": "sin", "tg": "tan", "ctg": "cot", "cotg": "cot",
    "cosec": "csc", "arcsen": "asin", "arctg": "atan",
})  # fmt: skip
FUNCTION_WORDS: Mapping[str, str] = MappingProxyType({**CIRCULAR, **{name: name for name in HYPERBOLIC}})
