"""Values of typed formulas by Python's own parser and mpmath: shares no code with the engine."""

from __future__ import annotations

import ast
import operator
import random
from collections.abc import Mapping

import mpmath
from mpmath import mpf

from rbpsym.equality.verdict import Witness
from tests.equality.table import Row

DIGITS = 60
OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}
FUNCTIONS = {
    **{name: getattr(mpmath, name) for name in "sin cos tan cot sec csc asin acos atan exp ln".split()},
    "log": mpmath.ln,
    "abs": abs,
    "sqrt": mpmath.sqrt,
}
Values = Mapping[str, mpf]


class NoValue(ArithmeticError):
    """The formula has no real value there."""


def evaluate(text: str, values: Values) -> mpf:
    """The value of a formula with explicit products and `**`. Raises NoValue."""
    try:
        with mpmath.workdps(DIGITS):
            found = _value(ast.parse(text, mode="eval").body, {"pi": mpmath.pi() * 1, **values})
    except (ZeroDivisionError, ValueError) as error:
        raise NoValue(text) from error
    if not mpmath.isfinite(found):
        raise NoValue(text)
    return found


def _value(node: ast.expr, values: Values) -> mpf:
    match node:
        case ast.Constant(value=int() as number):
            return mpf(number)
        case ast.Name(id=name):
            return values[name]
        case ast.UnaryOp(op=ast.USub(), operand=arg):
            return -_value(arg, values)
        case ast.BinOp(left=base, op=ast.Pow(), right=exponent):
            return _real(_value(base, values) ** _value(exponent, values))
        case ast.BinOp(left=a, op=op, right=b):
            return OPERATORS[type(op)](_value(a, values), _value(b, values))
        case ast.Call(func=ast.Name(id=name), args=[arg]):
            return _real(FUNCTIONS[name](_value(arg, values)))
    raise ValueError(ast.dump(node))


def _real(number: mpf) -> mpf:
    if isinstance(number, mpmath.mpc):
        raise NoValue(str(number))
    return number


def at_witness(witness: Witness) -> dict[str, mpf]:
    """The values of all names at a witness."""
    with mpmath.workdps(DIGITS):
        values = {name: mpf(x.numerator) / x.denominator for name, x in witness.numbers}
        for text, c, s in witness.points:
            assert c * c + s * s == 1, "not a point of the circle"
            name, _, parts = text.partition("/")
            angle = mpmath.atan2(mpf(s.numerator) / s.denominator, mpf(c.numerator) / c.denominator)
            values[name] = int(parts or 1) * angle
    return values


TESTS = {
    "positive": lambda x: x > 0,
    "nonnegative": lambda x: x >= 0,
    "nonzero": lambda x: x != 0,
    "real": lambda x: True,
}


def satisfies(row: Row, values: Values) -> bool:
    """Whether values fulfil what the row assumes."""
    signs = all(TESTS[sign](values[name]) for name, sign in row.signs if name in values)
    return signs and all(
        (low is None or evaluate(low, values) < values[name]) and (high is None or values[name] < evaluate(high, values))
        for name, low, high in row.ranges
        if name in values
    )


def samples(row: Row, count: int, seed: int = 1) -> list[dict[str, mpf]]:
    """Random values that satisfy the row's conditions and at which both sides exist."""
    source, found = random.Random(seed), []
    for _ in range(4000):
        values = {name: mpf(source.uniform(*source.choice(SPANS))) for name in row.names}
        try:
            _place(row, values, source)
            if satisfies(row, values) and _sides_exist(row, values):
                found.append(values)
        except NoValue:
            continue
        if len(found) == count:
            break
    return found


SPANS = ((0, 1), (0, 4), (-3, 3))


def _place(row: Row, values: dict[str, mpf], source: random.Random) -> None:
    for name, sign in row.signs:
        if name in values and sign in ("positive", "nonnegative"):
            values[name] = abs(values[name])
    for name, low, high in row.ranges:
        a = evaluate(low, values) if low else mpf(-5)
        b = evaluate(high, values) if high else mpf(5)
        values[name] = a + (b - a) * mpf(source.uniform(0.001, 0.999))


def _sides_exist(row: Row, values: Values) -> bool:
    return all(mpmath.isfinite(evaluate(text, values)) for text in (row.left, row.right))


def differ(row: Row, values: Values) -> bool:
    """Whether the sides differ by far more than rounding."""
    left, right = (evaluate(text, values) for text in (row.left, row.right))
    with mpmath.workdps(DIGITS):
        return abs(left - right) > mpf(10) ** -30 * (1 + abs(left) + abs(right))
