"""How tightly a node binds: the knowledge behind parentheses and signs."""

from __future__ import annotations

from fractions import Fraction as Rational

from rbpsym.notation import tree as t

CHAIN, SUM, CROSS, PRODUCT, APPLIED, POWER, ATOM = range(7)

_LEVELS: dict[type, int] = {
    t.Chain: CHAIN, t.System: CHAIN, t.Add: SUM, t.Neg: SUM, t.Cross: CROSS, t.Dot: CROSS,
    t.Mul: PRODUCT, t.Integral: PRODUCT, t.BodyIntegral: PRODUCT, t.PathIntegral: PRODUCT,
    t.Limit: PRODUCT, t.Sum: PRODUCT, t.Fn: APPLIED, t.Delta: APPLIED, t.Deriv: APPLIED,
    t.Sqrt: POWER, t.Pow: POWER,
}  # fmt: skip
_OPEN = (t.Integral, t.BodyIntegral, t.PathIntegral, t.Limit, t.Sum)


def level(node: t.Node, mode: str = "display") -> int:
    """The binding level of a node as it is printed (fractions bind less in one line)."""
    if isinstance(node, (t.Neg, t.Mul)) or _is_single(node):
        return _signed_level(node, mode)
    if isinstance(node, t.Num):
        return SUM if node.value < 0 else PRODUCT if _slashed(node, mode) else ATOM
    if isinstance(node, t.Div):
        return ATOM if mode == "display" else PRODUCT
    return _LEVELS.get(type(node), ATOM)


def _signed_level(node: t.Node, mode: str) -> int:
    """The level of a term after its signs are gathered: -(-x) is x."""
    negative, body = signed(node)
    if negative:
        return SUM
    return PRODUCT if isinstance(body, t.Mul) else level(body, mode)


def _slashed(node: t.Num, mode: str) -> bool:
    return mode != "display" and plain_fraction(node)


def is_open(node: t.Node) -> bool:
    """Does the node have no visible end, so that a factor after it would slip in?"""
    if isinstance(node, t.Mul) and node.factors:
        return is_open(node.factors[-1])
    return isinstance(node, _OPEN)


def plain_fraction(node: t.Node) -> bool:
    """Is it printed as a fraction: a Div or a positive number that is not whole?"""
    if isinstance(node, t.Num):
        return Rational(node.value).denominator != 1 and not is_decimal(node.value)
    return isinstance(node, (t.Div, t.Deriv))


def is_decimal(value: Rational | int) -> bool:
    """Is it a number that only a measurement has (9.81), which is printed as a decimal?"""
    rest = Rational(value).denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1 and Rational(value).denominator > 20


def signed(node: t.Node) -> tuple[bool, t.Node]:
    """(is it negative, the rest): gathers the signs of Neg, negative numbers, first factors."""
    if isinstance(node, t.Neg):
        negative, body = signed(node.arg)
        return not negative and body != t.ZERO, body
    if isinstance(node, t.Num):
        return node.value < 0, t.Num(abs(node.value))
    if isinstance(node, t.Mul):
        return _signed_product(node)
    return signed(node.terms[0]) if _is_single(node) else (False, node)


def _is_single(node: t.Node) -> bool:
    """Is it a sum of one term, which is printed as that term?"""
    return isinstance(node, t.Add) and len(node.terms) == 1


def _signed_product(node: t.Mul) -> tuple[bool, t.Node]:
    if not node.factors:
        return False, t.ONE
    negative, first = signed(node.factors[0])
    rest = node.factors[1:]
    if rest and first == t.ONE:
        deeper, body = signed(t.Mul(rest))
        return negative != deeper, body
    return negative, t.Mul((first, *rest)) if rest else first


def factors_of(node: t.Mul) -> list[t.Node]:
    """The factors, those of products inside and without ones."""
    bare = [_unsigned(factor) for factor in node.factors]
    flat = [part for f in bare for part in (factors_of(f) if isinstance(f, t.Mul) else [f])]
    kept = [factor for factor in flat if factor != t.ONE]
    return kept or [t.ONE]


def _unsigned(node: t.Node) -> t.Node:
    """The node without a double minus."""
    negative, body = signed(node)
    return t.Neg(body) if negative else body
