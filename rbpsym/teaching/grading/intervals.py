"""Values of trees at a point, rigorously enclosed: a witness where algebra is too slow or has no rule."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

from rbpsym.algebra.scalar import symbol
from rbpsym.equality import enclosure as e
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.enclosure import Enclosure, Number, Outside
from rbpsym.equality.points import Point, points
from rbpsym.equality.verdict import Verdict, Witness, refuted, undecided
from rbpsym.notation import tree as t
from rbpsym.notation.limits import number_of

MOST_POINTS = 4
LARGEST = 200  # of an argument of exp: beyond, the numbers get long
Numbers = Mapping[str, Fraction]


def differ_at_a_point(left: t.Node, right: t.Node, assumptions: Assumptions) -> Verdict:
    """REFUTED with a point that satisfies the assumptions and at which the sides differ, else UNDECIDED."""
    names = sorted((t.names(left) | t.names(right)) - {"pi"})
    for point in points([symbol(name) for name in names], assumptions, MOST_POINTS) if names else [Point({})]:
        try:
            sides = enclosed(left, point.numbers), enclosed(right, point.numbers)
        except (ArithmeticError, KeyError):
            continue
        if e.are_disjoint(*sides):
            return refuted("the sides differ at a point", Witness(tuple(point.numbers.items()), (), *sides))
    return undecided("neither a proof nor a point at which the sides differ was found")


def enclosed(node: t.Node, numbers: Numbers) -> Number:
    """The value, exact or enclosed. Raises Outside where it has none, KeyError for an unknown name."""
    rule = _RULES.get(type(node))
    if rule is None:
        raise Outside("no rule")
    return _short(rule(node, numbers))


def _short(number: Number) -> Number:
    """Fractions with many digits become enclosures, so that no answer makes numbers grow."""
    if isinstance(number, Fraction) and number.denominator.bit_length() > e.BITS:
        return e.outward(number, number)
    if max(abs(end.numerator).bit_length() for end in e.ends(number)) > 40 * e.BITS:
        raise Outside("too large")
    return number


def _quotient(node: t.Div, numbers: Numbers) -> Number:
    return enclosed(node.num, numbers) * e.reciprocal(enclosed(node.den, numbers))


def _power(node: t.Pow, numbers: Numbers) -> Number:
    base, exponent = enclosed(node.base, numbers), number_of(node.exponent)
    if exponent is None:
        raise Outside("no rule")
    if exponent.denominator == 1:
        raised = reduce(lambda power, _: _short(power * base), range(abs(exponent.numerator)), Fraction(1))
        return raised if exponent >= 0 else e.reciprocal(raised)
    if exponent.denominator == 2:
        return enclosed(t.Pow(t.Sqrt(node.base), t.Num(exponent.numerator)), numbers)
    return e.exp(_bounded(exponent * e.ln(base)))


def _bounded(number: Number) -> Number:
    if any(abs(end) > LARGEST for end in e.ends(number)):
        raise Outside("too large")
    return number


def _magnitude(node: t.Abs, numbers: Numbers) -> Number:
    number = enclosed(node.arg, numbers)
    low, high = e.ends(number)
    if isinstance(number, Fraction):
        return abs(number)
    return Enclosure(Fraction(0) if low < 0 < high else min(abs(low), abs(high)), max(abs(low), abs(high)))


def _function(node: t.Fn, numbers: Numbers) -> Number:
    return FUNCTIONS[node.name](enclosed(node.arg, numbers))


def _over(above: Number, below: Number) -> Number:
    return above * e.reciprocal(below)


FUNCTIONS: Mapping[str, Callable[[Number], Number]] = {
    "sin": lambda x: e.turn_of(x)[1],
    "cos": lambda x: e.turn_of(x)[0],
    "tan": lambda x: _over(*e.turn_of(x)[::-1]),
    "cot": lambda x: _over(*e.turn_of(x)),
    "sec": lambda x: e.reciprocal(e.turn_of(x)[0]),
    "csc": lambda x: e.reciprocal(e.turn_of(x)[1]),
    "exp": lambda x: e.exp(_bounded(x)),
    "ln": e.ln,
    "asin": e.asin,
    "acos": e.acos,
    "atan": e.atan,
}

_RULES: Mapping[type, Callable[[Any, Numbers], Number]] = {
    t.Num: lambda node, numbers: Fraction(node.value),
    t.Sym: lambda node, numbers: e.pi() if node.name == "pi" else numbers[node.name],
    t.Add: lambda node, numbers: reduce(lambda a, b: a + b, (enclosed(term, numbers) for term in node.terms)),
    t.Mul: lambda node, numbers: reduce(lambda a, b: _short(a * b), (enclosed(x, numbers) for x in node.factors)),
    t.Neg: lambda node, numbers: -enclosed(node.arg, numbers),
    t.Group: lambda node, numbers: enclosed(node.arg, numbers),
    t.Sqrt: lambda node, numbers: e.root(enclosed(node.arg, numbers)),
    t.Abs: _magnitude,
    t.Div: _quotient,
    t.Pow: _power,
    t.Fn: _function,
}
