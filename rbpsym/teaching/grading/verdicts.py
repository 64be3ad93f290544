"""Is an answer equal to a key? Decided by `rbpsym.equality`, with a bound on the work, not on the time."""

from __future__ import annotations

from rbpsym.algebra.evaluate import Scope, scalar
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.decide import equal
from rbpsym.equality.verdict import Verdict, undecided
from rbpsym.errors import LimitError, ReadError, Undecided
from rbpsym.notation.tree import Node
from rbpsym.teaching.grading.fractional_powers import equal_with_roots
from rbpsym.teaching.grading.ground import Ground
from rbpsym.teaching.grading.size import is_small

TOO_LARGE = undecided("the answer is too large to be multiplied out")


def are_equal(answer: Node, key: Node, ground: Ground) -> Verdict:
    """PROVED, REFUTED with a witness, or UNDECIDED, wherever both have a value; never by chance or by the clock.

    One point is tried first, since most answers that differ do so there; then algebra; then more points.
    """
    first = ground.sampling.differ(answer, key, most=1)
    if first.is_refuted:
        return first
    is_short = is_small(answer, key)
    found = _by_algebra(answer, key, ground.assumptions, ground.scope) if is_short else TOO_LARGE
    if found.is_proved or found.is_refuted:
        return found
    by_point = ground.sampling.differ(answer, key)
    return by_point if by_point.is_refuted else found


def _by_algebra(answer: Node, key: Node, assumptions: Assumptions, scope: Scope) -> Verdict:
    try:
        found = equal_with_roots(answer, key, assumptions, scope)
        return found or equal(answer, key, assumptions, scope)
    except (ReadError, LimitError, Undecided) as error:
        return undecided(error.what)
    except ZeroDivisionError:
        return undecided("a denominator is identically zero")


def divides_by_zero(answer: Node, ground: Ground) -> bool:
    """Does the formula divide by what is identically zero? (Not asked of what is too large.)"""
    if not is_small(answer):
        return False
    try:
        scalar(answer, ground.scope)
    except ZeroDivisionError:
        return True
    except (LimitError, Undecided, ReadError):
        return False
    return False
