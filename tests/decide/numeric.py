"""An independent road: formulas and witnesses computed with mpmath in fifty digits."""

from __future__ import annotations

import ast
import operator
import random
import re
from collections.abc import Callable, Mapping

import mpmath

from rbpsym.decide.verdict import Witness
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node

mpmath.mp.dps = 50
Point = Mapping[str, mpmath.mpf]
NAMES = {"ln": "log"}


class NoValue(Exception):
    """The formula has no real value at the point."""


def number(tree: Node, at: Point) -> mpmath.mpf:
    """The value of a tree. Raises NoValue."""
    try:
        found = mpmath.mpmathify(VALUES[type(tree)](tree, at))
    except (ZeroDivisionError, ValueError):
        raise NoValue from None
    if isinstance(found, mpmath.mpc) or not mpmath.isfinite(found):
        raise NoValue
    return found


def _power(node: t.Pow, at: Point) -> mpmath.mpf:
    exponent = number(node.exponent, at)
    return number(node.base, at) ** (int(exponent) if exponent == int(exponent) else exponent)


VALUES = {
    t.Num: lambda n, at: mpmath.mpf(n.value.numerator) / n.value.denominator,
    t.Sym: lambda n, at: mpmath.pi if n.name == "pi" else at.get(n.name, mpmath.mpf(1)),
    t.Add: lambda n, at: mpmath.fsum(number(x, at) for x in n.terms),
    t.Neg: lambda n, at: -number(n.arg, at),
    t.Mul: lambda n, at: mpmath.fprod(number(x, at) for x in n.factors),
    t.Div: lambda n, at: number(n.num, at) / number(n.den, at),
    t.Pow: _power,
    t.Sqrt: lambda n, at: mpmath.sqrt(number(n.arg, at)),
    t.Fn: lambda n, at: getattr(mpmath, NAMES.get(n.name, n.name))(number(n.arg, at)),
    t.Abs: lambda n, at: abs(number(n.arg, at)),
    t.Group: lambda n, at: number(n.arg, at),
}


def at_witness(witness: Witness) -> dict[str, mpmath.mpf]:
    """The point of a witness."""
    point = {name: mpmath.mpf(v.numerator) / v.denominator for name, v in witness.numbers}
    for label, c, s in witness.points:
        name, _, parts = label.partition("/")
        assert c * c + s * s == 1
        point[name] = mpmath.atan2(mpmath.mpf(s.numerator) / s.denominator, mpmath.mpf(c.numerator) / c.denominator)
        point[name] *= int(parts or 1)
    return point


def typed(text: str, at: Point) -> mpmath.mpf:
    """The value of a typed formula by Python's own grammar: shares no code with our reader. Raises NoValue."""
    try:
        found = mpmath.mpmathify(_python(ast.parse(text.strip(), mode="eval").body, at))
    except (ZeroDivisionError, ValueError):
        raise NoValue from None
    if isinstance(found, mpmath.mpc) or not mpmath.isfinite(found):
        raise NoValue
    return found


def _python(node: ast.expr, at: Point) -> mpmath.mpf:
    match node:
        case ast.Constant(value=int() as whole):
            return mpmath.mpf(whole)
        case ast.Name(id=name):
            return mpmath.mpf(mpmath.pi) if name == "pi" else at[name]
        case ast.UnaryOp(op=ast.USub(), operand=arg):
            return -_python(arg, at)
        case ast.BinOp(left=left, op=op, right=right):
            return _real(OPERATORS[type(op)](_python(left, at), _python(right, at)))
        case ast.Call(func=ast.Name(id=name), args=[arg]):
            return _real(abs(_python(arg, at)) if name == "abs" else _function(name)(_python(arg, at)))
    raise TypeError(ast.dump(node))


def _function(name: str) -> Callable[[mpmath.mpf], mpmath.mpf]:
    return getattr(mpmath, NAMES.get(name, name))


def _real(found: mpmath.mpf) -> mpmath.mpf:
    if isinstance(found, mpmath.mpc):
        raise NoValue
    return found


OPERATORS = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}


def fulfils(text: str, names: list[str], point: Point) -> bool:
    """Whether a point fulfils the assumptions of a row, read from the text anew."""
    ranged = re.findall(r"<\s*([a-z_0-9]+)\s*<", text)
    for item in filter(None, map(str.strip, text.split(";"))):
        word, *rest = item.split()
        if word in SIGNS:
            if not all(SIGNS[word](point[n]) for n in (rest or names) if n not in ranged):
                return False
        elif not _inside(item, point):
            return False
    return True


SIGNS = {"positive": lambda x: x > 0, "nonnegative": lambda x: x >= 0, "nonzero": lambda x: x != 0}


def _ends(item: str, point: Point) -> tuple[str, mpmath.mpf | None, mpmath.mpf | None]:
    """The name that has a range, and its bounds (None: no bound)."""
    lower, name, upper = (part.strip() for part in f" {item} ".split("<"))
    return name, typed(lower, point) if lower else None, typed(upper, point) if upper else None


def _inside(item: str, point: Point) -> bool:
    name, lower, upper = _ends(item, point)
    return (lower is None or lower < point[name]) and (upper is None or point[name] < upper)


def some_points(text: str, names: list[str], count: int, seed: int) -> list[dict[str, mpmath.mpf]]:
    """Random points that fulfil the assumptions."""
    source, found = random.Random(seed), []
    for _ in range(400 * count):
        point = {name: mpmath.mpf(source.uniform(-4, 4)) for name in names}
        if "positive" in text and source.random() < 0.9:
            point = {name: abs(x) for name, x in point.items()}
        for item in filter(lambda part: part.count("<") == 2, text.split(";")):
            name, lower, upper = _ends(item, point)
            lower, upper = (-4 if lower is None else lower), (4 if upper is None else upper)
            point[name] = lower + (upper - lower) * source.random()
        if fulfils(text, names, point):
            found.append(point)
        if len(found) == count:
            break
    return found
