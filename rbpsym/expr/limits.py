"""Bounds on trees that come from outside: depth, number of nodes, exponents, degree."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction as Rational
from typing import Any

from rbpsym.errors import LimitError
from rbpsym.expr import tree as t

MAX_DEPTH, MAX_NODES, MAX_EXPONENT, MAX_DEGREE = 60, 2000, 64, 512


def check_size(node: Any, parts: Callable[[Any], Iterable[Any]] = t.children) -> None:
    """Raise LimitError if the tree is too deep or has too many nodes (of another kind of tree: with what its `parts` are)."""
    count, layer = 0, [node]
    for _ in range(MAX_DEPTH + 1):
        count += len(layer)
        layer = [child for part in layer for child in parts(part)]
        if count + len(layer) > MAX_NODES:
            raise LimitError(f"the expression has more than {MAX_NODES} parts")
    if layer:
        raise LimitError(f"the expression is nested deeper than {MAX_DEPTH} levels")


def check_exponent(exponent: t.Node) -> None:
    """Raise LimitError for a number beyond the bound, or a number written as a power."""
    if t.names(exponent):
        return
    value = number_of(exponent)
    if value is None:
        raise LimitError("an exponent must be a plain number or contain a symbol")
    if value.denominator > MAX_EXPONENT and abs(value) <= MAX_EXPONENT:
        what = f"the exponent {float(value):g} is not a simple fraction"
        raise LimitError(what, instead=f"Write it as a fraction with at most {MAX_EXPONENT} below, as in x^(1/3).")
    if abs(value) > MAX_EXPONENT:
        raise LimitError(f"the exponent {value} is beyond {MAX_EXPONENT}")


def number_of(node: t.Node) -> Rational | None:
    """The value of a number, with its sign and slash; None for anything else."""
    if isinstance(node, t.Num):
        return Rational(node.value)
    if isinstance(node, (t.Neg, t.Group)):
        value = number_of(node.arg)
        return -value if value is not None and isinstance(node, t.Neg) else value
    if isinstance(node, t.Div):
        num, den = number_of(node.num), number_of(node.den)
        return num / den if num is not None and den else None
    return None


def check_degree(node: t.Node) -> None:
    """Raise LimitError if powers of powers make the tree grow beyond the bound."""
    if _degree(node) > MAX_DEGREE:
        raise LimitError(f"powers of powers in the expression reach beyond degree {MAX_DEGREE}")


def _degree(node: t.Node) -> int:
    degrees = [_degree(part) for part in t.children(node)] or [1]
    if isinstance(node, t.Pow):
        value = number_of(node.exponent)
        return degrees[0] * max(1, -(-abs(value) // 1)) if value is not None else max(degrees)
    return sum(degrees) if isinstance(node, (t.Mul, t.Div)) else max(degrees)
