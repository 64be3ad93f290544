"""Values of trees at a point, rigorously enclosed: a witness where algebra is too slow or has no rule."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction

from rbpsym.decide import enclosure as e
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.enclosure import Number
from rbpsym.decide.equal import witness_at
from rbpsym.decide.points import Point, points
from rbpsym.decide.verdict import Verdict, refuted, undecided
from rbpsym.errors import LimitError, ReadError, Undecided
from rbpsym.expr import tree as t
from rbpsym.expr.limits import number_of
from rbpsym.expr.tree import Node
from rbpsym.field import BARE, Meanings, at_most, function, lift, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, field

MOST_POINTS = 4
MOST_DENOMINATOR, CLOSE = 64, Fraction(1, 10**20)  # of a ratio that is told
MOST = 5_000  # products of terms, in the sines and roots that are left at a point


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
                return refuted("the sides differ at a point", witness_at(point, *sides))
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
            self.chosen[names] = list(points([*meant, *turned], self.assumptions, MOST_POINTS)) if names else [Point({})]
        return self.chosen[names]

    def _at(self, node: Node, point: Point) -> Number | None:
        key = (node, id(point))
        if key not in self.known:
            if len(self.known) > 4000:
                self.known.clear()
            self.known[key] = None
            with suppress(ArithmeticError, KeyError, LimitError, ReadError, Undecided):
                self.known[key] = value_at(node, point, self.scope)
        return self.known[key]

def _angles(*nodes: Node) -> list[str]:
    """Names that stand alone in a sine or cosine: their points of the circle are chosen, not their values."""
    calls = (part for node in nodes for part in t.walk(node) if isinstance(part, t.Fn) and part.name in TURNS)
    return sorted({call.arg.name for call in calls if isinstance(call.arg, t.Sym) and call.arg.name != "pi"})


TURNS = ("sin", "cos", "tan", "cot", "sec", "csc")
NOWHERE = Point({})


def value_at(node: Node, point: Point = NOWHERE, scope: Meanings = BARE) -> Number:
    """The value at a point, exact or enclosed. Raises Outside where it has none, KeyError for an unknown name."""
    numbers = {name: lift(number) for name, number in point.numbers.items() if name not in scope.scalars}
    with at_most(MOST):
        return point.value(scalar(with_logarithms(node), scope.with_scalars(numbers)))


def with_logarithms(node: Node) -> Node:
    """The tree with x^(2/3) as exp(2 ln x/3): roots but square ones are decided as exponentials."""
    inner = t.mapped(node, with_logarithms)
    if isinstance(inner, t.Pow) and (exponent := number_of(inner.exponent)) is not None and exponent.denominator > 2:
        return t.Fn("exp", t.Mul((t.Num(exponent), t.Fn("ln", inner.base))))
    return inner
