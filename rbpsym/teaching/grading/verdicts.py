"""Is an answer equal to a key? Decided by `rbpsym.decide`, with a bound on the work, not on the time."""

from __future__ import annotations

from collections.abc import Callable
from math import comb
from typing import Any

from rbpsym.decide.domain import Condition, conditions, holds_at
from rbpsym.decide.enclosure import sign_of
from rbpsym.decide.equal import equal, scalars_equal
from rbpsym.decide.points import Point, points
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, undecided
from rbpsym.errors import LimitError, ReadError, Undecided
from rbpsym.expr import tree as t
from rbpsym.expr.limits import number_of
from rbpsym.expr.tree import Node
from rbpsym.field import Scalar
from rbpsym.field.evaluate import at_start, rate, scalar
from rbpsym.teaching.grading.fractional_powers import equal_with_roots
from rbpsym.teaching.grading.ground import GradingGround

# --- how many terms a tree would have when multiplied out: the bound that keeps grading quick
# It is counted, not timed, so that the verdict is the same on every machine.


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


# ---


TOO_LARGE = undecided("the answer is too large to be multiplied out")


def are_equal(answer: Node, key: Node, ground: GradingGround) -> Verdict:
    """PROVED, REFUTED with a witness, or UNDECIDED, wherever both have a value; never by chance or by the clock.

    One point is tried first, since most answers that differ do so there; then algebra; then more points.
    """
    if ground.has_motion and any(isinstance(part, t.Integral) for side in (answer, key) for part in t.walk(side)):
        return _equal_along(answer, key, ground)
    first = ground.sampling.differ(answer, key, most=1)
    if first.is_refuted:
        return first
    is_short = is_small(answer, key)
    found = _by_algebra(answer, key, ground) if is_short else TOO_LARGE
    if found.is_proved and found.open_obligations and has_other_domain(answer, key, ground):
        return undecided("equal where both have a value, but they have one at different places")
    if found.is_proved and _open_powers(answer, ground) != _open_powers(key, ground):
        return undecided("a power with this exponent has a value only where its base is positive")
    if found.is_proved or found.is_refuted:
        return found
    by_point = ground.sampling.differ(answer, key)
    return by_point if by_point.is_refuted else found


def _equal_along(answer: Node, key: Node, ground: GradingGround) -> Verdict:
    """Whether formulas with integrals from the start are equal there, and grow alike on the motion."""
    scope, assumptions = ground.scope, ground.assumptions
    moved = {name: ground.on_motion(scalar(t.Sym(name), scope)) for name in t.names(answer) | t.names(key)}
    on_motion = scope.with_scalars({**scope.scalars, **moved})

    def both(of: Callable[[Node], Scalar]) -> tuple[Scalar, Scalar]:
        return of(answer), of(key)

    def decided() -> Verdict:
        grown = scalars_equal(*both(lambda side: ground.along(rate(side, on_motion))), assumptions)
        if not grown.is_proved:
            return grown
        return scalars_equal(*both(lambda side: at_start(ground.on_motion(scalar(side, scope)), scope)), assumptions)

    return _tried(decided)


def _by_algebra(answer: Node, key: Node, ground: GradingGround) -> Verdict:
    sides = answer, key, ground.assumptions, ground.scope
    return _tried(lambda: equal_with_roots(*sides) or equal(*sides))


def _tried(decide: Callable[[], Verdict]) -> Verdict:
    """UNDECIDED with the reason, where the algebra refuses."""
    try:
        return decide()
    except (ReadError, LimitError, Undecided) as error:
        return undecided(error.what)
    except ZeroDivisionError:
        return undecided("a denominator is identically zero")


def _open_powers(node: Node, ground: GradingGround) -> set[Node]:
    """The powers x^a, read as exp(a ln x), whose base may be negative: (x^2)^a is then not x^(2a)."""
    calls = (part.arg for part in t.walk(node) if isinstance(part, t.Fn) and part.name == "exp")
    raised = [(part, part.factors[-1]) for part in calls if isinstance(part, t.Mul)]
    logs = [(part, last.arg) for part, last in raised if isinstance(last, t.Fn) and last.name == "ln"]
    return {part for part, base in logs if not _is_positive(base, ground)}


def _is_positive(base: Node, ground: GradingGround) -> bool:
    try:
        return sign(scalar(base, ground.scope), ground.assumptions).kind == "positive"
    except (ReadError, LimitError, Undecided, ZeroDivisionError):
        return False


SIGNED = (">=", ">")
POINTS = 12


def has_other_domain(answer: Node, key: Node, ground: GradingGround) -> bool:
    """Is there a point where, for the sign of a radicand or of the argument of a logarithm, only one of them has a value?"""
    sides = [[c for c in conditions(side, ground.scope) if c.op in SIGNED] for side in (answer, key)]
    if {(c.op, c.value) for c in sides[0]} == {(c.op, c.value) for c in sides[1]}:
        return False
    for point in points([c.value for side in sides for c in side], ground.assumptions, POINTS):
        met = [all(holds_at(c, point) for c in side) for side in sides]
        broken = [any(_is_broken(c, point) for c in side) for side in sides]
        if (met[0] and broken[1]) or (met[1] and broken[0]):
            return True
    return False


def _is_broken(condition: Condition, point: Point) -> bool:
    """Does the condition surely not hold?"""
    try:
        return sign_of(point.value(condition.value)) == -1
    except (ArithmeticError, KeyError):
        return False


def divides_by_zero(answer: Node, ground: GradingGround) -> bool:
    """Does the formula divide by what is identically zero? (Not asked of what is too large.)"""
    if not is_small(answer):
        return False
    try:
        scalar(answer, ground.scope)
    except ZeroDivisionError:
        return True
    except (LimitError, Undecided, ReadError):
        pass
    return False
