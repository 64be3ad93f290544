"""The sign of a formula where it is plain from its form, to refuse a negative length or mass."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from rbpsym.notation import tree
from rbpsym.notation.tree import Node

Signs = Mapping[str, str]

# 3.14159265358979323846264338327950288 < pi < ...289
_PI = Fraction(314159265358979323846264338327950288, 10**35), Fraction(314159265358979323846264338327950289, 10**35)


def sign_of(node: Node, signs: Signs) -> int | None:
    """1, 0 or -1, or None if the form does not tell."""
    number = multiple_of_pi(node)
    if number is not None:
        return _sign_of_number(*number)
    rule = _RULES.get(type(node))
    return rule(node, signs) if rule else None


def multiple_of_pi(node: Node) -> tuple[Fraction, Fraction] | None:
    """(a, b) if the node is the number a + b pi."""
    if isinstance(node, tree.Num):
        return Fraction(node.value), Fraction(0)
    if isinstance(node, tree.Sym):
        return (Fraction(0), Fraction(1)) if node.name == "pi" else None
    rule = _LINEAR.get(type(node))
    if rule is None:
        return None
    parts = [multiple_of_pi(part) for part in tree.children(node)]
    return None if None in parts else rule(parts)


def compare_numbers(left: Node, right: Node) -> int | None:
    """The sign of left - right if both are rational multiples of 1 and pi, else None."""
    a, b = multiple_of_pi(left), multiple_of_pi(right)
    if a is None or b is None:
        return None
    return _sign_of_number(a[0] - b[0], a[1] - b[1])


def _sign_of_number(a: Fraction, b: Fraction) -> int | None:
    """The sign of a + b pi, exactly; None in the unheard-of case that 35 digits don't tell."""
    low, high = sorted(a + b * bound for bound in _PI)
    if low == high == 0:
        return 0
    return 1 if low > 0 else -1 if high < 0 else None


def _product_of_pi(parts: list) -> tuple[Fraction, Fraction] | None:
    a, b = Fraction(1), Fraction(0)
    for c, d in parts:
        if b and d:
            return None
        a, b = a * c, a * d + b * c
    return a, b


def _quotient_of_pi(parts: list) -> tuple[Fraction, Fraction] | None:
    (a, b), (c, d) = parts
    return None if d or not c else (a / c, b / c)


_LINEAR = {
    tree.Add: lambda parts: (sum(a for a, _ in parts), sum(b for _, b in parts)),
    tree.Neg: lambda parts: (-parts[0][0], -parts[0][1]),
    tree.Group: lambda parts: parts[0],
    tree.Mul: _product_of_pi,
    tree.Div: _quotient_of_pi,
}


def _product(factors: tuple[Node, ...], signs: Signs) -> int | None:
    found = [sign_of(factor, signs) for factor in factors]
    if 0 in found:
        return 0
    if None in found:
        return None
    return -1 if found.count(-1) % 2 else 1


def _sum(node: tree.Add, signs: Signs) -> int | None:
    found = {sign_of(term, signs) for term in node.terms} - {0}
    return found.pop() if len(found) == 1 else None if found else 0


def _negative(node: tree.Neg, signs: Signs) -> int | None:
    found = sign_of(node.arg, signs)
    return None if found is None else -found


def _power(node: tree.Pow, signs: Signs) -> int | None:
    return 1 if sign_of(node.base, signs) == 1 else None


_RULES = {
    tree.Sym: lambda node, signs: 1 if signs.get(node.name) == "positive" else None,
    tree.Neg: _negative,
    tree.Add: _sum,
    tree.Mul: lambda node, signs: _product(node.factors, signs),
    tree.Div: lambda node, signs: _product((node.num, node.den), signs),
    tree.Pow: _power,
    tree.Sqrt: lambda node, signs: sign_of(node.arg, signs),
    tree.Group: lambda node, signs: sign_of(node.arg, signs),
}
