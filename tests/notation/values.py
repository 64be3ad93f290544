"""The value of a scalar tree at a point, in complex floating point, by a table of its own."""

import cmath
import math

from rbpsym.notation import tree as t

FUNCTIONS = {
    "sin": cmath.sin, "cos": cmath.cos, "tan": cmath.tan, "asin": cmath.asin, "acos": cmath.acos,
    "atan": cmath.atan, "exp": cmath.exp, "ln": cmath.log,
    "cot": lambda x: 1 / cmath.tan(x), "sec": lambda x: 1 / cmath.cos(x), "csc": lambda x: 1 / cmath.sin(x),
}  # fmt: skip
TABLE = {
    t.Num: lambda n, at: complex(n.value),
    t.Sym: lambda n, at: complex(at(n.name)),
    t.Add: lambda n, at: sum((value(x, at) for x in n.terms), 0j),
    t.Neg: lambda n, at: -value(n.arg, at),
    t.Mul: lambda n, at: math.prod((value(x, at) for x in n.factors), start=1 + 0j),
    t.Div: lambda n, at: value(n.num, at) / value(n.den, at),
    t.Pow: lambda n, at: value(n.base, at) ** value(n.exponent, at),
    t.Sqrt: lambda n, at: cmath.sqrt(value(n.arg, at)),
    t.Fn: lambda n, at: FUNCTIONS[n.name](value(n.arg, at)),
    t.Abs: lambda n, at: abs(value(n.arg, at)),
    t.Group: lambda n, at: value(n.arg, at),
}


def value(node, at):
    """The value of `node`, where `at(name)` is that of a symbol."""
    return TABLE[type(node)](node, at)


def point(name):
    """A number between 0.5 and 2 that depends on the name alone."""
    return 0.5 + sum(ord(c) * (i + 3) for i, c in enumerate(name)) % 149 / 100


def close(left, right):
    """Have two trees the same value (or the same lack of one) at the point?"""
    values = []
    for node in (left, right):
        try:
            values.append(value(node, point))
        except (ZeroDivisionError, OverflowError, ValueError):
            values.append(None)
    if None in values or any(cmath.isnan(v) or cmath.isinf(v) or abs(v) > 1e12 for v in values):
        return True
    return cmath.isclose(*values, rel_tol=1e-6, abs_tol=1e-6)
