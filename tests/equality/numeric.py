"""An independent road: trees and witnesses computed with mpmath in fifty digits."""

from __future__ import annotations

import random
import re
from collections.abc import Mapping

import mpmath

from rbpsym.equality.verdict import Witness
from rbpsym.notation import tree as t
from rbpsym.notation.tree import Node

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


def _inside(item: str, point: Point) -> bool:
    lower, name, upper = (part.strip() for part in f" {item} ".split("<"))
    ends = [float(mpmath.mpmathify(_bound(part))) if part else None for part in (lower, upper)]
    return (ends[0] is None or ends[0] < point[name]) and (ends[1] is None or point[name] < ends[1])


def _bound(part: str) -> mpmath.mpf:
    return BOUNDS[part] if part in BOUNDS else mpmath.mpf(part)


BOUNDS = {"pi": mpmath.pi, "pi/2": mpmath.pi / 2, "-pi/2": -mpmath.pi / 2}


def some_points(text: str, names: list[str], count: int, seed: int) -> list[dict[str, mpmath.mpf]]:
    """Random points that fulfil the assumptions."""
    source, found = random.Random(seed), []
    for _ in range(400 * count):
        point = {name: mpmath.mpf(source.uniform(-4, 4)) for name in names}
        if "positive" in text and source.random() < 0.9:
            point = {name: abs(x) for name, x in point.items()}
        if fulfils(text, names, point):
            found.append(point)
        if len(found) == count:
            break
    return found
