"""How many terms a tree would have when multiplied out: the bound that keeps grading quick.

It is counted, not timed, so that the verdict is the same on every machine.
"""

from __future__ import annotations

from collections.abc import Callable
from math import comb
from typing import Any

from rbpsym.notation import tree as t
from rbpsym.notation.limits import number_of

MOST = 450  # terms above and below the fraction bar
MOST_INSIDE = 120  # of what stands under a root or in a function
_CAP = 10**9
Terms = tuple[int, int]


def is_small(node: t.Node, key: t.Node | None = None) -> bool:
    """Whether it can be multiplied out quickly; beside a large key it may be large too."""
    most = MOST if key is None else max(MOST, 4 * max(terms(key)))
    return max(terms(node)) <= most


def terms(node: t.Node) -> Terms:
    """(terms above, terms below the fraction bar), from above; parts of functions count by themselves."""
    rule = _RULES.get(type(node))
    above, below = rule(node) if rule else _apart(node)
    return min(above, _CAP), min(below, _CAP)


def _apart(node: t.Node) -> Terms:
    """A function is one term; what stands in it must be small too."""
    inner = [max(terms(child)) for child in t.children(node)]
    return (1, 1) if max(inner, default=1) <= MOST_INSIDE else (_CAP, 1)


def _sum(node: t.Add) -> Terms:
    above, below = 0, 1
    for n, d in map(terms, node.terms):
        above, below = (above + n, below) if d == 1 else (above * d + n * below, below * d)
    return above, below


def _product(node: t.Mul) -> Terms:
    above = below = 1
    for n, d in map(terms, node.factors):
        above, below = above * n, below * d
    return above, below


def _quotient(node: t.Div) -> Terms:
    (a, b), (c, d) = terms(node.num), terms(node.den)
    return a * d, b * c


def _power(node: t.Pow) -> Terms:
    exponent = number_of(node.exponent)
    if exponent is None:
        return _apart(node)
    (above, below), n = terms(node.base), abs(int(exponent)) or 1
    raised = _multichoose(above, n), _multichoose(below, n)
    return raised if exponent >= 0 else raised[::-1]


def _multichoose(count: int, power: int) -> int:
    return 1 if count == 1 else comb(min(count, 10**4) + power - 1, power) if power <= 64 else _CAP


_RULES: dict[type, Callable[[Any], Terms]] = {
    t.Num: lambda node: (1, 1),
    t.Sym: lambda node: (1, 1),
    t.Add: _sum,
    t.Mul: _product,
    t.Div: _quotient,
    t.Pow: _power,
    t.Neg: lambda node: terms(node.arg),
    t.Group: lambda node: terms(node.arg),
}
