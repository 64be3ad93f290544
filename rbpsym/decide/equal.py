"""Whether two formulas are equal: proved by exact algebra, or refuted by a witness.

Order of attack: a non-zero value modulo a prime spares the normal form; the normal form modulo
sin² + cos² = 1 decides everything without roots and functions; `radicals` decides roots,
logarithms and exponentials. PROVED comes from these alone, REFUTED from a point that
satisfies the assumptions, at which both sides are computed rigorously.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
from typing import Protocol

from rbpsym.decide import enclosure
from rbpsym.decide.assumptions import NONE, Assumptions
from rbpsym.decide.constants import is_algebraic
from rbpsym.decide.domain import Condition, conditions, holds_at, obligations, pole
from rbpsym.decide.enclosure import Number
from rbpsym.decide.points import Point, all_atoms, points
from rbpsym.decide.radicals import vanishes
from rbpsym.decide.rooted import rooted
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, Witness, all_of, proved, refuted, undecided
from rbpsym.errors import LimitError, Undecided
from rbpsym.expr.tree import Node
from rbpsym.field import BARE, ONE, Meanings, Scalar, Space, atoms, is_zero, remembered, value
from rbpsym.field.evaluate import vector

PLAIN = frozenset({"symbol", "cos", "sin"})
MOST_INEXACT = 40
FIRST_POINTS, MOST_POINTS = 3, 60


def equal(left: Node, right: Node, assumptions: Assumptions = NONE, scope: Meanings = BARE) -> Verdict:
    """Whether two formulas have the same value wherever both have one.

    Obligations of a proof are the conditions under which they have one (x != 0 for x/x = 1).
    Raises ReadError for a formula without a value or a vector compared with a scalar.
    """
    return _guarded(lambda: _equal(left, right, assumptions, scope))


def _equal(left: Node, right: Node, assumptions: Assumptions, scope: Meanings) -> Verdict:
    a, b = value(left, scope), value(right, scope)
    domain = tuple(dict.fromkeys([*conditions(left, scope), *conditions(right, scope)]))
    if any(one.between is not None for one in domain) and (witness := pole(domain, assumptions)) is not None:
        return refuted("the integrand has a pole between the ends of the integral", witness)
    if isinstance(a, Space) or isinstance(b, Space):
        a, b = vector(left, scope), vector(right, scope)
        pairs = list(zip(a.components(), b.components(), strict=True))
    else:
        pairs = [(a, b)]
    return all_of(_decide(x, y, assumptions, domain) for x, y in pairs)


def scalars_equal(a: Scalar, b: Scalar, assumptions: Assumptions = NONE) -> Verdict:
    """Whether two values are equal under the assumptions."""
    return _guarded(lambda: _decide(a, b, assumptions, ()))


def compare(a: Scalar, b: Scalar, assumptions: Assumptions = NONE, *, strict: bool = True) -> Verdict:
    """Whether a < b (or a <= b) for all quantities that satisfy the assumptions."""
    return _guarded(lambda: _compare(a, b, assumptions, strict, _where.get(), _refuting.get()))


_where: ContextVar[tuple[Condition, ...]] = ContextVar("what is met at a point at which a relation fails", default=())


@contextmanager
def refuted_only_where(met: Iterable[Condition]) -> Iterator[None]:
    """Within it, a relation is refuted by points alone at which the conditions are met."""
    token = _where.set(tuple(met))
    try:
        yield
    finally:
        _where.reset(token)


_refuting: ContextVar[bool] = ContextVar("whether points are looked for at which a relation fails", default=True)


@contextmanager
def proofs_alone() -> Iterator[None]:
    """Within it, a relation that is not proved is UNDECIDED; nobody asks where it fails."""
    token = _refuting.set(False)
    try:
        yield
    finally:
        _refuting.reset(token)


@remembered
def _compare(
    a: Scalar, b: Scalar, assumptions: Assumptions, strict: bool, where: tuple[Condition, ...], refuting: bool
) -> Verdict:
    found = sign(b - a, assumptions)
    if found.kind == "positive" or (not strict and found.is_nonnegative):
        return proved(f"right - left is {found.kind}: {found.certificate}")
    if any(atoms.atom(i).kind == "root" for i in (a - b).atoms()) and all(sign(x, assumptions).is_nonnegative for x in (a, b)):
        found = sign(rooted(b * b - a * a, assumptions), assumptions)
        if found.kind == "positive" or (not strict and found.is_nonnegative):
            return proved(f"the difference of the squares is {found.kind}: {found.certificate}")
    if not refuting:
        return undecided("it is not proved")
    failing = (0, 1) if strict else (1,)
    witness = find_witness(a, b, assumptions, where, lambda x, y: enclosure.sign_of(x - y) in failing)
    if witness is not None:
        return refuted("the relation fails at a point", witness)
    return undecided("the sign of the difference could not be determined")


def _guarded(decide: Callable[[], Verdict]) -> Verdict:
    """The verdict; what cannot be computed is UNDECIDED."""
    try:
        return decide()
    except (LimitError, Undecided) as error:
        return undecided(error.what)
    except ZeroDivisionError:
        return undecided("a denominator is identically zero")


@remembered
def _decide(a: Scalar, b: Scalar, assumptions: Assumptions, domain: tuple[Condition, ...]) -> Verdict:
    if any(x.den is not ONE and is_zero(Scalar(x.den)) for x in (a, b)):
        return undecided("a denominator is identically zero")
    difference = cross_difference(a, b)
    if is_zero(difference):
        return proved("exact normal form", obligations(domain, assumptions))
    kinds = {atoms.atom(index).kind for index in all_atoms([difference])}
    plain = kinds <= PLAIN and not any(map(is_algebraic, all_atoms([difference])))
    how = "" if plain else _with_functions(difference, assumptions, deep=False)
    witness = None if how else find_witness(a, b, assumptions, domain, most=FIRST_POINTS)
    if not how and witness is None and not plain and not all(map(is_algebraic, difference.atoms())):
        how = _with_functions(difference, assumptions, deep=True)
    if how:
        return proved(how, obligations(domain, assumptions))
    witness = witness or find_witness(a, b, assumptions, domain)
    if witness is not None:
        return refuted("the sides differ at a point", witness)
    return undecided("neither a proof nor a point at which the sides differ was found")


def _with_functions(difference: Scalar, assumptions: Assumptions, *, deep: bool) -> str:
    return vanishes(difference, assumptions, deep=deep)


def cross_difference(a: Scalar, b: Scalar) -> Scalar:
    """A polynomial that vanishes exactly where a = b (and both have a value)."""
    if a.den is b.den or a.den == b.den:
        return Scalar(a.num - b.num)
    return Scalar((a.num if b.den is ONE else a.num * b.den) - (b.num if a.den is ONE else b.num * a.den))


class PointsMet(Protocol):
    """Which points are met; `values` are what must have a value there."""

    @property
    def values(self) -> Iterable[Scalar]:
        """Scalars whose names a point of the path has."""

    def holds(self, point: Point) -> bool:
        """Whether the point lies on it."""


def find_witness(
    a: Scalar,
    b: Scalar,
    assumptions: Assumptions,
    domain: Iterable[Condition] = (),
    differ: Callable[[Number, Number], bool] = enclosure.are_disjoint,
    most: int = MOST_POINTS,
    path: PointsMet | None = None,
) -> Witness | None:
    """A point that satisfies the assumptions and at which the sides `differ`; exact ones preferred.

    Where there is a path, the point lies on it.
    """
    domain, first, inexact = list(domain), None, 0
    told = [a, b, *(condition.value for condition in domain), *(path.values if path else ())]
    for point in points(told, assumptions, most):
        if not all(holds_at(condition, point) for condition in domain) or (path and not path.holds(point)):
            continue
        sides = _sides(point, a, b)
        if sides is None:
            continue
        exact = all(isinstance(side, Fraction) for side in sides)
        if differ(*sides):
            first = first or witness_at(point, *sides)
            if exact:
                return witness_at(point, *sides)
        inexact += not exact
        if inexact >= MOST_INEXACT:
            break
    return first


def _sides(point: Point, a: Scalar, b: Scalar) -> tuple[Number, Number] | None:
    try:
        return point.value(a), point.value(b)
    except enclosure.Outside:
        return None


def witness_at(point: Point, left: Number, right: Number) -> Witness:
    """A point with the values of two sides there."""
    circle = tuple((f"{name}/{n}" if (n := point.parts[name]) > 1 else name, *pair) for name, pair in point.angles.items())
    return Witness(tuple(point.numbers.items()), circle, left, right)

