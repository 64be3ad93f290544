"""Cube roots and the like, made integer powers of new positive symbols: x^(2/3) is u² with x = u³.

Positive factors leave the root one by one. The root of a sum is a symbol u too, of which u³ is that
sum; what is proved with these relations alone holds for the roots. A refutation needs a point.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import lcm

from rbpsym.decide.assumptions import NONE, Assumptions
from rbpsym.decide.equal import cross_difference, scalars_equal
from rbpsym.decide.factoring import primes
from rbpsym.decide.verdict import Verdict, undecided
from rbpsym.expr import tree as t
from rbpsym.expr.limits import number_of
from rbpsym.field import BARE, NOTHING, Meanings, Scalar, atoms, is_zero, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, field

LARGEST_NUMBER = 10**6  # that is split into primes
Power = tuple[t.Node, Fraction]


class Roots(Frozen):
    """The roots in some trees: for each base the common denominator of its exponents, and its symbol."""

    assumptions: Assumptions
    orders: dict[t.Node, int] = field(default_factory=dict)
    names: dict[t.Node, str] = field(default_factory=dict)
    scope: Meanings = BARE
    values: list[tuple[Scalar, t.Node]] = field(default_factory=list)

    def same(self, base: t.Node) -> t.Node:
        """The base noted before that has the same value, or this one."""
        if isinstance(base, (t.Sym, t.Num)):
            return base
        value = scalar(base, self.scope)
        for known, other in self.values:
            if is_zero(cross_difference(known, value)):
                return other
        self.values.append((value, base))
        return base

    def note(self, node: t.Node) -> None:
        """Note the roots of a tree."""
        for part in t.walk(node):
            for found, exponent in _powers(part, self.assumptions):
                base = self.same(found)
                self.orders[base] = lcm(self.orders.get(base, 1), exponent.denominator)
                self.names.setdefault(base, f"root_{len(self.names) + 1}")

    def without(self, node: t.Node) -> t.Node:
        """The tree with roots as powers of the new symbols."""
        found = [(self.same(base), exponent) for base, exponent in _powers(node, self.assumptions)]
        if not found:
            return t.mapped(node, self.without)
        return t.Mul(tuple(t.Pow(t.Sym(self.names[b]), t.Num(n * self.orders[b])) for b, n in found))

    def meanings(self, given: Assumptions) -> dict[str, Scalar]:
        """What the positive symbols under roots are: x = u³."""
        plain = (base for base in self.orders if _is_positive_symbol(base, given))
        return {name: symbol(self.names[base]) ** self.orders[base] for base in plain for name in t.names(base)}

    def reduced(self, value: Scalar, scope: Meanings, given: Assumptions) -> Scalar:
        """A polynomial in which no root stands to its order or more."""
        for base, order in self.orders.items():
            if not _is_positive_symbol(base, given):
                value = _reduced(value, self.names[base], order, scalar(self.without(base), scope))
        return value


def equal_with_roots(answer: t.Node, key: t.Node, assumptions: Assumptions, scope: Meanings) -> Verdict | None:
    """PROVED or UNDECIDED for formulas with cube roots and the like; None for formulas without."""
    if not any(_root_of(part) for side in (answer, key) for part in t.walk(side)):
        return None
    for factors in (assumptions, NONE):  # positive factors taken out, then radicands as they stand
        found = _decided(answer, key, Roots(factors, scope=scope), assumptions)
        if found.is_proved:
            return found
    return undecided("a root of higher order")


def _decided(answer: t.Node, key: t.Node, roots: Roots, assumptions: Assumptions) -> Verdict:
    for side in (answer, key):
        roots.note(side)
    scope = roots.scope.with_scalars(roots.meanings(assumptions))
    given = assumptions.with_signs(dict.fromkeys(roots.names.values(), "positive"))
    gap = cross_difference(*(scalar(roots.without(side), scope) for side in (answer, key)))
    return scalars_equal(roots.reduced(gap, scope, assumptions), NOTHING, given)


def _is_positive_symbol(base: t.Node, given: Assumptions) -> bool:
    return isinstance(base, t.Sym) and given.sign_of(base.name) == "positive"


def _reduced(value: Scalar, name: str, order: int, base: Scalar) -> Scalar:
    parts = value.num.by_power(atoms.intern("symbol", name)).items()
    return sum((Scalar(part) * base ** (k // order) * symbol(name) ** (k % order) for k, part in parts), NOTHING)


def _root_of(node: t.Node) -> Power | None:
    """What is under a root of higher order, and the exponent."""
    exponent = number_of(node.exponent) if isinstance(node, t.Pow) else None
    return (node.base, exponent) if isinstance(node, t.Pow) and exponent is not None and exponent.denominator > 2 else None


def _powers(node: t.Node, given: Assumptions) -> Iterator[Power]:
    """The factors of a root of higher order, each with its exponent; nothing for any other node."""
    if root := _root_of(node):
        yield from _split(*root, given)


def _split(base: t.Node, exponent: Fraction, given: Assumptions) -> Iterator[Power]:
    if isinstance(base, t.Group):
        yield from _split(base.arg, exponent, given)
    elif isinstance(base, t.Num) and 0 < base.value < LARGEST_NUMBER:
        yield from ((t.Num(prime), exponent * count) for prime, count in primes(Fraction(base.value)).items())
    elif isinstance(base, (t.Mul, t.Div, t.Pow, t.Sqrt)) and _is_positive(base, given):
        for part, power in _taken_apart(base, exponent):
            yield from _split(part, power, given)
    else:
        yield base, exponent


def _taken_apart(base: t.Node, exponent: Fraction) -> list[Power]:
    match base:
        case t.Mul(factors=factors):
            return [(factor, exponent) for factor in factors]
        case t.Div(num=num, den=den):
            return [(num, exponent), (den, -exponent)]
        case t.Pow(base=inner, exponent=power):
            return [(inner, exponent * (number_of(power) or 1))]
        case _:
            return [(child, exponent / 2) for child in t.children(base)]  # of a root


def _is_positive(node: t.Node, given: Assumptions) -> bool:
    """Is it made of positive symbols and numbers by products, quotients, powers and sums?"""
    if isinstance(node, t.Sym):
        return node.name == "pi" or given.sign_of(node.name) == "positive"
    if isinstance(node, t.Num):
        return node.value > 0
    if isinstance(node, t.Pow):
        return number_of(node.exponent) is not None and _is_positive(node.base, given)
    made = isinstance(node, (t.Mul, t.Div, t.Add, t.Sqrt, t.Group))
    return made and all(_is_positive(part, given) for part in t.children(node))
