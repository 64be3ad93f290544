"""Where a formula has a value: denominators are not zero, radicands not negative, and so on.

`conditions` reads them from the tree, before anything cancels; `obligations` says which of
them the assumptions imply.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import Any

from rbpsym.decide import enclosure
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.dimensions import Dimensions, dimension_of
from rbpsym.decide.factoring import split
from rbpsym.decide.points import Point, points
from rbpsym.decide.signs import SignResult, sign
from rbpsym.decide.verdict import Obligation, Witness
from rbpsym.errors import DimensionError, LimitError, Undecided
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node
from rbpsym.field import ONE, Meanings, Scalar, depends_on, function, generator, inverse, is_zero, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, replace


class Condition(Frozen):
    """`node` (of the given value) op 0, op being "!=", ">=" or ">"; `between`: for all values of a name between two others."""

    node: Node
    op: str
    value: Scalar
    between: tuple[str, Scalar, Scalar] | None = None

    @property
    def relation(self) -> Node:
        """The condition as a formula."""
        return t.relation(self.node, self.op, t.ZERO)


IMPLIED: dict[str, Callable[[SignResult], bool]] = {
    "!=": lambda found: found.is_nonzero,
    ">=": lambda found: found.is_nonnegative,
    ">": lambda found: found.kind == "positive",
}
HOLDS: dict[str, Callable[[int | None], bool]] = {
    "!=": lambda sign: sign in (1, -1),
    ">=": lambda sign: sign in (0, 1),
    ">": lambda sign: sign == 1,
}


def conditions(node: Node, scope: Meanings) -> list[Condition]:
    """All conditions of a formula, without repetition and without those on plain numbers that hold."""
    found = dict.fromkeys(_conditions(node, scope))
    for condition in found:
        if condition.op == "!=" and is_zero(condition.value):
            raise Undecided("a denominator is identically zero")
    return [condition for condition in found if condition.value.number() is None or not holds_at(condition, Point({}))]


def holds_at(condition: Condition, point: Point) -> bool:
    """Whether the condition surely holds at a point."""
    try:
        return HOLDS[condition.op](enclosure.sign_of(point.value(condition.value)))
    except (enclosure.Outside, KeyError):
        return False


def divisors(value: Scalar) -> list[Scalar]:
    """What stands below the line: each generator, and what is no product."""
    below = {index for m in value.num.terms for index, exponent in m if exponent < 0}
    rest = value.den.content()[1] if value.den is not ONE else ()
    found = [Scalar(generator(index)) for index in sorted(below | {index for index, _ in rest})]
    return found + ([Scalar(value.den.scaled(1, inverse(rest)))] if value.den is not ONE else [])


def obligations(found: Iterable[Condition], assumptions: Assumptions) -> list[Obligation]:
    """The conditions with what discharges them."""
    return [Obligation(item.relation, _why(item, assumptions)) for item in found]


def _why(condition: Condition, assumptions: Assumptions) -> str:
    if condition.op == ">=" and _is_plainly_nonnegative(condition.node, assumptions):
        return "a sum of squares and of what is not negative"
    if condition.op != ">=" and _is_plainly_positive(condition.node, assumptions):
        return "a sum of squares and of what is positive"
    for given in _spans(condition, assumptions):
        result = sign(condition.value, given, factoring=False)
        if IMPLIED[condition.op](result):
            return result.certificate or "by assumption"
    return ""


def _spans(condition: Condition, assumptions: Assumptions) -> Iterator[Assumptions]:
    """The assumptions, with the range between the ends of an integral from the lower to the upper one, if that is known."""
    if condition.between is None:
        yield assumptions
        return
    name, lower, upper = condition.between
    for low, high in ((lower, upper), (upper, lower)):
        if sign(high - low, assumptions, factoring=False).is_nonnegative:
            yield assumptions.with_range(name, low, high)
            return


def _is_plainly_nonnegative(node: Node, assumptions: Assumptions) -> bool:
    rule = PLAINLY.get(type(node))
    return rule is not None and rule(node, assumptions)


def _is_plainly_positive(node: Node, assumptions: Assumptions) -> bool:
    """A sum of what is not negative, of which one term is a positive number or quantity."""
    terms = node.terms if isinstance(node, t.Add) else ()
    firm = (
        (isinstance(x, t.Num) and x.value > 0) or (isinstance(x, t.Sym) and assumptions.sign_of(x.name) == "positive")
        for x in terms
    )
    return any(firm) and _all_plainly(node, assumptions)


def _all_plainly(node: Node, assumptions: Assumptions) -> bool:
    return all(_is_plainly_nonnegative(child, assumptions) for child in t.children(node))


def _is_even(node: Node) -> bool:
    return isinstance(node, t.Num) and node.value.denominator == 1 and node.value % 2 == 0


PLAINLY: dict[type, Callable[[Any, Assumptions], bool]] = {
    t.Num: lambda node, given: node.value >= 0,
    t.Sym: lambda node, given: node.name == "pi" or given.sign_of(node.name) in ("positive", "nonnegative"),
    t.Pow: lambda node, given: _is_even(node.exponent) or _is_plainly_nonnegative(node.base, given),
    t.Sqrt: lambda node, given: True,
    t.Abs: lambda node, given: True,
    **dict.fromkeys((t.Add, t.Mul, t.Div, t.Group), _all_plainly),
}


def _conditions(node: Node, scope: Meanings) -> Iterator[Condition]:
    rule = RULES.get(type(node))
    if rule is not None:
        yield from rule(node, scope)
    special = INSIDE.get(type(node))
    if special is not None:
        yield from special(node, scope)
        return
    for child in t.children(node):
        yield from _conditions(child, scope)


def _condition(node: Node, op: str, scope: Meanings) -> Condition:
    return Condition(node, op, scalar(node, scope))


def _bare(node: Node) -> Node:
    """A product without the positive numbers in it, which do not change its sign."""
    if not isinstance(node, t.Mul):
        return node
    kept = tuple(factor for factor in node.factors if not (isinstance(factor, t.Num) and factor.value > 0))
    return kept[0] if len(kept) == 1 else replace(node, factors=kept) if kept else node


def nonzero(node: Node, scope: Meanings) -> Iterator[Condition]:
    """A product or power is not zero where none of its factors is; a number is none."""
    factored = FACTORS.get(type(node))
    factors = factored(node) if factored else (node,)
    if factors == (node,):
        yield _condition(node, "!=", scope)
        return
    for factor in factors:
        yield from nonzero(factor, scope)


def _base(node: t.Pow) -> tuple[Node, ...]:
    """What must not vanish for a power not to."""
    return (node.base,) if isinstance(node.exponent, t.Num) and node.exponent.value > 0 else (node,)


FACTORS: dict[type, Callable[[Any], tuple[Node, ...]]] = {
    t.Mul: lambda node: node.factors,
    t.Div: lambda node: (node.num,),
    t.Pow: _base,
    t.Sqrt: lambda node: (node.arg,),
    t.Neg: lambda node: (node.arg,),
    t.Group: lambda node: (node.arg,),
    t.Num: lambda node: () if node.value else (node,),
}


def _of_power(node: t.Pow, scope: Meanings) -> Iterator[Condition]:
    exponent = scalar(node.exponent, scope).number()
    if exponent is not None and exponent < 0:
        yield from nonzero(node.base, scope)
    if exponent is not None and exponent.denominator != 1:
        yield _condition(node.base, ">=", scope)


def _of_function(node: t.Fn, scope: Meanings) -> Iterator[Condition]:
    kind, op = FUNCTIONS.get(node.name, (None, ""))
    if kind == "arg":
        yield _condition(node.arg, op, scope)
    elif kind == "rest":
        yield _condition(t.Add((t.ONE, t.Neg(node.arg))), op, scope)
    elif kind == "square":
        yield _condition(t.Add((t.ONE, t.Neg(t.Pow(node.arg, t.TWO)))), op, scope)
    elif kind is not None:
        yield Condition(t.Fn(kind, node.arg), op, function(kind, scalar(node.arg, scope)))


FUNCTIONS = {
    "tan": ("cos", "!="),
    "sec": ("cos", "!="),
    "cot": ("sin", "!="),
    "csc": ("sin", "!="),
    "ln": ("arg", ">"),
    "asin": ("square", ">="),
    "acos": ("square", ">="),
    "elliptic_k": ("rest", ">"),
    "elliptic_e": ("rest", ">="),
}

RULES: dict[type, Callable[[Any, Meanings], Iterator[Condition]]] = {
    t.Div: lambda node, scope: nonzero(node.den, scope),
    t.Pow: _of_power,
    t.Sqrt: lambda node, scope: iter([_condition(_bare(node.arg), ">=", scope)]),
    t.Fn: _of_function,
}


def _within(node: t.Integral, scope: Meanings) -> Iterator[Condition]:
    """The ends; the integrand between them, and at them. A gap that can be filled, as of θ²/θ, is none."""
    filled = not any(depends_on(below, node.var) for below in divisors(scalar(node.integrand, scope)))
    for end in (node.lower, node.upper):
        yield from _conditions(end, scope)
        moved = _moved(node.integrand, node.var, scalar(end, scope), scope)
        yield from (one for one in moved if not (filled and one.op == "!="))
    ends = scalar(node.lower, scope), scalar(node.upper, scope)
    for condition in _conditions(node.integrand, scope):
        if filled and condition.op == "!=" and depends_on(condition.value, node.var):
            continue
        between = (node.var, *ends) if depends_on(condition.value, node.var) else condition.between
        yield replace(condition, between=between)


def _at_ends(node: t.Bracket, scope: Meanings) -> Iterator[Condition]:
    for end in (node.lower, node.upper):
        yield from _conditions(end, scope)
        yield from _moved(node.arg, node.var, scalar(end, scope), scope)


def _moved(node: Node, name: str, to: Scalar, scope: Meanings) -> Iterator[Condition]:
    for condition in _conditions(node, scope):
        if depends_on(condition.value, name):
            image = substitute(condition.value, {name: to})
            shown = t.At(condition.node, t.equation(t.Sym(name), t.Sym("…")))
            yield Condition(shown, condition.op, image)
        else:
            yield condition


def _then_and_now(node: t.Delta, scope: Meanings) -> Iterator[Condition]:
    for condition in _conditions(node.arg, scope):
        yield condition
        image = substitute(condition.value, scope.start)
        if image != condition.value:
            yield Condition(t.At(condition.node, t.Word("start")), condition.op, image)


def _near(node: t.Limit, scope: Meanings) -> Iterator[Condition]:
    """Conditions away from the limit: what vanishes only at the limit itself does not matter."""
    yield from _conditions(node.to, scope)
    for condition in _conditions(node.arg, scope):
        if not depends_on(condition.value, node.var):
            yield condition


INSIDE: dict[type, Callable[[Any, Meanings], Iterator[Condition]]] = {
    t.Bracket: _at_ends,
    t.Integral: _within,
    t.Delta: _then_and_now,
    t.Limit: _near,
    t.BodyIntegral: lambda node, scope: iter(()),
    t.PathIntegral: lambda node, scope: iter(()),
}


# --- integrals through poles: a factor below the line that changes its sign between the ends vanishes there; and the
# degree of what is homogeneous.


PLACES = 36  # into so many parts the interval is cut
MOST_POINTS = 3  # of the quantities that the ends and the factor hold


def pole(conditions: Iterable[Condition], assumptions: Assumptions) -> Witness | None:
    """A point at which an integrand has a pole within its interval (its sides: what it is divided by, before and behind)."""
    for condition in conditions:
        if condition.between is not None and condition.op == "!=":
            for factor in _factors(condition.value, condition.between[0]):
                if (found := _crossed(factor, condition.between, assumptions)) is not None:
                    return found
    return None


def _factors(value: Scalar, name: str) -> Iterator[Scalar]:
    """What the value is a product of, as far as the variable stands in it."""
    _, monomial = value.num.content()
    for index, _ in monomial:
        if depends_on(Scalar(generator(index)), name):
            yield Scalar(generator(index))
    rest = value.num.scaled(1, tuple((index, -exponent) for index, exponent in monomial))
    try:
        yield from (Scalar(factor) for factor, _ in split(rest, deep=True)[1] if depends_on(Scalar(factor), name))
    except LimitError:
        yield Scalar(rest)


def _crossed(factor: Scalar, between: tuple[str, Scalar, Scalar], assumptions: Assumptions) -> Witness | None:
    name, lower, upper = between
    steps = [lower + (upper - lower) * Fraction(k, PLACES) for k in range(PLACES + 1)]
    values = [substitute(factor, {name: place}) for place in steps]
    for point in points(values, assumptions.without(name), MOST_POINTS):
        seen: dict[int, Scalar] = {}
        for value in values:
            sign = _sign(point, value)
            if sign and -sign in seen:
                sides, of = (point.value(seen[-sign]), point.value(value)), "what is below the line, on both sides of a pole"
                return Witness(tuple(point.numbers.items()), (), *sides, of)
            seen.setdefault(sign, value)
    return None


def _sign(point: Point, value: Scalar) -> int:
    try:
        return enclosure.sign_of(point.value(value)) or 0
    except enclosure.Outside:
        return 0


CHECKED = (t.Chain, t.Add, t.Fn, t.Pow)


def faults(node: t.Node, dimensions: Dimensions) -> int:
    """The number of sums, relations, functions and powers in which something does not fit (0: it is homogeneous).

    A formula with a name of unknown dimension is judged by its other parts.
    """
    return sum(_is_faulty(part, dimensions) for part in t.walk(node) if isinstance(part, CHECKED))


def _is_faulty(node: t.Node, dimensions: Dimensions) -> bool:
    if not all(name == "pi" or name in dimensions for name in t.names(node)):
        return False
    try:
        dimension_of(node, dimensions)
    except DimensionError:
        return True
    return False
