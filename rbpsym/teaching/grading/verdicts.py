"""Is an answer equal to a key? Decided by `rbpsym.decide`, with a bound on the work, not on the time."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

from rbpsym.decide.domain import Condition, conditions, holds_at
from rbpsym.decide.enclosure import sign_of
from rbpsym.decide.equal import equal, scalars_equal
from rbpsym.decide.points import Point, points
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, undecided
from rbpsym.errors import LimitError, ReadError, Undecided
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node
from rbpsym.field import Scalar, at_most
from rbpsym.field.evaluate import at_start, rate, scalar
from rbpsym.teaching.grading.ground import GradingGround
from rbpsym.teaching.grading.intervals import with_logarithms

OUTSIDE = (LimitError, Undecided, ReadError, ZeroDivisionError)  # what the algebra refuses
LARGEST = 400_000  # that are counted of a key
MOST = 5_000  # products of terms in which an answer must be multiplied out; beside a large key four times as many as that takes


def is_small(node: Node, ground: GradingGround, key: Node | None = None) -> bool:
    """Whether it is soon multiplied out. It is counted, not timed, so that the verdict is the same on every machine."""
    most = MOST if key is None else max(MOST, 4 * _products(key, ground, LARGEST))
    return _products(node, ground, most) <= most


def _products(node: Node, ground: GradingGround, most: int) -> int:
    """How many products it takes; one more than `most` if there are more."""
    with at_most(most) as left:
        try:
            scalar(with_logarithms(node), ground.scope)
        except LimitError:
            return most + 1
        except (Undecided, ReadError, ZeroDivisionError):
            pass  # it has no value, which others tell
        return most - int(left[0])


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
    found = TOO_LARGE
    if is_small(answer, ground, key):
        found = _tried(lambda: equal(with_logarithms(answer), with_logarithms(key), ground.assumptions, ground.scope))
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
    with suppress(*OUTSIDE):
        return sign(scalar(base, ground.scope), ground.assumptions).kind == "positive"
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
    with suppress(ArithmeticError, KeyError):
        return sign_of(point.value(condition.value)) == -1
    return False


def value_of(node: Node, ground: GradingGround) -> Scalar | None:
    """The value of a formula; None where it has none, or is not soon multiplied out."""
    with suppress(*OUTSIDE):
        return scalar(node, ground.scope) if is_small(node, ground) else None
    return None


def divides_by_zero(answer: Node, ground: GradingGround) -> bool:
    """Does the formula divide by what is identically zero? (Not asked of what is too large.)"""
    try:
        with at_most(MOST):
            scalar(answer, ground.scope)
    except ZeroDivisionError:
        return True
    except OUTSIDE:
        pass
    return False
