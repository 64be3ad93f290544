"""A bound on work that does not depend on the machine: products of terms, counted as they are made.

What is multiplied out within `at_most(n)` may make n products of terms; beyond, LimitError is
raised. So a method that does not lead to an end is given up, on every machine at the same place.
What is spent `apart` counts for the bound of the whole work only, `in_all(n)`. The bounds belong to the call: another
thread has its own.

Who has another way where the first one grows too long catches LimitError, and what comes of it may be kept for all who
ask later. So the bound of one question, `granted(n)`, ends the work with what nobody catches on the way, and what is
`kept` spends apart from the bounds of who happens to ask first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cached_property, wraps
from math import inf
from typing import Any, Self, TypeVar, TypeVarTuple, overload

from rbpsym.errors import LimitError, WorkSpent

Ts = TypeVarTuple("Ts")
T = TypeVar("T")
COUNTABLE = 10**15
MOST_KEPT = 4096  # results of a function
_left: ContextVar[list[float] | None] = ContextVar("products that are left", default=None)
_whole: ContextVar[list[float] | None] = ContextVar("products that are left of the whole work", default=None)


class _Spent(Exception):
    """Nothing is left of what was granted to a question."""


def spend(products: float) -> None:
    """Counts. Raises LimitError where more is spent than is allowed."""
    left = _left.get()
    if left is not None:
        left[0] -= products
        if left[0] < 0:
            if left[1]:
                raise _Spent
            raise LimitError("the expression grows beyond what can be expanded exactly")


@contextmanager
def at_most(products: int) -> Iterator[list[float]]:
    """Within it, no more products than these (nor than an outer bound leaves); how many are left is the first item given."""
    outer = _left.get()
    most = min(inf if outer is None else outer[0], products)
    own = [most, outer is not None and outer[1] and outer[0] <= products]  # whether it is what was granted that ends it
    token = _left.set(own)
    try:
        yield own
    finally:
        _left.reset(token)
        if outer is not None:
            outer[0] -= most - own[0]


@contextmanager
def in_all(products: int) -> Iterator[list[float]]:
    """As `at_most`, but what is spent `apart` counts, too."""
    with at_most(products) as left:
        token = _whole.set(left)
        try:
            yield left
        finally:
            _whole.reset(token)


@contextmanager
def granted(products: int) -> Iterator[None]:
    """As `in_all`, for one question: what ends by it is given up as a whole. Raises WorkSpent."""
    is_outer = False
    try:
        with in_all(products) as left:
            is_outer, left[1] = bool(left[1]), True
            yield
    except _Spent:
        if is_outer:
            raise
        raise WorkSpent("the work is more than is granted to one question") from None


@contextmanager
def apart() -> Iterator[None]:
    """Within it, what is spent counts for no bound that was set outside but that of the whole work."""
    token = _left.set(_whole.get())
    try:
        yield
    finally:
        _left.reset(token)


def ask_for_more() -> None:
    """Raises LimitError where nothing is left of the whole work."""
    with apart():
        spend(0)


class kept(cached_property[T]):
    """A property that is worked out once, whatever bounds hold for who asks first (but that of the whole work)."""

    @overload
    def __get__(self, instance: None, owner: type[Any] | None = None) -> Self: ...
    @overload
    def __get__(self, instance: object, owner: type[Any] | None = None) -> T: ...
    def __get__(self, instance: Any, owner: type[Any] | None = None) -> Any:
        with apart():
            return super().__get__(instance, owner)


def remembered(function: Callable[[*Ts], T]) -> Callable[[*Ts], T]:
    """A pure function that keeps its results; what it spent is spent again, so that no bound depends on what was asked before."""
    kept: dict[tuple[object, ...], tuple[T, float]] = {}

    @wraps(function)
    def call(*args: *Ts) -> T:
        held = kept.get(args)
        if held is not None:
            spend(held[1])
            return held[0]
        left = _left.get()
        if left is None:
            with at_most(COUNTABLE):
                return call(*args)
        before = left[0]
        found = function(*args)
        if len(kept) >= MOST_KEPT:
            kept.clear()
        if all(bound is None or bound[0] >= 0 for bound in (left, _whole.get())):  # else it was cut short from outside
            kept[args] = found, before - left[0]
        return found

    return call
