"""Numbers for trees, to compare the data of shapes with what textbooks print."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np

from rbpsym.expr import tree
from rbpsym.expr.tree import Node
from rbpsym.statement.model import MassElement

Values = Mapping[str, float]


def value(node: Node, values: Values) -> float:
    """The value of a tree."""
    parts = [value(part, values) for part in tree.children(node)]
    return _RULES[type(node)](node, parts, values)


_RULES: dict[type, Callable] = {
    tree.Num: lambda node, parts, values: float(node.value),
    tree.Sym: lambda node, parts, values: math.pi if node.name == "pi" else values[node.name],
    tree.Add: lambda node, parts, values: sum(parts),
    tree.Neg: lambda node, parts, values: -parts[0],
    tree.Mul: lambda node, parts, values: math.prod(parts),
    tree.Div: lambda node, parts, values: parts[0] / parts[1],
    tree.Pow: lambda node, parts, values: parts[0] ** parts[1],
    tree.Sqrt: lambda node, parts, values: np.sqrt(parts[0]),
    tree.Group: lambda node, parts, values: parts[0],
    tree.Fn: lambda node, parts, values: getattr(np, node.name)(parts[0]),
}

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(14)


def integral(element: MassElement, of: Callable[[float, float], float], values: Values) -> float:
    """∫ of(x, y) dm over a mass element, by Gauss's formula."""
    return element.sign * _over(list(element.ranges), element, of, dict(values))


def _over(ranges: list, element: MassElement, of: Callable, values: dict) -> float:
    if not ranges:
        x, y = value(element.x, values), value(element.y, values)
        return value(element.density, values) * value(element.measure, values) * of(x, y)
    first, *rest = ranges
    lower, upper = value(first.lower, values), value(first.upper, values)
    half, middle = (upper - lower) / 2, (upper + lower) / 2
    return half * sum(
        weight * _over(rest, element, of, {**values, first.variable: middle + half * node})
        for node, weight in zip(_NODES, _WEIGHTS, strict=True)
    )


def moments(elements: tuple[MassElement, ...], values: Values) -> tuple[float, float, float, float]:
    """Mass, centre of mass, and moment of inertia about it."""
    mass, mx, my, second = (
        sum(integral(element, of, values) for element in elements)
        for of in (lambda x, y: 1.0, lambda x, y: x, lambda x, y: y, lambda x, y: x * x + y * y)
    )
    return mass, mx / mass, my / mass, second - (mx * mx + my * my) / mass
