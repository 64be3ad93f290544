"""Values of trees at a point, rigorously enclosed: a witness where algebra is too slow or has no rule."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial, reduce
from operator import add
from typing import Any

from rbpsym.decide import enclosure as e
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.enclosure import Enclosure, Number, Outside
from rbpsym.decide.points import Point, points
from rbpsym.decide.verdict import Verdict, Witness, refuted, undecided
from rbpsym.expr import tree as t
from rbpsym.expr.limits import number_of
from rbpsym.expr.tree import Node
from rbpsym.field import BARE, Meanings, function, symbol
from rbpsym.frozen import Frozen, field

MOST_POINTS = 4
MOST_DENOMINATOR, CLOSE = 64, Fraction(1, 10**20)  # of a ratio that is told
LARGEST = 200  # of an argument of exp: beyond, the numbers get long


class Sampling(Frozen):
    """Points that satisfy the assumptions, by the names that they give values to, and values of trees there.

    Both are kept, since one key is compared with many answers.
    """

    assumptions: Assumptions
    scope: Meanings
    chosen: dict[frozenset[str], list[Point]] = field(default_factory=dict)
    known: dict[tuple[Node, int], Number | None] = field(default_factory=dict)

    def differ(self, left: Node, right: Node, most: int = MOST_POINTS) -> Verdict:
        """REFUTED with a point at which the sides differ, else UNDECIDED."""
        for point in self._points(left, right)[:most]:
            sides = self._both(left, right, point)
            if sides and e.are_disjoint(*sides):
                return refuted("the sides differ at a point", _witness(point, *sides))
        return undecided("neither a proof nor a point at which the sides differ was found")

    def ratio(self, left: Node, right: Node) -> Fraction | None:
        """The ratio of the sides at one point, if it is a short fraction other than 0 and 1."""
        for point in self._points(left, right)[:1]:
            sides = self._both(left, right, point)
            if not sides or not all(e.sign_of(side) for side in sides):
                return None
            low, high = e.ends(sides[0] * e.reciprocal(sides[1]))
            near = Fraction(low).limit_denominator(MOST_DENOMINATOR)
            is_close = max(abs(low - near), abs(high - near)) < CLOSE
            return near if is_close and near not in (0, 1) and abs(near) < MOST_DENOMINATOR else None
        return None

    def are_near(self, left: Node, right: Node, share: Fraction) -> bool:
        """Do the sides differ by at most this share of the right one, at all points?"""
        pairs = [self._both(left, right, point) for point in self._points(left, right)]
        told = [pair for pair in pairs if pair and e.sign_of(pair[1])]
        if not told or len(told) < len(pairs):
            return False
        ratios = [end for one, other in told for end in e.ends(one * e.reciprocal(other))]
        return all(abs(ratio - 1) <= share for ratio in ratios)

    def _both(self, left: Node, right: Node, point: Point) -> tuple[Number, Number] | None:
        """The values of the sides at a point, where both have one."""
        sides = self._at(left, point), self._at(right, point)
        return None if sides[0] is None or sides[1] is None else (sides[0], sides[1])

    def _points(self, left: Node, right: Node) -> list[Point]:
        names = frozenset((t.names(left) | t.names(right)) - {"pi"})
        if names not in self.chosen:
            meant = [self.scope.scalars.get(name, symbol(name)) for name in sorted(names)]
            turned = [function("cos", symbol(name)) for name in _angles(left, right) if name not in self.scope.scalars]
            found = points([*meant, *turned], self.assumptions, MOST_POINTS)
            self.chosen[names] = list(found) if names else [Point({})]
        return self.chosen[names]

    def _at(self, node: Node, point: Point) -> Number | None:
        key = (node, id(point))
        if key not in self.known:
            if len(self.known) > 4000:
                self.known.clear()
            self.known[key] = self._tried(node, point)
        return self.known[key]

    def _tried(self, node: Node, point: Point) -> Number | None:
        try:
            return enclosed(node, point, self.scope)
        except (ArithmeticError, KeyError):
            return None


def _angles(*nodes: Node) -> list[str]:
    """Names that stand alone in a sine or cosine: their points of the circle are chosen, not their values."""
    calls = (part for node in nodes for part in t.walk(node) if isinstance(part, t.Fn) and part.name in TURNS)
    return sorted({call.arg.name for call in calls if isinstance(call.arg, t.Sym) and call.arg.name != "pi"})


def _witness(point: Point, left: Number, right: Number) -> Witness:
    circle = tuple((name, *pair) for name, pair in point.angles.items())
    return Witness(tuple(point.numbers.items()), circle, left, right)


NOWHERE = Point({})


def enclosed(node: Node, point: Point = NOWHERE, scope: Meanings = BARE) -> Number:
    """The value, exact or enclosed. Raises Outside where it has none, KeyError for an unknown name."""
    rule = _RULES.get(type(node))
    if rule is None:
        raise Outside("no rule")
    return _short(rule(node, point, scope))


def _short(number: Number) -> Number:
    """Fractions with many digits become enclosures, so that no answer makes numbers grow."""
    if isinstance(number, Fraction) and number.denominator.bit_length() > e.BITS:
        return e.outward(number, number)
    if max(abs(end.numerator).bit_length() for end in e.ends(number)) > 40 * e.BITS:
        raise Outside("too large")
    return number


def _product(node: t.Mul, point: Point, scope: Meanings) -> Number:
    return reduce(lambda a, b: _short(a * b), (enclosed(factor, point, scope) for factor in node.factors))


def _power(node: t.Pow, point: Point, scope: Meanings) -> Number:
    base, exponent = enclosed(node.base, point, scope), number_of(node.exponent)
    if exponent is None:
        raise Outside("no rule")
    if exponent.denominator == 1:
        raised: Number = Fraction(1)
        for _ in range(abs(exponent.numerator)):
            raised = _short(raised * base)
        return raised if exponent >= 0 else e.reciprocal(raised)
    if exponent.denominator == 2:
        return enclosed(t.Pow(t.Sqrt(node.base), t.Num(exponent.numerator)), point, scope)
    return e.exp(_bounded(exponent * e.ln(base)))


def _bounded(number: Number) -> Number:
    if any(abs(end) > LARGEST for end in e.ends(number)):
        raise Outside("too large")
    return number


def _magnitude(node: t.Abs, point: Point, scope: Meanings) -> Number:
    number = enclosed(node.arg, point, scope)
    low, high = e.ends(number)
    if isinstance(number, Fraction):
        return abs(number)
    return Enclosure(Fraction(0) if low < 0 < high else min(abs(low), abs(high)), max(abs(low), abs(high)))


def _symbol(node: t.Sym, point: Point, scope: Meanings) -> Number:
    if node.name == "pi":
        return e.pi()
    meant = scope.scalars.get(node.name)
    return point.symbol(node.name) if meant is None else point.value(meant)


def _function(node: t.Fn, point: Point, scope: Meanings) -> Number:
    angle = node.arg.name if isinstance(node.arg, t.Sym) else ""
    if point.parts.get(angle) == 1 and node.name in TURNS and angle not in scope.scalars:
        return TURNS[node.name](*point.angles[angle])
    return FUNCTIONS[node.name](enclosed(node.arg, point, scope))


def _over(above: Number, below: Number) -> Number:
    return above * e.reciprocal(below)


def _turned(turn: Callable[[Number, Number], Number], angle: Number) -> Number:
    return turn(*e.turn_of(angle))


TURNS: Mapping[str, Callable[[Number, Number], Number]] = {
    "sin": lambda c, s: s,
    "cos": lambda c, s: c,
    "tan": lambda c, s: _over(s, c),
    "cot": lambda c, s: _over(c, s),
    "sec": lambda c, s: e.reciprocal(c),
    "csc": lambda c, s: e.reciprocal(s),
}
FUNCTIONS: Mapping[str, Callable[[Number], Number]] = {
    **{name: partial(_turned, turn) for name, turn in TURNS.items()},
    "exp": lambda x: e.exp(_bounded(x)),
    "ln": e.ln,
    "asin": e.asin,
    "acos": e.acos,
    "atan": e.atan,
}

_RULES: Mapping[type, Callable[[Any, Point, Meanings], Number]] = {
    t.Num: lambda node, point, scope: Fraction(node.value),
    t.Sym: _symbol,
    t.Add: lambda node, point, scope: reduce(add, (enclosed(term, point, scope) for term in node.terms)),
    t.Mul: _product,
    t.Neg: lambda node, point, scope: -enclosed(node.arg, point, scope),
    t.Group: lambda node, point, scope: enclosed(node.arg, point, scope),
    t.Sqrt: lambda node, point, scope: e.root(enclosed(node.arg, point, scope)),
    t.Abs: _magnitude,
    t.Div: lambda node, point, scope: _over(enclosed(node.num, point, scope), enclosed(node.den, point, scope)),
    t.Pow: _power,
    t.Fn: _function,
}
