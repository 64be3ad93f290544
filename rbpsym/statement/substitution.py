"""Names replaced by formulas in a tree, with the numbers of fractions put together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from rbpsym.notation import tree
from rbpsym.notation.tree import Node, Num, add, div, mul, neg


def put_in(node: Node, values: Mapping[str, Node]) -> Node:
    """The tree with each symbol of `values` replaced; sums, products and fractions tidied."""
    if isinstance(node, tree.Sym):
        return values.get(node.name, node)
    found = replace(tree.mapped(node, lambda part: put_in(part, values)), span=None)
    rule = _TIDY.get(type(node))
    return rule(found) if rule else found


def quotient(num: Node, den: Node) -> Node:
    """num / den, where numbers cancel: 2 ell / 2 is ell, M / (M) stays."""
    if isinstance(num, tree.Neg):
        return neg(quotient(num.arg, den))
    (a, top), (b, bottom) = _split(num), _split(den)
    number = a / b
    return div(mul(Num(number.numerator), top), mul(Num(number.denominator), bottom))


def _split(node: Node) -> tuple[Fraction, Node]:
    """A number and the rest of a product."""
    if isinstance(node, Num) and node.value:
        return Fraction(node.value), tree.ONE
    if isinstance(node, tree.Mul) and isinstance(node.factors[0], Num):
        return Fraction(node.factors[0].value), mul(*node.factors[1:])
    return Fraction(1), node


def _power(node: tree.Pow) -> Node:
    plain = isinstance(node.exponent, Num) and node.exponent.value in (0, 1)
    return tree.power(node.base, node.exponent.value) if plain else node


_TIDY = {
    tree.Add: lambda node: add(*node.terms),
    tree.Neg: lambda node: neg(node.arg),
    tree.Mul: lambda node: mul(*node.factors),
    tree.Div: lambda node: quotient(node.num, node.den),
    tree.Group: lambda node: node.arg,
    tree.Pow: _power,
}
